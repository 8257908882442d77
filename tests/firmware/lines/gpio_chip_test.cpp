/// The chip as libgpiod has it, whichever edition is installed. Its functions are those of a fake: no machine of a test has lines.
#include <gtest/gtest.h>

#include <cerrno>

#include "firmware/lines/gpio.h"
#include "tests/firmware/lines/fake_gpiod.h"

namespace isotouch::lines {
namespace {

using test::fake_chip;

/// Where this was built there is no libgpiod.
bool has_gpiod() {
  fake_chip() = {};
  return open_gpio("fakechip") != nullptr;
}

TEST(GpioChip, EveryInputIsPulledDownAndTheOneForTheStopHasBothEdges) {
  if (!has_gpiod()) GTEST_SKIP() << "built without libgpiod";
  for (const bool with_edges : {true, false}) {
    const auto chip = open_gpio("fakechip");
    const auto line = chip->input(3, with_edges);
    ASSERT_NE(line, nullptr);
    EXPECT_FALSE(fake_chip().lines[3].output);
    EXPECT_TRUE(fake_chip().lines[3].pulled_down) << "else a broken wire may be high";
    EXPECT_EQ(fake_chip().lines[3].both_edges, with_edges);
    for (const int level : {0, 1}) {
      fake_chip().lines[3].level = level;
      EXPECT_EQ(line->get(), level);
    }
  }
}

TEST(GpioChip, AnOutputIsLowAtFirstAndTakesWhatItIsSetTo) {
  if (!has_gpiod()) GTEST_SKIP() << "built without libgpiod";
  fake_chip().lines[4].level = 1;
  const auto chip = open_gpio("fakechip");
  chip->input(4, true);  // and given back
  const auto line = chip->output(4);
  ASSERT_NE(line, nullptr);
  EXPECT_TRUE(fake_chip().lines[4].output);
  EXPECT_FALSE(fake_chip().lines[4].pulled_down || fake_chip().lines[4].both_edges) << "of the input that it was";
  EXPECT_EQ(fake_chip().lines[4].level, 0);
  for (const bool high : {true, false}) {
    EXPECT_TRUE(line->set(high));
    EXPECT_EQ(fake_chip().lines[4].level, high ? 1 : 0);
  }
}

TEST(GpioChip, AnEdgeHasTheKernelsTime) {
  if (!has_gpiod()) GTEST_SKIP() << "built without libgpiod";
  const auto chip = open_gpio("fakechip");
  const auto line = chip->input(3, true);
  std::int64_t edge_ns = 7;
  EXPECT_TRUE(line->wait_edge(1'000'000, edge_ns));
  EXPECT_EQ(edge_ns, 7) << "there was none";
  fake_chip().lines[3].edge_ns = 12'000'000'345;
  EXPECT_TRUE(line->wait_edge(1'000'000, edge_ns));
  EXPECT_EQ(edge_ns, 12'000'000'345);
}

TEST(GpioChip, LinesAndChipAreGivenBack) {
  if (!has_gpiod()) GTEST_SKIP() << "built without libgpiod";
  {
    const auto chip = open_gpio("fakechip");
    const auto stop = chip->input(3, true), enable = chip->output(4);
    EXPECT_TRUE(fake_chip().opened && fake_chip().lines[3].held && fake_chip().lines[4].held);
  }
  EXPECT_FALSE(fake_chip().opened || fake_chip().lines[3].held || fake_chip().lines[4].held);
}

}  // namespace
}  // namespace isotouch::lines
