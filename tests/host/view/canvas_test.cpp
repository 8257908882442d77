#include "host/view/canvas.h"

#include <gtest/gtest.h>

#include <numbers>

namespace isotouch::view {
namespace {

const Colour kBlack{0, 0, 0};

/// How many whole pixels of a white picture turned black.
double ink(const Image& image) {
  double sum = 0;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) sum += 1 - static_cast<double>(image.at(x, y).r);
  }
  return sum;
}

TEST(Canvas, DiscHasItsAreaWhereverItsCentreIs) {
  for (const Point centre : {Point{20, 20}, Point{20.5F, 20.25F}, Point{19.7F, 21.1F}}) {
    Image image(40, 40);
    Canvas(image).disc(centre, 9, kBlack);
    EXPECT_NEAR(ink(image), std::numbers::pi * 81, 2.0);
  }
}

TEST(Canvas, LineHasItsLengthTimesItsWidth) {
  Image image(60, 60);
  Canvas(image).line({10, 10}, {40, 50}, 3, kBlack);
  EXPECT_NEAR(ink(image), 50 * 3 + std::numbers::pi * 2.25, 4.0);
}

TEST(Canvas, ThinLineIsPaleNotWide) {
  Image image(60, 60);
  Canvas(image).line({10, 30.5F}, {50, 30.5F}, 0.5F, kBlack);
  EXPECT_NEAR(ink(image), 40 * 0.5, 1.5);
}

TEST(Canvas, CrossingLinesOfOneStrokeAreLaidOnOnce) {
  Image image(40, 40);
  const std::vector<Polyline> cross = {{{5, 20.5F}, {35, 20.5F}}, {{20.5F, 5}, {20.5F, 35}}};
  Canvas(image).stroke(cross, 3, kBlack, 0.5F);
  EXPECT_NEAR(image.at(20, 20).r, 0.5F, 1e-6F);
  EXPECT_NEAR(image.at(10, 20).r, 0.5F, 1e-6F);
}

TEST(Canvas, FillCoversPartsOfPixels) {
  Image image(10, 10);
  Canvas(image).fill({2.25F, 3, 5.5F, 4.5F}, kBlack);
  EXPECT_NEAR(ink(image), 3.25 * 1.5, 1e-5);
}

TEST(Canvas, NothingIsDrawnBeyondTheClipOrThePicture) {
  Image image(20, 20);
  Canvas whole(image);
  Canvas part = whole.within({5, 5, 10, 10});
  part.fill({-100, -100, 100, 100}, kBlack);
  part.line({-50, 7}, {70, 7}, 9, kBlack);
  EXPECT_NEAR(ink(image), 25, 1e-4);
  whole.disc({-3, -3}, 2, kBlack);
  whole.line({1e9F, 0}, {2e9F, 5}, 2, kBlack);
  EXPECT_NEAR(ink(image), 25, 1e-4);
}

TEST(Dashes, HaveTheAskedLengthsAcrossCorners) {
  const std::vector<Polyline> pieces = dashed({{0, 0}, {10, 0}, {10, 10}}, 6, 3);
  ASSERT_EQ(pieces.size(), 3U);
  EXPECT_FLOAT_EQ(pieces[0].back().x, 6);
  EXPECT_FLOAT_EQ(pieces[1].front().x, 9);
  EXPECT_FLOAT_EQ(pieces[1].back().y, 5);
  EXPECT_FLOAT_EQ(pieces[2].front().y, 8);
  EXPECT_FLOAT_EQ(pieces[2].back().y, 10);
}

}  // namespace
}  // namespace isotouch::view
