/// A disk that is full where the test wants it: files of this process end at so many bytes, as long as this lives. What is before the end is taken, so
/// that a write may be cut in the middle; unlike /dev/full, what was taken is there.
#pragma once

#include <sys/resource.h>

#include <csignal>
#include <cstdint>

namespace isotouch {

class FullDisk {
 public:
  /// bytes     of each file; what the test prints is a file, too, so let it print later
  explicit FullDisk(std::uint64_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    getrlimit(RLIMIT_FSIZE, &before_);
    rlimit now = before_;
    now.rlim_cur = static_cast<rlim_t>(bytes);
    setrlimit(RLIMIT_FSIZE, &now);
  }
  FullDisk(const FullDisk&) = delete;
  FullDisk& operator=(const FullDisk&) = delete;
  ~FullDisk() {
    setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }

 private:
  rlimit before_{};
  void (*handler_)(int);
};

}  // namespace isotouch
