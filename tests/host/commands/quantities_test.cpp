#include "host/commands/quantities.h"

#include <gtest/gtest.h>

namespace isotouch::commands {
namespace {

TEST(Quantities, ANumberMayCarryItsUnit) {
  EXPECT_EQ(parse_quantity("0.34mm", kLength), 0.34);
  EXPECT_EQ(parse_quantity("0.34", kLength), 0.34);
  EXPECT_EQ(parse_quantity(".5", kLength), 0.5);
  EXPECT_EQ(parse_quantity("7cm", kLength), 70.0);
  EXPECT_EQ(parse_quantity("2in", kLength), 50.8);
  EXPECT_EQ(parse_quantity("1e-1mm", kLength), 0.1);
  EXPECT_EQ(parse_quantity("0.8N/mm", kStiffness), 0.8);
  EXPECT_EQ(parse_quantity("800N/m", kStiffness), 0.8);
}

TEST(Quantities, AnythingElseIsNotAQuantity) {
  for (const char* text :
       {"", "mm", "-1mm", "+1mm", " 1mm", "1 mm", "1mm ", "1mmm", "1MM", "1N/mm", "nan", "inf", "0x10", "1,5", "1e999", "1.2.3"}) {
    EXPECT_FALSE(parse_quantity(text, kLength).has_value()) << text;
  }
}

/// What the option holds after the text was given, or nothing for wrong usage.
std::optional<double> parsed(const std::string& text) {
  CLI::App app;
  double value = 0;
  app.add_option("--voxel", value)->transform(quantity(kLength, 0.1, 16));
  try {
    app.parse("--voxel " + text);
  } catch (const CLI::ParseError&) {
    return std::nullopt;
  }
  return value;
}

TEST(Quantities, AnOptionTakesOnlyValuesInItsRange) {
  EXPECT_EQ(parsed("0.34mm"), 0.34);
  EXPECT_EQ(parsed("0.1"), 0.1);
  EXPECT_EQ(parsed("1.6cm"), 16.0);
  EXPECT_FALSE(parsed("0.0999").has_value());
  EXPECT_FALSE(parsed("1.61cm").has_value());
  EXPECT_FALSE(parsed("wide").has_value());
}

}  // namespace
}  // namespace isotouch::commands
