#include "host/qualify/measure.h"

#include <gtest/gtest.h>

#include <optional>
#include <string>

namespace isotouch::qualify {
namespace {

/// What is read of a board whose tick is scheduled so.
BoardFiles board_with_tick(int priority, int policy) {
  BoardFiles files;
  std::string stat = "12 (tick) S";
  for (int field = 4; field < 40; ++field) stat += " 0";
  files.texts["thread/tick/stat"] = stat + " " + std::to_string(priority) + " " + std::to_string(policy) + " 0 0";
  return files;
}

TEST(TimerPriority, IsTheTicksOwnUnlessOneIsGiven) {
  EXPECT_EQ(timer_priority(std::nullopt, board_with_tick(55, 1)), 55);
  EXPECT_EQ(timer_priority(70, board_with_tick(55, 1)), 70);
  EXPECT_EQ(timer_priority(0, board_with_tick(55, 1)), 0) << "0 is no priority but a wish";
}

TEST(TimerPriority, Is80WhereTheTickHasNone) {
  EXPECT_EQ(timer_priority(std::nullopt, board_with_tick(0, 0)), 80);
  EXPECT_EQ(timer_priority(std::nullopt, BoardFiles{}), 80);
}

}  // namespace
}  // namespace isotouch::qualify
