/// Random bits of the running controller flip, one a run: does force come out that an undamaged controller would not have given, and for how long?
///
/// Beside each damaged run an undamaged core of its own, with a field of its own, computes from the same packets what it would have said. *Extra force* is
/// what the simulated device's motors do beyond that: the distance, as a force on the hand, between their commands and the nearest weaker form of what the
/// undamaged core said in this tick or the one before. So a force that is missing, or fades, is no extra force. In a hold, in a fault and without contact all force is extra.
/// A flip escapes if more than kMaxExtra of it lasts for longer than kMaxTicks ticks in a row.
///
/// Every run is a process of its own, so a pointer that leads nowhere ends one run. In the real controller its crash handler ends the force then.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace isotouch::test {

/// What the controller was doing when the bit flipped.
enum class FlipState : std::uint8_t { kContact, kFree, kHold, kFault };
inline constexpr std::size_t kFlipStates = 4;

inline constexpr double kMaxExtra = 0.1;  ///< N; three counts of depth at the stiffness of the runs

/// All runs with one place and one state.
struct FlipCell {
  int flips = 0;
  int unseen = 0;   ///< nothing differed
  int noticed = 0;  ///< the force ended: by a fault, a hold, the guard, or the program's end
  int escaped = 0;
  int noticed_late = 0;     ///< ticks from the flip, the largest
  int longest = 0;          ///< ticks with extra force in a row
  double newton = 0;        ///< the largest extra force
  std::array<int, 5> by{};  ///< those noticed: by memory check, guard, state codes, another fault or hold, the program's end

  void add(const FlipCell& other);
};

struct FlipRow {
  std::string place;
  std::array<FlipCell, kFlipStates> cells;
};

struct FlipRun {
  std::vector<FlipRow> rows;
  FlipCell all;
  std::vector<std::string> worst;  ///< a line for each flip that escaped
  std::vector<std::string> hung;   ///< a line for each run whose tick did not end: on a board the exchange thread then ends the force
  std::string broken;              ///< why the runs prove nothing; empty: they do
};

/// seed      the same seed gives the same flips
FlipRun bit_flips(int flips, std::uint64_t seed);

std::string describe(const FlipRun& run);

}  // namespace isotouch::test
