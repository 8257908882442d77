#include "firmware/loop/latency_request.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>

namespace isotouch::loop {

namespace {

constexpr std::int32_t kWakeUpUs = 0;  // the kernel reads a number of this size, in its own order of bytes

/// returns   the open file with the request in it, or -1 and errno
int ask(const char* path) {
  const int file = ::open(path, O_WRONLY | O_CLOEXEC | O_NONBLOCK);  // a pipe without a reader must not hold the program up
  if (file < 0) return -1;
  struct stat what {};
  const bool looked = ::fstat(file, &what) == 0;
  const bool is_device = S_ISCHR(what.st_mode);  // nothing is written into somebody's file
  if (looked && is_device && ::write(file, &kWakeUpUs, sizeof kWakeUpUs) == sizeof kWakeUpUs) return file;
  const int error = looked && !is_device ? ENOTTY : errno;
  ::close(file);
  errno = error;
  return -1;
}

}  // namespace

int LatencyRequest::hold(bool wanted) {
  if (!wanted) {
    if (file_ >= 0) ::close(file_);
    file_ = -1, refused_ = 0;
  } else if (file_ < 0 && refused_ == 0 && !path_.empty()) {
    file_ = ask(path_.c_str());
    if (file_ < 0) refused_ = errno;
  }
  return refused_;
}

}  // namespace isotouch::loop
