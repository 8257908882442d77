#include "host/cloud/text_lines.h"

#include <gtest/gtest.h>

#include <cmath>

namespace isotouch::cloud {
namespace {

std::span<const std::uint8_t> bytes_of(std::string_view text) { return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}; }

TEST(TextLines, TakesAnyLineEndAndAnySeparator) {
  constexpr std::string_view kText = "1 2\r\n3,\t4;5\n\nlast";
  TextLines lines("f", bytes_of(kText));
  ASSERT_TRUE(lines.next());
  EXPECT_EQ(lines.field(), "1");
  EXPECT_EQ(lines.field(), "2");
  EXPECT_EQ(lines.field(), std::nullopt);
  ASSERT_TRUE(lines.next());
  EXPECT_EQ(lines.number("a"), 3.0);
  EXPECT_EQ(lines.number("a"), 4.0);
  EXPECT_EQ(lines.number("a"), 5.0);
  ASSERT_TRUE(lines.next());
  EXPECT_EQ(lines.field(), std::nullopt);
  ASSERT_TRUE(lines.next());
  EXPECT_EQ(lines.rest(), "last");
  EXPECT_EQ(lines.line(), 4U);
  EXPECT_FALSE(lines.next());
  EXPECT_EQ(lines.bytes_read(), kText.size());
}

TEST(TextLines, SkipAByteOrderMark) {
  constexpr std::string_view kText = "\xEF\xBB\xBF\x31 2\n3";
  TextLines lines("f", bytes_of(kText));
  ASSERT_TRUE(lines.next());
  EXPECT_EQ(lines.number("a"), 1.0);
  EXPECT_EQ(lines.bytes_read(), 7U);
  ASSERT_TRUE(lines.next());
  EXPECT_EQ(lines.field(), "3");
}

TEST(TextLines, NumbersAreWholeFields) {
  EXPECT_EQ(as_number("-1.5e3"), -1500.0);
  EXPECT_EQ(as_number("+2"), 2.0);
  EXPECT_EQ(as_number("1e-400"), 0.0);
  EXPECT_EQ(as_number("-0." + std::string(400, '0') + "1"), 0.0);
  EXPECT_EQ(as_number("0." + std::string(400, '0') + "1e5"), 0.0);
  EXPECT_EQ(as_number("1e-99999999999999999999"), 0.0);
  EXPECT_EQ(as_number("12e-400"), 0.0);
  EXPECT_TRUE(std::isinf(*as_number("1e400")));
  EXPECT_TRUE(std::isinf(*as_number("1e+99999999999999999999")));
  EXPECT_TRUE(std::isinf(*as_number(std::string(400, '9'))));
  EXPECT_TRUE(std::isinf(*as_number(std::string(400, '9') + ".5e-3")));
  EXPECT_TRUE(std::isinf(*as_number("0.001e400")));
  EXPECT_TRUE(std::isnan(*as_number("nan")));
  EXPECT_EQ(as_number("1.5x"), std::nullopt);
  EXPECT_EQ(as_number("0x10"), std::nullopt);
  EXPECT_EQ(as_number("1,5"), std::nullopt);
  EXPECT_EQ(as_number(""), std::nullopt);
  EXPECT_EQ(as_number("+-1"), std::nullopt);
}

TEST(TextLines, QuotesAreShortAndPrintable) {
  EXPECT_EQ(quote("abc"), "'abc'");
  EXPECT_EQ(quote(std::string_view("a\0\x1b\n", 4)), "'a\?\?\?'");
  EXPECT_EQ(quote(std::string(1000, 'x')), "'" + std::string(24, 'x') + "...'");
}

}  // namespace
}  // namespace isotouch::cloud
