#include "firmware/loop/doorbell.h"

#include <linux/futex.h>
#include <sys/syscall.h>
#include <time.h>  // NOLINT(modernize-deprecated-headers): the system's timespec
#include <unistd.h>

#include "firmware/loop/device.h"

namespace isotouch::loop {

namespace {

constexpr std::int64_t kSecond = 1'000'000'000;

#ifdef SYS_futex_time64
constexpr long kFutex = sizeof(time_t) > sizeof(long) ? SYS_futex_time64 : SYS_futex;
#else
constexpr long kFutex = SYS_futex;
#endif

}  // namespace

void Doorbell::ring() {
  count_.fetch_add(1, std::memory_order_acq_rel);
  syscall(kFutex, &count_, FUTEX_WAKE_PRIVATE, 1, nullptr, nullptr, 0);
}

void Doorbell::wait(std::uint32_t seen, std::int64_t until_ns) {
  if (count() != seen) return;
  timespec until{};
  until.tv_sec = static_cast<decltype(until.tv_sec)>(until_ns / kSecond);
  until.tv_nsec = static_cast<decltype(until.tv_nsec)>(until_ns % kSecond);
  syscall(kFutex, &count_, FUTEX_WAIT_BITSET_PRIVATE, seen, until_ns == kNever ? nullptr : &until, nullptr, FUTEX_BITSET_MATCH_ANY);
}

}  // namespace isotouch::loop
