/// Looks for a wall that the proxy passes, with both interpolations.
///
///     wall_trials TICKS [SEED [THICKNESS]]
///
/// THICKNESS of every plate and shell, voxels; unless given, each body has its own, 2 to 6.
///
/// Exit codes: 0 none was passed, 2 wrong usage, 3 one was.
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <utility>

#include "tests/integration/wall_trials.h"

int main(int argc, char** argv) {
  using namespace isotouch;
  const std::uint64_t ticks = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 0;
  if (ticks == 0 || argc > 4) {
    std::fprintf(stderr, "usage: wall_trials TICKS [SEED [THICKNESS]]\n");
    return 2;
  }
  const std::uint64_t seed = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1;
  test::WallOptions options;
  if (argc > 3) options.thinnest = options.thickest = std::strtod(argv[3], nullptr);
  bool passed = false;
  for (const auto& [name, interpolation] : {std::pair{"spline", Interpolation::kSpline}, {"trilinear", Interpolation::kTrilinear}}) {
    options.interpolation = interpolation;
    const test::WallRun run = test::wall_trials(ticks, seed, options);
    std::printf("%-10s %s\n", name, describe(run).c_str());
    std::fflush(stdout);
    passed = passed || run.passed > 0;
  }
  return passed ? 3 : 0;
}
