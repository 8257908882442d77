#include "host/view/axes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <utility>

namespace isotouch::view {
namespace {

TEST(Ticks, AreRoundFewAndInside) {
  EXPECT_EQ(ticks(0, 10, 6), (std::vector<double>{0, 2, 4, 6, 8, 10}));
  EXPECT_EQ(ticks(-4, 4, 9).size(), 9U);
  for (const double high : {0.003, 0.7, 1.0, 9.99, 123.0, 5e6}) {
    for (const int most : {2, 5, 11}) {
      const auto values = ticks(-0.4 * high, high, most);
      EXPECT_GE(values.size(), most > 2 ? 2U : 1U) << high << ' ' << most;
      EXPECT_LE(values.size(), static_cast<std::size_t>(most)) << high << ' ' << most;
      EXPECT_GE(values.front(), -0.4 * high * (1 + 1e-6));
      EXPECT_LE(values.back(), high * (1 + 1e-6));
    }
  }
}

TEST(Ticks, AnEmptyRangeHasNone) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  for (const auto& [low, high] :
       {std::pair{0.0, 0.0}, {-0.0, 0.0}, {3.0, 3.0}, {1.0, 0.0}, {0.0, 5e-324}, {0.0, kInfinity}, {0.0, std::nan("")}}) {
    EXPECT_TRUE(ticks(low, high, 9).empty()) << low << ' ' << high;
  }
  EXPECT_FALSE(ticks(0, 1e-300, 9).empty());
}

TEST(Ticks, TextsTellNeighboursApart) {
  EXPECT_EQ(tick_text(0.30000000000000004, 0.1), "0.3");
  EXPECT_EQ(tick_text(-2, 1), "−2");
  EXPECT_EQ(tick_text(0.0025, 0.0005), "0.0025");
  EXPECT_EQ(tick_text(-1e-17, 0.1), "0");
  EXPECT_EQ(tick_text(2000, 500), "2000");
}

TEST(Axes, MapValuesToPixelsAndBack) {
  const Axes axes({100, 50, 500, 250}, {"x", -1, 3}, {"y", 0, 10});
  EXPECT_FLOAT_EQ(axes.at(-1, 0).x, 100);
  EXPECT_FLOAT_EQ(axes.at(-1, 0).y, 250);
  EXPECT_FLOAT_EQ(axes.at(3, 10).x, 500);
  EXPECT_FLOAT_EQ(axes.at(3, 10).y, 50);
  EXPECT_DOUBLE_EQ(axes.x_of(200), 0);
  EXPECT_DOUBLE_EQ(axes.y_of(100), 7.5);
}

}  // namespace
}  // namespace isotouch::view
