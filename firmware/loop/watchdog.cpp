#include "firmware/loop/watchdog.h"

#include <algorithm>

namespace isotouch::loop {

namespace {

constexpr std::int64_t kBlinkNs = 250'000'000;

bool may_have_power(SupervisorState state) {
  return state == SupervisorState::kReady || state == SupervisorState::kActive || state == SupervisorState::kHold;
}

}  // namespace

Watchdog::Watchdog(const WatchdogSettings& settings, SafetyLines& lines, Clock& clock, LineState& state, const Counter& ticks)
    : settings_(settings), lines_(lines), clock_(clock), state_(state), ticks_(ticks) {
  next_ns_ = ticked_ns_ = agreed_ns_ = clock.now_ns();
  seen_ = ticks.value();
}

void Watchdog::step() {
  const std::int64_t begin = clock_.now_ns();  // before its time, where an edge ended the last wait
  next_ns_ = std::clamp(next_ns_ + settings_.step_ns, begin, begin + settings_.step_ns);
  lines_.wait(next_ns_);
  const std::int64_t now = clock_.now_ns();
  const std::uint64_t ticks = ticks_.value();
  if (ticks != seen_) ticked_ns_ = now;
  ticks_come_ = ticks > 0 && now - ticked_ns_ <= settings_.silent_ns;
  seen_ = ticks;

  const SupervisorState state = state_.told();
  const LineInputs in = lines_.read();
  const bool stop = in.stop || in.stop_edge_ns != stop_edge_ns_;  // pressed for less than a step, too
  stop_edge_ns_ = in.stop_edge_ns;
  unsigned told = (stop ? unsigned{kLineStop} : 0U) | (reads_wrong(in.enabled, now) ? unsigned{kLineEnableWrong} : 0U);
  if (state != SupervisorState::kFault) told |= told_;  // until the supervisor has heard of it
  told_ = static_cast<std::uint8_t>(told);
  state_.put(told_);

  LineOutputs out;
  out.enable = ticks_come_ && told == 0 && may_have_power(state);
  out.heartbeat = set_.heartbeat != ticks_come_;
  out.light = state == SupervisorState::kActive || (state == SupervisorState::kFault && now / kBlinkNs % 2 == 0);
  lines_.set(set_ = out);
}

void Watchdog::leave() { lines_.set(set_ = {}); }

bool Watchdog::reads_wrong(bool enabled, std::int64_t now) {
  if (enabled == set_.enable) agreed_ns_ = now;
  return now - agreed_ns_ > settings_.settle_ns;
}

}  // namespace isotouch::loop
