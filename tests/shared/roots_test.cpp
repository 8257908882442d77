#include "shared/roots.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/accuracy.h"
#include "tests/support/random.h"

namespace isotouch {
namespace {

double value(const Reciprocal& r) { return std::ldexp(static_cast<double>(r.mantissa), -r.shift); }

template <class Check>
void over_whole_range(Check check) {
  test::Random random(11);
  for (int bit = 0; bit < 64; ++bit) {
    const std::uint64_t power = std::uint64_t{1} << bit;
    for (const std::uint64_t corner : {power, power + 1, power - 1}) check(corner == 0 ? 1 : corner);
    for (int i = 0; i < 500; ++i) check(power | (random.bits() & (power - 1)));
  }
  check(~std::uint64_t{0});
}

TEST(Reciprocal, IsWithinItsBoundOverTheWholeRange) {
  double worst = 0;
  over_whole_range([&](std::uint64_t x) {
    const Reciprocal r = reciprocal(x);
    EXPECT_GE(r.mantissa, std::int64_t{1} << 30);
    EXPECT_LE(r.mantissa, std::int64_t{1} << 31);
    worst = std::max(worst, std::abs(value(r) * static_cast<double>(x) - 1));
  });
  EXPECT_THAT(worst, test::IsAccuracyOf(std::ldexp(1.0, -29)));
}

TEST(InverseRoot, IsWithinItsBoundOverTheWholeRange) {
  double worst = 0;
  over_whole_range([&](std::uint64_t x) {
    const Reciprocal r = inverse_root(x);
    EXPECT_GE(r.mantissa, std::int64_t{1} << 30);
    EXPECT_LE(r.mantissa, std::int64_t{1} << 31);
    worst = std::max(worst, std::abs(value(r) * std::sqrt(static_cast<double>(x)) - 1));
  });
  EXPECT_THAT(worst, test::IsAccuracyOf(std::ldexp(1.0, -28)));
}

TEST(Reciprocal, OfZeroIsThatOfOne) {
  EXPECT_EQ(reciprocal(0).mantissa, reciprocal(1).mantissa);
  EXPECT_EQ(inverse_root(0).shift, inverse_root(1).shift);
}

/// Forms for numbers of which more is known, and the general ones, are one function to the bit.
TEST(Roots, EveryFormGivesTheSameBits) {
  const auto same = [](const Reciprocal& a, const Reciprocal& b) { return a.mantissa == b.mantissa && a.shift == b.shift; };
  int longs = 0, shorts = 0, moderate = 0;
  over_whole_range([&](std::uint64_t x) {
    EXPECT_TRUE(same(inverse_root_of_positive(x), inverse_root(x))) << x;
    if (x >> 32 != 0) {
      ++longs;
      EXPECT_TRUE(same(reciprocal_of_long(x), reciprocal(x))) << x;
      EXPECT_TRUE(same(inverse_root_of_long(x), inverse_root(x))) << x;
    } else {
      ++shorts;
      EXPECT_TRUE(same(reciprocal32(static_cast<std::uint32_t>(x)), reciprocal(x))) << x;
      EXPECT_TRUE(same(reciprocal32_of_positive(static_cast<std::uint32_t>(x)), reciprocal(x))) << x;
    }
    if (x < std::uint64_t{1} << 59) {
      ++moderate;
      const Roots roots = roots_of(x);
      EXPECT_TRUE(same(roots.inverse, inverse_root(x))) << x;
      const double exact = std::sqrt(static_cast<double>(x));
      EXPECT_NEAR(static_cast<double>(roots.root), exact, 1 + exact * std::ldexp(1.0, -27)) << x;
      EXPECT_LE(static_cast<double>(roots.root), exact * (1 + std::ldexp(1.0, -27))) << x;
    }
  });
  EXPECT_TRUE(same(reciprocal32(0), reciprocal(0)));
  EXPECT_GT(longs, 10'000);
  EXPECT_GT(shorts, 10'000);
  EXPECT_GT(moderate, 20'000);
}

TEST(Roots, AShareIsValueOverRoot) {
  test::Random random(13);
  for (int i = 0; i < 20000; ++i) {
    const std::uint64_t x = (random.bits() >> 2 >> (random.bits() % 60)) | 1U;
    const double root = std::sqrt(static_cast<double>(x));
    const auto value = static_cast<Narrow>(root * (static_cast<double>(random.bits() % 1000) / 1000));
    const double share = static_cast<double>(share_of_root(value, inverse_root(x))) / 1073741824.0;
    EXPECT_NEAR(share, static_cast<double>(value) / root, std::ldexp(1.0, -27)) << x;
  }
}

TEST(Roots, AReciprocalIsOneOverX) {
  test::Random random(12);
  for (int i = 0; i < 20000; ++i) {
    const std::uint64_t x = (random.bits() >> (random.bits() % 64)) | 1U;
    const Reciprocal r = reciprocal(x);
    EXPECT_NEAR(std::ldexp(static_cast<double>(r.mantissa), -r.shift) * static_cast<double>(x), 1.0, std::ldexp(1.0, -29)) << x;
  }
}

}  // namespace
}  // namespace isotouch
