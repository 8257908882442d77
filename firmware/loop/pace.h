/// Who clocks whom: the tick follows the device where the device keeps time, and its own clock where it does not, so that two free clocks never beat.
/// Pure arithmetic on times; nobody waits here.
///
///   a reply that comes around the expected moment e starts its tick at once, and draws e along by at most a 64th of a period a tick
///   a reply that is early by up to half a period waits until e less that 64th: after one late reply the phase comes back
///   a reply that is earlier belongs to a device faster than the tick: the tick begins at e, by its own clock
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
    if (arrival_ns < expected_ - period_ / 2) return expected_;
    const std::int64_t earliest = expected_ - period_ / kPull;
    return arrival_ns < earliest ? earliest : arrival_ns;
  }

  /// Notes that a tick has begun, and moves on to the next one.
  ///
  /// start_ns    when it should have begun: `start_ns(arrival)`, or `due_ns()` without a reply
  /// replied     a reply started it
  /// now_ns      when it began
  /// returns     whole periods by which it is late: so many ticks are left out
  std::uint32_t begin(std::int64_t start_ns, bool replied, std::int64_t now_ns) {
    if (replied) {
      const std::int64_t off = start_ns - expected_, most = period_ / kPull;
      expected_ += off > most ? most : off < -most ? -most : off;
    }
    const std::int64_t behind = now_ns > expected_ ? (now_ns - expected_) / period_ : 0;
    expected_ += (behind + 1) * period_;
    return behind > kMost ? kMost : static_cast<std::uint32_t>(behind);
  }

 private:
  static constexpr std::int64_t kPull = 64;
  static constexpr std::uint32_t kMost = 1'000'000'000;

  std::int64_t period_;
  std::int64_t expected_;
};

}  // namespace isotouch::loop
