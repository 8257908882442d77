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
  Image image(200, 200);
  Canvas canvas(image);
  draw_text(canvas, {100, 100}, text, style);
  return inked(image);
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

TEST(Text, LettersAreToldApart) {
  Image l(60, 60), i(60, 60);
  Canvas on_l(l), on_i(i);
  draw_text(on_l, {10, 40}, "l1I", {.capital = 20});
  draw_text(on_i, {10, 40}, "1lI", {.capital = 20});
  bool differ = false;
  for (int y = 0; y < 60; ++y) {
    for (int x = 0; x < 60; ++x) differ |= l.at(x, y).r != i.at(x, y).r;
  }
  EXPECT_TRUE(differ);
}

}  // namespace
}  // namespace isotouch::view
