/// What the guard costs for each packet, beside the tick that it judges.
#pragma once

#include <cstdint>
#include <string>

namespace isotouch::test {

struct GuardCost {
  double guard_median_ns = 0, guard_p999_ns = 0;  ///< for a packet: what it hears and what it judges, its checked memory included
  double tick_median_ns = 0, tick_p999_ns = 0;    ///< packet to motor commands, of the same ticks
  std::uint64_t ticks = 0;                        ///< with force
  std::string broken;                             ///< why the figures mean nothing; empty: they do
};

/// Times guard and tick in one run of a hand that presses. Each is timed by itself; what two readings of the clock cost is in both.
///
/// ticks     at least 1
GuardCost guard_cost(std::uint64_t ticks);

std::string describe(const GuardCost& cost);

}  // namespace isotouch::test
