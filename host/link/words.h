/// What a controller's numbers are for people.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "shared/fault_names.h"
#include "shared/protocol_messages.h"

namespace isotouch::link {

/// The program that a person uses: `isotouch`, or on a board `isotouchctl`. Set once, before anything is said.
inline std::string& tool_name() {
  static std::string name = "isotouch";
  return name;
}

/// What a controller measures, in the order of protocol::Measure: names, and what a unit is for people.
struct MeasureName {
  const char* key;
  const char* text;
  bool in_ticks;  ///< else in microseconds
};
inline constexpr std::array<MeasureName, protocol::kMeasures> kMeasureNames = {{
    {"wakeup_us", "wake-up", false},
    {"tick_us", "tick", false},
    {"round_trip_us", "round trip", false},
    {"delay_ticks", "sensor to motor", true},
}};

/// The names of Faults.
inline std::vector<std::string> fault_names(std::uint16_t faults) {
  std::vector<std::string> names;
  unsigned known = 0;
  for (const FaultName& fault : kFaultNames) {
    if ((faults & fault.fault) != 0) names.emplace_back(fault.name);
    known |= fault.fault;
  }
  if ((faults & ~known) != 0) names.emplace_back("unknown");
  return names;
}

/// An angle of 2^32 to the turn, -180 to 180 degrees.
inline double degrees_of(std::uint32_t angle) { return std::ldexp(static_cast<std::int32_t>(angle), -32) * 360; }

/// ns → the unit of a measure.
inline double in_unit(const MeasureName& measure, std::uint32_t ns, std::uint32_t period_ns) {
  return measure.in_ticks ? static_cast<double>(ns) / std::max(period_ns, std::uint32_t{1}) : static_cast<double>(ns) / 1000.0;
}

}  // namespace isotouch::link
