#include "shared/fixed.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "shared/units.h"
#include "tests/support/accuracy.h"

namespace isotouch {
namespace {

constexpr std::int32_t kLow = std::numeric_limits<std::int32_t>::min();
constexpr std::int32_t kHigh = std::numeric_limits<std::int32_t>::max();

// What must not compile, asked at compile time.
template <class A, class B>
concept CanAdd = requires(A a, B b) {
  a + b;
};
template <class A, class B>
concept CanSubtract = requires(A a, B b) {
  a - b;
};
template <class A, class B>
concept CanCompare = requires(A a, B b) {
  a < b;
};
template <class A, class B>
concept CanMultiplyWithoutNamingTheResult = requires(A a, B b) {
  a* b;
};
template <class A, class B>
concept CanConvert = std::is_convertible_v<A, B> || std::is_constructible_v<B, A>;

static_assert(CanAdd<Mm, Mm> && CanSubtract<Newton, Newton> && CanCompare<Mm, Mm>);
static_assert(!CanAdd<Mm, Newton> && !CanSubtract<Mm, Newton> && !CanCompare<Mm, Newton>);
static_assert(!CanAdd<Mm, Fixed<Mm::UnitType, 16>>, "one unit in two formats does not mix");
static_assert(!CanAdd<Mm, int> && !CanAdd<Mm, double> && !CanCompare<Mm, int>);
static_assert(!CanConvert<int, Mm> && !CanConvert<double, Mm> && !CanConvert<Mm, int> && !CanConvert<Mm, double> &&
              !CanConvert<Mm, Newton>);
static_assert(!CanMultiplyWithoutNamingTheResult<Mm, Stiffness> && !CanMultiplyWithoutNamingTheResult<Mm, int>);
static_assert(is_product_of<Newton::UnitType, Stiffness::UnitType, Mm::UnitType>);
static_assert(is_product_of<Voxel::UnitType, Mm::UnitType, VoxelPerMm::UnitType>);
static_assert(!is_product_of<Newton::UnitType, Mm::UnitType, Mm::UnitType>);
static_assert(!is_product_of<Newton::UnitType, Damping::UnitType, Mm::UnitType>);
static_assert(sizeof(Mm) == 4 && std::is_trivially_copyable_v<Mm> && Mm{}.raw() == 0);

/// Corners first, then values spread over every magnitude.
std::vector<std::int32_t> raws() {
  std::vector<std::int32_t> values = {kLow, kLow + 1, -1, 0, 1, kHigh - 1, kHigh};
  std::uint64_t state = 1;
  for (int i = 0; i < 300; ++i) {
    state = state * 6364136223846793005U + 1442695040888963407U;
    values.push_back(static_cast<std::int32_t>(static_cast<std::uint32_t>(state >> 32)) >> (i % 31));
  }
  for (int bit = 0; bit < 31; ++bit) {
    for (const std::int32_t near : {-1, 0, 1}) {
      values.push_back((std::int32_t{1} << bit) + near);
      values.push_back(-(std::int32_t{1} << bit) + near);
    }
  }
  return values;
}

/// floor((value + half) / 2^bits), with the remainder taken by division instead of a shift.
std::int64_t rounded(std::int64_t value, int bits) {
  if (bits == 0) return value;
  const std::int64_t unit = std::int64_t{1} << bits;
  const std::int64_t sum = value + unit / 2;
  return sum / unit - (sum % unit < 0 ? 1 : 0);
}

std::int32_t clamped(std::int64_t value) { return static_cast<std::int32_t>(value < kLow ? kLow : value > kHigh ? kHigh : value); }

TEST(Fixed, LiteralsBecomeTheNearestInteger) {
  static_assert(Mm::of(1).raw() == 1 << 20);
  static_assert(Mm::of(-0.25).raw() == -(1 << 18));
  static_assert(Fixed<Mm::UnitType, 0>::of(2.4).raw() == 2 && Fixed<Mm::UnitType, 0>::of(-2.6).raw() == -3);
  static_assert(Mm::of(2047.999999).raw() == kHigh && Mm::of(-2048).raw() == kLow);
  static_assert(Ratio::of(1).raw() == 1 << 30);
}

TEST(Fixed, SumsAreExactWhenTheyFitAndSaturateWhenTheyDoNot) {
  for (const std::int32_t a : raws()) {
    EXPECT_EQ((-Mm::from_raw(a)).raw(), clamped(-std::int64_t{a}));
    for (const std::int32_t b : raws()) {
      ASSERT_EQ((Mm::from_raw(a) + Mm::from_raw(b)).raw(), clamped(std::int64_t{a} + b)) << a << " " << b;
      ASSERT_EQ((Mm::from_raw(a) - Mm::from_raw(b)).raw(), clamped(std::int64_t{a} - b)) << a << " " << b;
    }
  }
}

TEST(Fixed, OrderIsThatOfTheValues) {
  for (const std::int32_t a : raws()) {
    for (const std::int32_t b : raws()) {
      ASSERT_EQ(Mm::from_raw(a) < Mm::from_raw(b), a < b);
      ASSERT_EQ(Mm::from_raw(a) == Mm::from_raw(b), a == b);
    }
  }
}

TEST(Fixed, ProductsAreRoundedOnceAndSaturate) {
  for (const std::int32_t a : raws()) {
    for (const std::int32_t b : raws()) {
      const std::int64_t product = std::int64_t{a} * b;
      ASSERT_EQ(mul<Newton>(Stiffness::from_raw(a), Mm::from_raw(b)).raw(), clamped(rounded(product, 20))) << a << " " << b;
      ASSERT_EQ(mul<Ratio>(Ratio::from_raw(a), Ratio::from_raw(b)).raw(), clamped(rounded(product, 30))) << a << " " << b;
      ASSERT_EQ(mul<Voxel>(Mm::from_raw(a), VoxelPerMm::from_raw(b)).raw(), clamped(rounded(product, 28))) << a << " " << b;
    }
  }
}

TEST(Fixed, ProductsStayWithinHalfAUnitOfTheDoubleTwin) {
  double worst = 0;
  for (const std::int32_t a : raws()) {
    for (const std::int32_t b : raws()) {
      const double exact = std::ldexp(static_cast<double>(a), -16) * std::ldexp(static_cast<double>(b), -20);
      if (std::abs(exact) >= 32767) continue;
      const double error =
          std::abs(std::ldexp(static_cast<double>(mul<Newton>(Stiffness::from_raw(a), Mm::from_raw(b)).raw()), -16) - exact);
      worst = std::max(worst, std::ldexp(error, 16));
    }
  }
  EXPECT_THAT(worst, test::IsAccuracyOf(0.5));
  EXPECT_GE(worst, 0.499);  // ties occur: a smaller worst case would mean that they were not tried
}

TEST(Fixed, TiesGoUp) {
  EXPECT_EQ(round_shift(1, 1), 1);
  EXPECT_EQ(round_shift(-1, 1), 0);
  EXPECT_EQ(round_shift(3, 1), 2);
  EXPECT_EQ(round_shift(-3, 1), -1);
  EXPECT_EQ(round_shift(-5, 0), -5);
}

TEST(Fixed, RoundShiftIsTheRoundedQuotient) {
  for (int bits = 0; bits <= 62; ++bits) {
    const std::int64_t half = bits == 0 ? 0 : std::int64_t{1} << (bits - 1);
    for (const std::int64_t value : {std::int64_t{0}, half - 1, half, half + 1, -half - 1, -half, -half + 1, std::int64_t{kHigh} * kHigh,
                                     std::int64_t{kLow} * kHigh}) {
      ASSERT_EQ(round_shift(value, bits), rounded(value, bits)) << value << " " << bits;
    }
  }
}

}  // namespace
}  // namespace isotouch
