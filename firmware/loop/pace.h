/// Decides when a tick begins: at the reply of the device as long as the device keeps time, else by the tick's own clock. Two free clocks would drift
/// against each other. Pure arithmetic on times; nothing here waits.
///
///   a reply that comes around the expected moment e starts its tick at once, and draws e along by at most a 64th of a period a tick
///   a reply that is early by up to half a period waits until e less that 64th: after one late reply the phase comes back
///   a reply that is earlier is one of a device faster than the tick, or came just too late for the tick before: the tick begins at e, by its own
///   clock, which lags by a 512th, so that a device of the tick's own rate is met again within some hundred ticks
///   no reply by e and a quarter: the tick begins there, with a stale sample, and e stays on its grid
#pragma once

#include <cstdint>

namespace isotouch::loop {

class Pace {
 public:
  /// period_ns     of the tick
  /// now_ns        the first tick is expected one period later
  Pace(std::int64_t period_ns, std::int64_t now_ns) : period_(period_ns), expected_(now_ns + period_ns) {}

  /// Until when a reply is waited for: the tick's due time.
  std::int64_t due_ns() const { return expected_ + period_ / 4; }

  /// When a tick should begin, whose reply arrived at that time. May lie in the future: then it sleeps until there.
  std::int64_t start_ns(std::int64_t arrival_ns) const {
    if (too_early(arrival_ns)) return expected_;
    const std::int64_t earliest = expected_ - period_ / kPull;
    return arrival_ns < earliest ? earliest : arrival_ns;
  }

  /// A clock that was set back leaves the next tick's time far ahead: it comes a period from now instead.
  void stay_near(std::int64_t now_ns) {
    if (expected_ > now_ns + 2 * period_) expected_ = now_ns + period_;
  }

  /// Notes that a tick has begun, and moves on to the next one.
  ///
  /// arrival_ns  of the reply that it began with; kNoReply: it began because it was due
  /// now_ns      when it began
  /// returns     whole periods by which it is late: so many ticks are left out
  std::uint32_t begin(std::int64_t arrival_ns, std::int64_t now_ns) {
    if (arrival_ns != kNoReply) {
      const std::int64_t off = start_ns(arrival_ns) - expected_, most = period_ / kPull;
      expected_ += too_early(arrival_ns) ? period_ / kLag : off > most ? most : off;
    }
    const std::int64_t behind = now_ns > expected_ ? (now_ns - expected_) / period_ : 0;
    expected_ += (behind + 1) * period_;
    return behind > kMax ? kMax : static_cast<std::uint32_t>(behind);
  }

  static constexpr std::int64_t kNoReply = -1;
  static constexpr std::uint32_t kMax = 1'000'000'000;  ///< periods that `begin` tells of

 private:
  static constexpr std::int64_t kPull = 64, kLag = 512;

  bool too_early(std::int64_t arrival_ns) const { return arrival_ns < expected_ - period_ / 2; }

  std::int64_t period_;
  std::int64_t expected_;
};

}  // namespace isotouch::loop
