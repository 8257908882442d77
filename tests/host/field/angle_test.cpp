#include "host/field/angle.h"
#include "tests/support/accuracy.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace isotouch::field {
namespace {

TEST(Angle, IsThatOfTheMathsLibraryAllRoundAndAtEverySize) {
  double worst = 0;
  for (const double size : {1e-150, 1e-3, 1.0, 1e150}) {
    for (int n = -18000; n <= 18000; ++n) {
      const double angle = n * std::numbers::pi / 18000;
      const double y = size * std::sin(angle);
      const double x = size * std::cos(angle);
      worst = std::max(worst, std::abs(angle_of(y, x) - std::atan2(y, x)));
    }
  }
  EXPECT_THAT(worst, test::IsAccuracyOf(1.2e-15));
}

TEST(Angle, IsExactOnTheAxesAndZeroWithoutADirection) {
  EXPECT_EQ(angle_of(0, 0), 0);
  EXPECT_EQ(angle_of(0, 2), 0);
  EXPECT_EQ(angle_of(0, -2), std::numbers::pi);
  EXPECT_NEAR(angle_of(3, 0), std::numbers::pi / 2, 1e-15);
  EXPECT_NEAR(angle_of(-3, 0), -std::numbers::pi / 2, 1e-15);
}

}  // namespace
}  // namespace isotouch::field
