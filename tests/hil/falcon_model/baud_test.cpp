#include "hil/falcon_model/baud.h"

#include <gtest/gtest.h>

namespace isotouch::falcon_model {
namespace {

TEST(Baud, DivisorsGiveTheRatesOfTheSheet) {
  EXPECT_DOUBLE_EQ(baud_rate(0x4138, 0), 9600);
  EXPECT_NEAR(baud_rate(0x0015, 0), 142857, 0.5);
  EXPECT_NEAR(baud_rate(0x0015, 1), 140351, 0.5);
  EXPECT_DOUBLE_EQ(baud_rate(0x0002, 0), 1.5e6);
  EXPECT_DOUBLE_EQ(baud_rate(0, 0), 3e6);
  EXPECT_DOUBLE_EQ(baud_rate(1, 0), 2e6);
}

TEST(Baud, TheEighthsAreInTheChipsOrder) {
  constexpr double kEighths[] = {0, 4, 2, 1, 3, 5, 6, 7};
  for (unsigned code = 0; code < 8; ++code) {
    EXPECT_DOUBLE_EQ(baud_rate(static_cast<std::uint16_t>((code & 3) << 14 | 10), static_cast<std::uint16_t>(code >> 2)),
                     3e6 / (10 + kEighths[code] / 8));
  }
}

TEST(Baud, AReceiverForgivesThreePercent) {
  EXPECT_TRUE(same_rate(1456312, 1.5e6));
  EXPECT_TRUE(same_rate(1.5e6, 1.5e6 * 1.0299));
  EXPECT_FALSE(same_rate(1.5e6, 1411765));
  EXPECT_FALSE(same_rate(140351, 9600));
}

}  // namespace
}  // namespace isotouch::falcon_model
