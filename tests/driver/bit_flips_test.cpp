#include "tests/driver/bit_flips.h"

#include <gtest/gtest.h>

namespace isotouch::test {
namespace {

TEST(BitFlipsHeavy, NoForceThatAnUndamagedRunWouldNotHaveGiven) {
  const FlipRun run = bit_flips(1500, 7);
  EXPECT_EQ(run.broken, "");
  EXPECT_EQ(run.all.escaped, 0) << describe(run);
  EXPECT_LE(run.hung.size(), 3U) << describe(run);
  EXPECT_GT(run.all.noticed, 1000) << "else nothing flips";
  EXPECT_GE(run.rows.size(), 35U);
  constexpr int kWaitsForAPacket = 3;  // in hold: packets are missing, and the guard looks when the next command is sent
  for (const FlipRow& row : run.rows) {
    for (std::size_t state = 0; state < kFlipStates; ++state) {
      const FlipCell& cell = row.cells[state];
      if (row.place.rfind("state", 0) == 0 || row.place.rfind("model", 0) == 0 || row.place == "guard: memory") {
        EXPECT_EQ(cell.noticed, cell.flips) << row.place;
        const bool waits = row.place == "guard: memory" && state == static_cast<std::size_t>(FlipState::kHold);
        EXPECT_LE(cell.noticed_late, waits ? kWaitsForAPacket : 1) << row.place << " in state " << state;
      }
      if (row.place.rfind("field: bricks", 0) == 0) {
        EXPECT_EQ(cell.noticed, cell.flips) << row.place;
        EXPECT_LE(cell.noticed_late, 2100) << row.place;
      }
    }
  }
}

TEST(BitFlips, TheSameSeedGivesTheSameFlips) {
  const FlipRun run = bit_flips(40, 3), again = bit_flips(40, 3);
  EXPECT_EQ(run.broken, "");
  EXPECT_EQ(run.all.flips, 40);
  for (std::size_t i = 0; i < run.rows.size(); ++i) {
    for (std::size_t s = 0; s < kFlipStates; ++s) EXPECT_EQ(run.rows[i].cells[s].flips, again.rows[i].cells[s].flips);
  }
}

}  // namespace
}  // namespace isotouch::test
