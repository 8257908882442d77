#include "hil/falcon_model/hand.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace isotouch::falcon_model {
namespace {

TEST(Hand, NobodyPushesNothing) {
  Hand hand({}, {});
  hand.advance(1, {0, 0, 110}, true);
  EXPECT_EQ(hand.force_n({0, 0, 150}, {10, 0, 0}), Vector{});
}

TEST(Hand, PullsFullyOutAndPushesFullyInUntilHomed) {
  Hand hand({}, scripted_path("rest"));
  double least = 200, most = 0;
  for (int ms = 0; ms < 4000; ++ms) {
    hand.advance(1, {0, 0, 110}, false);
    least = std::min(least, hand.target_mm()->z);
    most = std::max(most, hand.target_mm()->z);
  }
  EXPECT_NEAR(least, 76, 0.01);
  EXPECT_NEAR(most, 178, 0.01);
}

TEST(Hand, NeverJumpsFromOnePhaseToTheNext) {
  Hand hand({}, scripted_path("press"));
  Vector last{0, 0, 110};
  for (int ms = 0; ms < 9000; ++ms) {
    const bool homed = ms > 1500 && (ms < 5000 || ms > 6300);
    hand.advance(1, last, homed);
    EXPECT_LT(length(*hand.target_mm() - last), 0.35) << ms;  // mm in a ms
    last = *hand.target_mm();
  }
  EXPECT_TRUE(hand.follows_path());
}

TEST(Hand, IsASpringWithADamperAndALimit) {
  Hand hand({}, scripted_path("rest"));
  for (int ms = 0; ms < 1000; ++ms) hand.advance(1, {0, 0, 125}, true);
  ASSERT_TRUE(hand.follows_path());
  EXPECT_LT(length(hand.force_n({2, 0, 125}, {0, 100, 0}) - Vector{-1, -0.5, 0}), 1e-12);
  EXPECT_NEAR(length(hand.force_n({0, 80, 125}, {})), 25, 1e-12);
}

}  // namespace
}  // namespace isotouch::falcon_model
