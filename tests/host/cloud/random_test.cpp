#include "host/cloud/random.h"

#include <gtest/gtest.h>

namespace isotouch::cloud {
namespace {

TEST(Random, GivesThePublishedSequenceOfSplitmix64) {  // seed 1234567, as in the generator's reference output
  Random random(1234567);
  EXPECT_EQ(random.bits(), 6457827717110365317ULL);
  EXPECT_EQ(random.bits(), 3203168211198807973ULL);
  EXPECT_EQ(random.bits(), 9817491932198370423ULL);
}

TEST(Random, FillsTheUnitIntervalEvenly) {
  Random random(7);
  double sum = 0.0;
  double sum_of_squares = 0.0;
  constexpr int kDraws = 100000;
  for (int i = 0; i < kDraws; ++i) {
    const double value = random.uniform();
    ASSERT_GE(value, 0.0);
    ASSERT_LT(value, 1.0);
    sum += value;
    sum_of_squares += value * value;
  }
  EXPECT_NEAR(sum / kDraws, 1.0 / 2.0, 0.004);  // 4 standard errors
  EXPECT_NEAR(sum_of_squares / kDraws, 1.0 / 3.0, 0.004);
}

}  // namespace
}  // namespace isotouch::cloud
