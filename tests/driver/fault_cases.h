/// The fault matrix: every fault that is ordered, what it does to a hand that presses, and whether the bound is kept.
#pragma once

#include <string>
#include <vector>

namespace isotouch::test {

struct FaultRow {
  std::string fault;
  int ticks =
      -1;  ///< from the first tick whose input shows the condition to motor commands of zero at the device's seam; -1 = no input shows it
  std::string state;     ///< that it came to
  std::string sentence;  ///< what the user reads
  std::string recovery;
  std::string broken;  ///< which promise was; empty: none
};

inline constexpr int kMaxTicks = 3;

/// Runs all of them, in a time of their own; the same rows every time.
std::vector<FaultRow> fault_matrix();

}  // namespace isotouch::test
