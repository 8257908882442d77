/// How a build's time and memory grow with points and with the grid.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "host/commands/progress_bar.h"

namespace isotouch::commands {

/// One cloud on one grid: the build whose time is the median of kGrowthRuns, each in a process of its own.
struct GrowthRow {
  std::size_t points = 0;
  int grid = 0;  ///< samples along each axis
  double seconds = 0;
  double cpu_seconds = 0;        ///< of all threads
  std::uint64_t peak_bytes = 0;  ///< of the process
  std::size_t image_bytes = 0;
  std::size_t stored_samples = 0;                      ///< 64 a brick
  std::vector<std::pair<std::string, double>> stages;  ///< seconds

  double nanoseconds_per_sample() const { return 1e9 * seconds / static_cast<double>(stored_samples); }
};

struct Growth {
  std::vector<GrowthRow> points;  ///< 4,000, 40,000 and 400,000 on the default grid
  std::vector<GrowthRow> grids;   ///< 4,000 points on 128, 256, 512 and 1024 samples a side
};

inline constexpr int kGrowthRuns = 3;

/// Points on a sphere, which has the most surface in its cube, from a cloud's file to a field's.
///
/// quick     the first cloud and the first grid alone, one build each
/// fails     InputError when the temporary folder cannot be written or a build does not end
Growth measure_growth(ProgressBar& bar, bool quick);

}  // namespace isotouch::commands
