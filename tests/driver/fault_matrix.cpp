/// Prints the fault matrix, runs random faults, flips random bits, or times the guard.
///
///     fault_matrix [random TICKS [SEED] | flips FLIPS [SEED] | guard TICKS]
///
/// Exit codes: 0 every bound was kept, 2 wrong usage, 3 one was broken.
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "tests/driver/bit_flips.h"
#include "tests/driver/fault_cases.h"
#include "tests/driver/guard_cost.h"
#include "tests/driver/random_faults.h"

namespace {

using namespace isotouch::test;

int print_matrix() {
  int broken = 0, rows = 0;
  std::int64_t largest = 0;
  std::printf("%-50s %5s  %-7s %-36s %s\n", "fault", "ticks", "state", "recovery", "what the user reads");
  for (const FaultRow& row : fault_matrix()) {
    ++rows;
    largest = std::max(largest, std::int64_t{row.ticks});
    const std::string ticks = row.ticks < 0 ? "-" : std::to_string(row.ticks);
    std::printf("%-50s %5s  %-7s %-36s %s\n", row.fault.c_str(), ticks.c_str(), row.state.c_str(), row.recovery.c_str(),
                row.sentence.c_str());
    if (row.broken.empty()) continue;
    ++broken;
    std::printf("    BROKEN: %s\n", row.broken.c_str());
  }
  std::printf(
      "%d faults, %d bounds broken, at most %lld ticks until no force is commanded, %d are allowed. The ticks are counted from the first\n"
      "whose input shows the fault (stale: no fresh sample for 3 ticks) to motor commands of zero at the device's seam; - where no input\n"
      "shows it. While the link is down, the device's own time limit ends the force. For a broken core they are the\n"
      "packets with force after a correct core gives none; - where the guard allows more than the core.\n",
      rows, broken, static_cast<long long>(largest), kMaxTicks);
  return broken == 0 ? 0 : 3;
}

int run_random(std::uint64_t ticks, std::uint64_t seed) {
  const RandomRun run = random_faults(ticks, seed);
  std::printf("%s\n", describe(run).c_str());
  return run.broken.empty() ? 0 : 3;
}

int run_flips(int flips, std::uint64_t seed) {
  const FlipRun run = bit_flips(flips, seed);
  std::printf("%s", describe(run).c_str());
  return run.broken.empty() && run.all.escaped == 0 ? 0 : 3;
}

int time_guard(std::uint64_t ticks) {
  const GuardCost cost = guard_cost(ticks);
  std::printf("%s\n", describe(cost).c_str());
  return cost.broken.empty() ? 0 : 3;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc == 1) return print_matrix();
  const std::string what = argv[1];
  const std::uint64_t number = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 0,
                      seed = argc > 3 ? std::strtoull(argv[3], nullptr, 10) : 1;
  if (what == "random" && number > 0 && argc <= 4) return run_random(number, seed);
  if (what == "flips" && number > 0 && number <= 1'000'000'000 && argc <= 4) return run_flips(static_cast<int>(number), seed);
  if (what == "guard" && number > 0 && argc == 3) return time_guard(number);
  std::fprintf(stderr, "usage: fault_matrix [random TICKS [SEED] | flips FLIPS [SEED] | guard TICKS]\n");
  return 2;
}
