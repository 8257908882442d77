/// One thread tells another that there is something new. No lock: a counter, and the system's futex to sleep on it.
///
/// tick      yes: `ring` is a system call that does not block; `wait` is the tick's one documented wait
#pragma once

#include <atomic>
#include <cstdint>

namespace isotouch::loop {

class Doorbell {
  static_assert(std::atomic<std::uint32_t>::is_always_lock_free && sizeof(std::atomic<std::uint32_t>) == 4);

 public:
  void ring();

  /// How often it was rung, modulo 2^32.
  std::uint32_t count() const { return count_.load(std::memory_order_acquire); }

  /// Returns when the count is another than `seen`, or at `until_ns` of CLOCK_MONOTONIC; kNever: no limit. May return early.
  void wait(std::uint32_t seen, std::int64_t until_ns);

 private:
  std::atomic<std::uint32_t> count_{0};
};

}  // namespace isotouch::loop
