#include "firmware/loop/linux_clock.h"

#include <time.h>  // NOLINT(modernize-deprecated-headers): clock_nanosleep is POSIX

#include <cerrno>

namespace isotouch::loop {

namespace {
constexpr std::int64_t kSecond = 1'000'000'000;
}

std::int64_t LinuxClock::now_ns() {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return std::int64_t{now.tv_sec} * kSecond + now.tv_nsec;
}

void LinuxClock::sleep_until_ns(std::int64_t when_ns) {
  timespec when{};
  when.tv_sec = static_cast<decltype(when.tv_sec)>(when_ns / kSecond);
  when.tv_nsec = static_cast<decltype(when.tv_nsec)>(when_ns % kSecond);
  while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &when, nullptr) == EINTR) {
  }
}

}  // namespace isotouch::loop
