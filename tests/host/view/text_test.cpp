#include "host/view/text.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string_view>

namespace isotouch::view {
namespace {

/// The box around everything that is not white.
Rect inked(const Image& image) {
  Rect box{1e6F, 1e6F, -1, -1};
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      if (image.at(x, y).r > 0.9F) continue;
      const auto px = static_cast<float>(x), py = static_cast<float>(y);
      box = {std::min(box.left, px), std::min(box.top, py), std::max(box.right, px + 1), std::max(box.bottom, py + 1)};
    }
  }
  return box;
}

Rect drawn(std::string_view text, const TextStyle& style) {
  Picture picture(200, 200);
  Canvas canvas(picture);
  draw_text(canvas, {100, 100}, text, style);
  return inked(picture.pixels());
}

TEST(Text, CapitalsHaveTheAskedHeightAboveTheBaseLine) {
  const Rect box = drawn("HIE", {.capital = 28});
  EXPECT_NEAR(box.bottom, 100, 3);
  EXPECT_NEAR(box.top, 72, 3);
}

TEST(Text, StandsWhereItsAnchorSays) {
  const TextStyle style{.capital = 14};
  const float width = text_width("HEMH", style);
  TextStyle middle = style, end = style;
  middle.along = Anchor::kMiddle;
  end.along = Anchor::kEnd;
  EXPECT_NEAR(drawn("HEMH", style).left, 100, 2);
  EXPECT_NEAR(drawn("HEMH", style).right, 100 + width, 2);
  EXPECT_NEAR(drawn("HEMH", middle).left, 100 - width / 2, 2);
  EXPECT_NEAR(drawn("HEMH", end).right, 100, 2);
}

TEST(Text, UpwardTextIsTheSameTurnedByAQuarter) {
  const TextStyle style{.capital = 14};
  TextStyle upward = style;
  upward.upward = true;
  const Rect flat = drawn("Force", style), turned = drawn("Force", upward);
  EXPECT_NEAR(flat.width(), turned.height(), 1);
  EXPECT_NEAR(flat.height(), turned.width(), 1);
  EXPECT_NEAR(turned.bottom, 100, 2);
}

TEST(Text, WhatIsNoUtf8IsDrawnAsASignAndSpoilsNothing) {
  const TextStyle style{.capital = 14};
  Picture picture(200, 200);
  Canvas canvas(picture);
  draw_text(canvas, {10, 50}, "a\xFF\xC3z", style);
  draw_text(canvas, {100, 100}, "HEMH", style);
  EXPECT_NEAR(inked(picture.pixels()).bottom, 100, 2);
  EXPECT_EQ(text_width("a\xFFz", style), text_width("a\uFFFDz", style));
  EXPECT_FALSE(encode(picture, ".svg").empty());
}

TEST(Text, DigitsAreEquallyWideSoThatNumbersAlign) {
  for (const char* digit : {"1", "4", "7", "8"}) EXPECT_FLOAT_EQ(text_width(digit, {}), text_width("0", {})) << digit;
}

}  // namespace
}  // namespace isotouch::view
