/// The time of a driver whose device answers at once. Each look at the clock moves it on, so that the driver depends on the replies alone. Sleeping jumps
/// ahead and yields the processor for a moment.
#pragma once

#include "firmware/loop/linux_clock.h"

namespace isotouch::loop {

class LockstepClock final : public loop::Clock {
 public:
  std::int64_t now_ns() override { return now_ += kLookNs; }

  void sleep_until_ns(std::int64_t when_ns) override {
    if (when_ns <= now_) return;
    now_ = when_ns;
    real_.sleep_until_ns(real_.now_ns() + kNapNs);
  }

 private:
  static constexpr std::int64_t kLookNs = 20'000, kNapNs = 1'000'000;

  LinuxClock real_;
  std::int64_t now_ = 0;
};

}  // namespace isotouch::loop
