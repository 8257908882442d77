#include "firmware/control/worst_ticks.h"

#include <utility>

namespace isotouch::control {

namespace {

std::uint64_t lateness_ns(const protocol::WorstTick& tick) { return std::uint64_t{tick.wake_ns} + tick.tick_ns; }

}  // namespace

void WorstTicks::take(const loop::TickRecord& tick) {
  ++seen_;
  const protocol::WorstTick late{tick.number, tick.start_ns, tick.wake_ns, tick.tick_ns};
  if (count_ == kMax && lateness_ns(ticks_[kMax - 1]) >= lateness_ns(late)) return;
  std::size_t at = count_ < kMax ? count_++ : kMax - 1;
  ticks_[at] = late;
  for (; at > 0 && lateness_ns(ticks_[at - 1]) < lateness_ns(ticks_[at]); --at) std::swap(ticks_[at - 1], ticks_[at]);
}

}  // namespace isotouch::control
