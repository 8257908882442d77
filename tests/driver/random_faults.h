/// Random faults, many at once, for as long as one likes: is the bound kept every time, does anything allocate or leak, and does what was recorded
/// replay to the bit?
#pragma once

#include <array>
#include <cstdint>
#include <string>

namespace isotouch::test {

struct RandomRun {
  std::uint64_t ticks = 0, faults = 0, settings = 0;  ///< settings: changed on the way
  std::array<std::uint64_t, 7> in_state{};
  std::uint64_t with_words = 0;
  std::uint64_t shown = 0;                  ///< ticks whose input shows a fault, and that must rest
  std::uint64_t allocations = 0;            ///< in ticks
  std::uint64_t allocations_of_driver = 0;  ///< it may; 0 in a program that does not count
  std::int64_t leaked_bytes = 0;            ///< on the heap, from the first tenth to the end
  std::uint64_t chain = 0;                  ///< of the run
  std::string broken;                       ///< the first promise that was not kept, with its tick; empty: all were
};

/// ticks     as many at least; made of runs of 20,000, each with a hand and faults of its own
/// seed      the same seed gives the same run
RandomRun random_faults(std::uint64_t ticks, std::uint64_t seed);

std::string describe(const RandomRun& run);

}  // namespace isotouch::test
