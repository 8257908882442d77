/// How long it takes from a cloud's file to a verified field's file, by both methods.
#pragma once

#include <string>
#include <vector>

#include "host/commands/progress_bar.h"

namespace isotouch::commands {

struct FieldTimes {
  std::string name;
  std::size_t points = 0;
  double seconds = 0;            ///< default method, median of kFieldRuns
  double published_seconds = 0;  ///< published method, once
};

inline constexpr int kFieldRuns = 5;

/// The five objects at their point counts on the default grid, one after the other on this machine.
///
/// fails     InputError when the temporary folder cannot be written
std::vector<FieldTimes> time_fields(ProgressBar& bar);

}  // namespace isotouch::commands
