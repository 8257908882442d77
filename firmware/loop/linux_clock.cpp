#include "firmware/loop/linux_clock.h"

#include <time.h>  // NOLINT(modernize-deprecated-headers): clock_nanosleep is POSIX

#include <cerrno>

namespace isotouch::loop {

namespace {
constexpr std::int64_t kSecond = 1'000'000'000;

std::int64_t ns_of(clockid_t clock) {
  timespec now{};
  clock_gettime(clock, &now);
  return std::int64_t{now.tv_sec} * kSecond + now.tv_nsec;
}
}  // namespace

std::int64_t LinuxClock::now_ns() { return ns_of(CLOCK_MONOTONIC); }

std::int64_t LinuxClock::suspended_ns() {
  const std::int64_t with_sleep = ns_of(CLOCK_BOOTTIME);  // first: what passes between the two makes the difference smaller
  return with_sleep - ns_of(CLOCK_MONOTONIC);
}

void LinuxClock::sleep_until_ns(std::int64_t when_ns) {
  timespec when{};
  when.tv_sec = static_cast<decltype(when.tv_sec)>(when_ns / kSecond);
  when.tv_nsec = static_cast<decltype(when.tv_nsec)>(when_ns % kSecond);
  while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &when, nullptr) == EINTR) {
  }
}

}  // namespace isotouch::loop
