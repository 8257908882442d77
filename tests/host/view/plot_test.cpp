#include "host/view/plot.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace isotouch::view {
namespace {

const Colour kRed{1, 0, 0};
const Rect kPlace{0, 0, 960, 720};

Plot plot_of(Series series) {
  Plot plot;
  plot.x_label = std::string(1, 'x');  // not a literal: gcc 12 sees an overlap in it (its bug 105651)
  plot.y_label = std::string(1, 'y');
  plot.series.push_back(std::move(series));
  return plot;
}

bool red_near(const Image& image, Point p) {
  for (int dy = -1; dy <= 1; ++dy) {
    for (int dx = -1; dx <= 1; ++dx) {
      const Colour c = image.at(static_cast<int>(p.x) + dx, static_cast<int>(p.y) + dy);
      if (c.r > 0.9F && c.g < 0.3F) return true;
    }
  }
  return false;
}

TEST(Plot, LineRunsThroughItsValues) {
  Series series{"a", {}, {}, kRed, 2};
  for (int i = 0; i <= 100; ++i) {
    series.x.push_back(i);
    series.y.push_back(std::sin(i * 0.1));
  }
  const Plot plot = plot_of(series);
  Picture picture(960, 720);
  Canvas canvas(picture);
  plot.draw(canvas, kPlace);
  const Image image = picture.pixels();
  const Axes axes = plot.axes(kPlace, 1);
  for (std::size_t i = 3; i < 98; ++i) EXPECT_TRUE(red_near(image, axes.at(series.x[i], series.y[i]))) << i;
  EXPECT_FALSE(red_near(image, axes.at(50, 0.5)));
}

TEST(Plot, OneHighValueAmongManyInAColumnIsStillSeen) {
  Series series{"", {}, {}, kRed, 2};
  for (int i = 0; i < 200'000; ++i) {
    series.x.push_back(i);
    series.y.push_back(i == 123'457 ? 1.0 : 0.0);
  }
  const Plot plot = plot_of(series);
  Picture picture(960, 720);
  Canvas canvas(picture);
  plot.draw(canvas, kPlace);
  const Image image = picture.pixels();
  EXPECT_TRUE(red_near(image, plot.axes(kPlace, 1).at(123'457, 0.9)));
}

TEST(Plot, MissingValuesInterruptTheLine) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  const Plot plot = plot_of({"", {0, 1, 2, 3, 4, 5}, {1, 1, none, none, 1, 2}, kRed, 2});
  Picture picture(960, 720);
  Canvas canvas(picture);
  plot.draw(canvas, kPlace);
  const Image image = picture.pixels();
  const Axes axes = plot.axes(kPlace, 1);
  EXPECT_TRUE(red_near(image, axes.at(0.5, 1)));
  EXPECT_FALSE(red_near(image, axes.at(2.5, 1)));
  EXPECT_TRUE(red_near(image, axes.at(4.5, 1.5)));
}

TEST(Plot, StaysWithinItsFrameWhateverTheRange) {
  Plot plot = plot_of({"", {0, 1, 2}, {-50, 0.5, 50}, kRed, 4});
  plot.y_range = {0.0, 1.0};
  Picture picture(960, 720);
  Canvas canvas(picture);
  plot.draw(canvas, kPlace);
  const Image image = picture.pixels();
  const Rect area = plot.axes(kPlace, 1).area();
  for (int x = 0; x < 960; ++x) {
    for (const float y : {area.top - 6, area.bottom + 3}) {
      const Colour c = image.at(x, static_cast<int>(y));
      ASSERT_FALSE(c.r > 0.9F && c.g < 0.3F) << x;
    }
  }
}

TEST(Plot, EmptyAndConstantSeriesAreDrawnToo) {
  Picture picture(960, 720);
  Canvas canvas(picture);
  plot_of({"", {}, {}, kRed}).draw(canvas, kPlace);
  const Plot constant = plot_of({"", {0, 1}, {3, 3}, kRed, 2});
  constant.draw(canvas, kPlace);
  const Image image = picture.pixels();
  EXPECT_TRUE(red_near(image, constant.axes(kPlace, 1).at(0.5, 3)));
}

}  // namespace
}  // namespace isotouch::view
