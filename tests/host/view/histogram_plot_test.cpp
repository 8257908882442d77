#include "host/view/histogram_plot.h"

#include <gtest/gtest.h>

namespace isotouch::view {
namespace {

constexpr Rect kPlace{0, 0, 960, 720};

int count(const Image& image, bool (*test)(const Colour&)) {
  int found = 0;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) found += test(image.at(x, y)) ? 1 : 0;
  }
  return found;
}

bool is_blue(const Colour& c) { return c.b > 3 * c.r && c.b > 1.5F * c.g && c.b > 0.05F; }
bool is_orange(const Colour& c) { return c.r > 4 * c.b && c.r > 1.5F * c.g && c.r < 6 * c.g && c.r > 0.3F && c.g > 0.3F; }
bool is_vermilion(const Colour& c) { return c.r > 4 * c.b && c.r > 3 * c.g && c.r > 0.3F; }

Image drawn(const HistogramPlot& plot) {
  Picture picture(960, 720);
  Canvas canvas(picture);
  plot.draw(canvas, kPlace);
  return picture.pixels();
}

TEST(Histogram, ASingleLateTickAmongMillionsIsABarOfItsOwn) {
  HistogramPlot plot{"wake-up", "us", {{10, 1'000'000}}, {}, {}, {}, {}};
  plot.classes.push_back({5000, 1});
  const Image image = drawn(plot);
  int columns = 0;
  bool before = false;
  for (int x = 0; x < image.width(); ++x) {  // along the foot of the bars
    const bool blue = is_blue(image.at(x, 720 - 48 - 6));
    columns += blue && !before ? 1 : 0;
    before = blue;
  }
  EXPECT_EQ(columns, 2);
}

TEST(Histogram, TheOtherRunIsALineAndTheLimitABrokenOne) {
  HistogramPlot plot{"tick", "us", {{1, 10}, {2, 100}}, {{4, 50}}, "one", "other", 8};
  const Image image = drawn(plot);
  EXPECT_GT(count(image, is_blue), 1000);
  EXPECT_GT(count(image, is_orange), 300);
  EXPECT_GT(count(image, is_vermilion), 300);
  plot.beside.clear(), plot.limit.reset();
  EXPECT_EQ(count(drawn(plot), is_orange), 0);
  EXPECT_EQ(count(drawn(plot), is_vermilion), 0);
}

TEST(Histogram, WithoutValuesASentenceIsDrawn) { EXPECT_EQ(count(drawn({"tick", "us", {}, {}, {}, {}, 8}), is_blue), 0); }

TEST(QuarterOctaves, KeepEveryValueAndRise) {
  std::vector<ValueClass> classes;
  double all = 0;
  for (int i = 0; i < 1000; ++i) {
    classes.push_back({i * 0.37, static_cast<double>(i % 7)});
    all += i % 7;
  }
  const std::vector<ValueClass> columns = by_quarter_octaves(classes);
  double kept = 0;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    kept += columns[i].count;
    if (i > 0) {
      EXPECT_GT(columns[i].up_to, columns[i - 1].up_to * 1.18);
    }
  }
  EXPECT_EQ(kept, all);
  EXPECT_EQ(by_quarter_octaves({{8, 3}}).at(0).up_to, 8) << "a bound belongs to the column that it ends";
}

}  // namespace
}  // namespace isotouch::view
