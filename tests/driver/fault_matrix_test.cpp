#include <gtest/gtest.h>

#include "tests/driver/fault_cases.h"
#include "tests/driver/guard_cost.h"
#include "tests/driver/random_faults.h"

namespace isotouch::test {
namespace {

TEST(FaultMatrix, EveryBoundIsKept) {
  const std::vector<FaultRow> rows = fault_matrix();
  int shown = 0;
  for (const FaultRow& row : rows) {
    EXPECT_EQ(row.broken, "") << row.fault;
    EXPECT_LE(row.ticks, kMaxTicks) << row.fault;
    shown += row.ticks >= 0 ? 1 : 0;
  }
  EXPECT_EQ(rows.size(), 46U) << "README.md and docs/safety.md count them by what they lead to; correct both";
  EXPECT_GE(shown, 20);
}

TEST(FaultMatrixHeavy, RandomFaultsBreakNoBoundAndReplay) {
  const RandomRun run = random_faults(400'000, 1);
  EXPECT_EQ(run.broken, "") << describe(run);
  EXPECT_GE(run.ticks, 400'000U);
  EXPECT_GT(run.faults, 1'500U);
  EXPECT_GT(run.with_words, 50'000U) << "else nothing is tested";
  EXPECT_GT(run.shown, 10'000U);
  for (const std::uint64_t ticks : run.in_state) EXPECT_GT(ticks, 100U) << describe(run);
  EXPECT_EQ(random_faults(40'000, 2).chain, random_faults(40'000, 2).chain) << "the same seed, the same run";
  EXPECT_NE(random_faults(40'000, 2).chain, random_faults(40'000, 3).chain);
}

TEST(FaultMatrix, TheGuardIsTimedOnlyBesideForce) {
  const GuardCost cost = guard_cost(50);
  EXPECT_EQ(cost.broken, "");
  EXPECT_EQ(cost.ticks, 50U);
  EXPECT_GT(cost.guard_median_ns, 0.0);
  EXPECT_GE(cost.guard_p999_ns, cost.guard_median_ns);
}

}  // namespace
}  // namespace isotouch::test
