/// All of some bytes into an open file, a pipe or a socket.
///
/// tick      no: it waits for whoever takes them
#pragma once

#include <unistd.h>

#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <span>

namespace isotouch::files {

/// Goes on after a signal and after a part.
///
/// returns   false: not all was taken, and errno says why
inline bool write_all(int file, std::span<const std::uint8_t> bytes) {
  while (!bytes.empty()) {
    const ssize_t taken = ::write(file, bytes.data(), bytes.size());
    if (taken < 0 && errno == EINTR) continue;
    if (taken == 0) errno = ENOSPC;
    if (taken <= 0) return false;
    bytes = bytes.subspan(static_cast<std::size_t>(taken));
  }
  return true;
}

}  // namespace isotouch::files
