/// A value that only its owner can change: the program sees it in pages that nobody may write, and the owner writes it through a file descriptor. A stray
/// write of any thread ends the program there, and with it the force.
#pragma once

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <type_traits>

namespace isotouch::guard {

/// tick      no: `put` is a system call. It does not allocate
template <class T>
class PrivateMemory {
  static_assert(std::is_trivially_copyable_v<T>);

 public:
  PrivateMemory() : file_(memfd_create("isotouch-guard", MFD_CLOEXEC)) {
    if (file_ < 0 || !put(T{})) return;
    void* const pages = mmap(nullptr, sizeof(T), PROT_READ, MAP_SHARED | MAP_POPULATE, file_, 0);
    if (pages != MAP_FAILED) value_ = static_cast<const T*>(pages);
  }
  ~PrivateMemory() {
    if (value_ != nullptr) munmap(const_cast<T*>(value_), sizeof(T));
    if (file_ >= 0) close(file_);
  }
  PrivateMemory(const PrivateMemory&) = delete;
  PrivateMemory& operator=(const PrivateMemory&) = delete;

  /// nullptr: the system has no such memory.
  const T* get() const { return value_; }

  /// returns   false: the value is not what it should be
  bool put(const T& value) {
    const bool written = pwrite(file_, &value, sizeof value, 0) == static_cast<ssize_t>(sizeof value);
    return written &&
           (value_ == nullptr || std::equal(begin(value), begin(value) + sizeof value, begin(*value_)));  // else it went to another file
  }

 private:
  static const std::uint8_t* begin(const T& value) { return reinterpret_cast<const std::uint8_t*>(&value); }

  int file_;
  const T* value_ = nullptr;
};

}  // namespace isotouch::guard
