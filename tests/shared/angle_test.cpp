#include "shared/angle.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/accuracy.h"
#include "tests/support/random.h"

namespace isotouch {
namespace {

constexpr double kTurn = 6.283185307179586;

TEST(SineCosine, AreWithinTheirBoundAllTheWayAround) {
  double worst = 0;
  const auto check = [&](std::uint32_t raw) {
    const SineCosine found = sine_cosine(Angle::from_raw(raw));
    const double angle = raw * (kTurn / 4294967296.0);
    worst = std::max(worst, std::abs(found.sine.raw() / 1073741824.0 - std::sin(angle)));
    worst = std::max(worst, std::abs(found.cosine.raw() / 1073741824.0 - std::cos(angle)));
  };
  for (std::uint32_t quarter = 0; quarter < 4; ++quarter) {
    for (std::uint32_t place = 0; place <= 256; ++place) {  // the table's places and the middles between them
      for (const std::uint32_t beside : {0xFFFFFFFFU, 0U, 1U}) check((quarter << 30) + (place << 22) + beside);
    }
  }
  test::Random random(71);
  for (int i = 0; i < 1'000'000; ++i) check(static_cast<std::uint32_t>(random.bits()));
  EXPECT_THAT(worst, test::IsAccuracyOf(std::ldexp(1.0, -29)));
}

TEST(SineCosine, AreExactAtTheQuarters) {
  constexpr Ratio kOne = Ratio::of(1);
  const Ratio expected[4][2] = {{Ratio{}, kOne}, {kOne, Ratio{}}, {Ratio{}, -kOne}, {-kOne, Ratio{}}};
  for (std::uint32_t quarter = 0; quarter < 4; ++quarter) {
    const SineCosine found = sine_cosine(Angle::from_raw(quarter << 30));
    EXPECT_EQ(found.sine, expected[quarter][0]);
    EXPECT_EQ(found.cosine, expected[quarter][1]);
  }
}

TEST(SineCosine, AreOddAndEven) {
  test::Random random(72);
  for (int i = 0; i < 100'000; ++i) {
    const Angle angle = Angle::from_raw(static_cast<std::uint32_t>(random.bits()));
    const SineCosine a = sine_cosine(angle);
    const SineCosine b = sine_cosine(Angle{} - angle);
    EXPECT_NEAR(a.sine.raw(), -b.sine.raw(), 2);
    EXPECT_NEAR(a.cosine.raw(), b.cosine.raw(), 2);
  }
}

TEST(Angle, ALiteralIsThePartOfATurn) {
  EXPECT_EQ(Angle::degrees(90).raw(), 1U << 30);
  EXPECT_EQ(Angle::degrees(-90).raw(), 3U << 30);
  EXPECT_EQ((Angle::degrees(200) + Angle::degrees(200)).raw(), Angle::degrees(40).raw());
  EXPECT_EQ(AnglePerCount::degrees(360.0 / 1024).raw(), 1 << 30);
}

}  // namespace
}  // namespace isotouch
