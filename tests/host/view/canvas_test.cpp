#include "host/view/canvas.h"

#include <gtest/gtest.h>

#include <numbers>

namespace isotouch::view {
namespace {

const Colour kBlack{0, 0, 0};

/// How many whole pixels of a white picture turned black: Cairo mixes what is stored, not light.
double ink(const Image& image) {
  double sum = 0;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) sum += 1 - to_byte(image.at(x, y).r) / 255.0;
  }
  return sum;
}

TEST(Canvas, DiscHasItsAreaWhereverItsCentreIs) {
  for (const Point centre : {Point{20, 20}, Point{20.5F, 20.25F}, Point{19.7F, 21.1F}}) {
    Picture picture(40, 40);
    Canvas(picture).disc(centre, 9, kBlack);
    EXPECT_NEAR(ink(picture.pixels()), std::numbers::pi * 81, 2.0);
  }
}

TEST(Canvas, LineHasItsLengthTimesItsWidth) {
  Picture picture(60, 60);
  Canvas(picture).line({10, 10}, {40, 50}, 3, kBlack);
  EXPECT_NEAR(ink(picture.pixels()), 50 * 3 + std::numbers::pi * 2.25, 4.0);
}

TEST(Canvas, ThinLineIsPaleNotWide) {
  Picture picture(60, 60);
  Canvas(picture).line({10, 30.5F}, {50, 30.5F}, 0.5F, kBlack);
  EXPECT_NEAR(ink(picture.pixels()), 40 * 0.5, 1.5);
}

TEST(Canvas, CrossingLinesOfOneStrokeAreLaidOnOnce) {
  Picture picture(40, 40);
  const std::vector<Polyline> cross = {{{5, 20.5F}, {35, 20.5F}}, {{20.5F, 5}, {20.5F, 35}}};
  Canvas(picture).stroke(cross, 3, kBlack, 0.5F);
  const Image image = picture.pixels();
  EXPECT_NEAR(to_byte(image.at(20, 20).r), 128, 1);
  EXPECT_EQ(image.at(10, 20).r, image.at(20, 20).r);
}

TEST(Canvas, FillCoversPartsOfPixels) {
  Picture picture(10, 10);
  Canvas(picture).fill({2.25F, 3, 5.5F, 4.5F}, kBlack);
  EXPECT_NEAR(ink(picture.pixels()), 3.25 * 1.5, 0.05);
}

TEST(Canvas, NothingIsDrawnBeyondTheClipOrThePicture) {
  Picture picture(20, 20);
  Canvas whole(picture);
  Canvas part = whole.within({5, 5, 10, 10});
  part.fill({-100, -100, 100, 100}, kBlack);
  part.line({-50, 7}, {70, 7}, 9, kBlack);
  EXPECT_NEAR(ink(picture.pixels()), 25, 1e-4);
  whole.disc({-3, -3}, 2, kBlack);
  whole.line({1e9F, 0}, {2e9F, 5}, 2, kBlack);
  EXPECT_NEAR(ink(picture.pixels()), 25, 1e-4);
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
