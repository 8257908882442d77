/// Cores that are broken on purpose, as the guard sees them.
#pragma once

#include <algorithm>
#include <functional>
#include <memory>
#include <vector>

#include "tests/driver/fault_bench.h"
#include "tests/driver/fault_cases.h"

namespace isotouch::test {

/// A straight movement.
struct Way {
  falcon_model::Vector by{};
  double ms_long = 1;
};

/// Presses, and once it is told to, moves.
struct Move {
  Way way;
  std::shared_ptr<double> began = std::make_shared<double>(-1);  ///< ms; -1: not told, 0: told

  falcon_model::Vector operator()(double ms) const {
    if (*began == 0) *began = ms;
    falcon_model::Vector at = pressing_hand()(*began < 0 ? ms : std::max(ms, 2000.0));
    const double part = *began < 0 ? 0.0 : std::clamp((ms - *began) / way.ms_long, 0.0, 1.0);
    at.x += part * way.by.x, at.y += part * way.by.y, at.z += part * way.by.z;
    return at;
  }
  void go() const { *began = 0; }
};

/// Multiplies the motor commands by a factor.
void times(double factor, loop::Command& command);

bool has_force(const FaultBench& bench);

/// A row for each broken core: `ticks` counts the packets with force after the sound core says zero, -1 where the guard allows a part more than the core.
std::vector<FaultRow> broken_cores();

}  // namespace isotouch::test
