#include "host/view/font.h"

#include <gtest/gtest.h>

namespace isotouch::view {
namespace {

TEST(Font, EveryPrintableCharacterHasADrawingWithinItsLattice) {
  std::u32string wanted = U"°±·−–×µ²φ";
  for (char32_t c = U' '; c <= U'~'; ++c) wanted += c;
  for (const char32_t c : wanted) {
    ASSERT_TRUE(has_glyph(c)) << static_cast<unsigned>(c);
    const Glyph& drawing = glyph(c);
    EXPECT_EQ(drawing.strokes.empty(), c == U' ');
    for (const Polyline& stroke : drawing.strokes) {
      EXPECT_FALSE(stroke.empty());
      for (const Point& p : stroke) {
        EXPECT_GE(p.x, -0.5F) << static_cast<unsigned>(c);
        EXPECT_LE(p.x, drawing.width + 0.6F) << static_cast<unsigned>(c);
        EXPECT_GE(p.y, -2.3F) << static_cast<unsigned>(c);
        EXPECT_LE(p.y, 7.7F) << static_cast<unsigned>(c);
      }
    }
  }
}

TEST(Font, DigitsAreEquallyWideSoThatNumbersAlign) {
  for (char32_t c = U'0'; c <= U'9'; ++c) EXPECT_NEAR(glyph(c).width, 4.0F, 0.21F);
}

TEST(Font, UnknownCharactersAreABoxNotACrash) {
  EXPECT_FALSE(has_glyph(U'漢'));
  EXPECT_EQ(&glyph(U'漢'), &glyph(U'\uFFFD'));
}

TEST(Utf8, IsReadAndBrokenBytesAreReplaced) {
  EXPECT_EQ(decode_utf8("a°−φ"), U"a°−φ");
  EXPECT_EQ(decode_utf8("\xF0\x9F\x99\x82"), U"\U0001F642");
  EXPECT_EQ(decode_utf8("a\xFFz"), U"a\uFFFDz");
  EXPECT_EQ(decode_utf8("a\xC3"), U"a\uFFFD");
  EXPECT_EQ(decode_utf8("\xC3z"), U"\uFFFDz");
  EXPECT_EQ(decode_utf8(""), U"");
}

}  // namespace
}  // namespace isotouch::view
