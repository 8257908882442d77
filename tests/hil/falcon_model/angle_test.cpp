#include "hil/falcon_model/angle.h"
#include "tests/support/accuracy.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace isotouch::falcon_model {
namespace {

TEST(Angle, SineAndCosineAreTheLibrarys) {
  double worst = 0;
  for (int i = -40000; i <= 40000; ++i) {
    const double angle = i * 0.00025 + i % 7 * 1e-9;
    worst = std::max({worst, std::abs(sine(angle) - std::sin(angle)), std::abs(cosine(angle) - std::cos(angle))});
  }
  EXPECT_THAT(worst, test::IsAccuracyOf(1.5e-16));
  EXPECT_EQ(sine(0), 0);
  EXPECT_EQ(cosine(0), 1);
}

TEST(Angle, ArcTangentIsTheLibrarysInEveryDirection) {
  double worst = 0;
  for (int i = -20000; i < 20000; ++i) {
    const double angle = kPi * (i + 0.5) / 20000;
    const double x = 3 * std::cos(angle), y = 3 * std::sin(angle);
    worst = std::max(worst, std::abs(arc_tangent(y, x) - std::atan2(y, x)));
  }
  EXPECT_THAT(worst, test::IsAccuracyOf(6e-16));  // the library's half unit in the last place beside ours
}

TEST(Angle, AxesAreExact) {
  EXPECT_EQ(arc_tangent(0, 1), 0);
  EXPECT_EQ(arc_tangent(1, 0), kPi / 2);
  EXPECT_EQ(arc_tangent(-1, 0), -kPi / 2);
  EXPECT_EQ(arc_tangent(0, -1), kPi);
  EXPECT_EQ(arc_tangent(0, 0), 0);
}

}  // namespace
}  // namespace isotouch::falcon_model
