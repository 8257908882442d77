/// Reciprocals and square roots by a small table and two Newton steps: no division, so the same instructions on every processor.
///
/// tick      yes
/// source    Newton–Raphson iteration from a table: Parhami, Computer Arithmetic, 2nd ed., chapters 16 and 21
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "shared/fixed.h"

namespace isotouch {

/// 1 / x as mantissa / 2^shift; mantissa in [2^30, 2^31), relative error below 2^-29.
struct Reciprocal {
  Narrow mantissa;
  int shift;
};

namespace roots {

/// 2^46 / m for m = 2^30 + (i + 1/2) 2^23, the middles of 128 equal parts of [2^30, 2^31): within 2^-8 everywhere in its part.
inline constexpr auto kReciprocalStart = [] {
  std::array<std::uint16_t, 128> table{};
  for (std::size_t i = 0; i < table.size(); ++i) {
    table[i] = static_cast<std::uint16_t>((std::uint64_t{1} << 46) / ((1 << 30) + ((2 * i + 1) << 22)));
  }
  return table;
}();

/// 2^31 / sqrt(m) for m = (i + 1/2) 2^24, the middles of the 256 equal parts of [0, 2^32): from i = 64 on within 2^-8 everywhere in its part.
inline constexpr auto kInverseRootStart = [] {
  std::array<std::uint16_t, 256> table{};
  for (std::size_t i = 64; i < table.size(); ++i) {
    std::uint64_t root = 0;
    for (std::uint64_t bit = 1 << 15; bit != 0; bit >>= 1) {
      if ((root | bit) * (root | bit) * ((2 * std::uint64_t{i} + 1) << 23) <= std::uint64_t{1} << 62) root |= bit;
    }
    table[i] = static_cast<std::uint16_t>(root);
  }
  return table;
}();

// The steps below never leave 32 bits but in a product, of which they take the upper word: on small processors that is one instruction. So numbers enter
// doubled where that saves a shift. That the mantissas stay below 2^31 was seen for every m.

inline constexpr bool kWide = sizeof(Narrow) == 8;

/// a · 2 b / 2^32, rounded down, where 2 b fits 32 bits. 64-bit processors shift anyway, so they shift by one less: a doubling would make the next step wait.
constexpr Narrow upper_word_of_twice(Narrow a, Narrow b) {
  return kWide ? static_cast<Narrow>(product(a, b) >> 31) : upper_word(product(a, 2 * b));
}
constexpr std::uint_fast32_t upper_product_of_twice(std::uint_fast32_t a, std::uint_fast32_t b) {
  return kWide ? static_cast<std::uint_fast32_t>((std::uint64_t{a} * b) >> 31) : upper_product(a, 2 * b);
}

/// The reciprocal of m · 2^e, m in [2^30, 2^31), whose mantissa counts by 2^-shift: y approximates 2^61 / m, in (2^30, 2^31); each step squares the error.
///
/// twice_m   2 m
constexpr Reciprocal refined(std::uint_fast32_t twice_m, int shift) {
  Narrow y = Narrow{kReciprocalStart[(twice_m >> 24) & 127]} << 15;
  for (int step = 0; step < 2; ++step) {
    const std::uint_fast32_t near_one = upper_product_of_twice(twice_m, static_cast<std::uint_fast32_t>(y));  // 2^31 but for the error
    const auto missing = static_cast<Narrow>((std::uint_fast32_t{1} << 31) - near_one);
    y += upper_word_of_twice(y, missing);
  }
  return {y, shift};
}

}  // namespace roots

/// x         above 0 (0 gives the reciprocal of 1)
constexpr Reciprocal reciprocal(std::uint64_t x) {
  const int lead = std::countl_zero(x | 1U);
  return roots::refined(static_cast<std::uint_fast32_t>(((x | std::uint64_t{x == 0}) << lead) >> 33) << 1, 61 + 33 - lead);
}

/// The same for a number from 2^32 on, to the bit: small processors find its lead in one word.
constexpr Reciprocal reciprocal_of_long(std::uint64_t x) {
  const auto upper = static_cast<std::uint32_t>(x >> 32), lower = static_cast<std::uint32_t>(x);
  const int lead = std::countl_zero(upper);  // at most 31
  return roots::refined(((upper << lead) | (lower >> 1 >> (31 - lead))) & ~1U, 61 + 33 - lead);
}
/// The same for one that fits 32 bits and is surely not 0, to the bit.
constexpr Reciprocal reciprocal32_of_positive(std::uint32_t x) {
  const int lead = std::countl_zero(x);
  return roots::refined((x << lead) & ~1U, 61 + 1 - lead);
}
/// The same for one that fits 32 bits, to the bit.
constexpr Reciprocal reciprocal32(std::uint32_t x) { return reciprocal32_of_positive(x | std::uint32_t{x == 0}); }

namespace roots {

/// 1 / sqrt(m · 2^(32 - lead)), m in [2^30, 2^32), lead even: y approximates 2^46 / sqrt(m) in [2^30, 2^31); y <- y (3 - m y^2) / 2 turns an error e into
/// 3/2 e^2. Nothing is negative.
constexpr Reciprocal refined_inverse_root(std::uint_fast32_t m, int lead) {
  const std::uint_fast32_t even = m & ~std::uint_fast32_t{1};
  std::uint_fast32_t y = std::uint_fast32_t{kInverseRootStart[m >> 24]} << 15;
  for (int step = 0; step < 2; ++step) {
    const std::uint_fast32_t square = upper_product_of_twice(y, y);    // y^2 / 2^31
    const std::uint_fast32_t near_half = upper_product(even, square);  // m y^2 / 2^63, near 2^29
    y = upper_product_of_twice((std::uint_fast32_t{3} << 30) - 2 * near_half, y);
  }
  return {static_cast<Narrow>(y), 62 - lead / 2};
}

}  // namespace roots

/// 1 / sqrt(x) as mantissa / 2^shift; mantissa in [2^30, 2^31), relative error below 2^-28.
///
/// x         above 0
constexpr Reciprocal inverse_root_of_positive(std::uint64_t x) {
  const int lead = std::countl_zero(x) & ~1;  // even, so that the exponent halves
  return roots::refined_inverse_root(static_cast<std::uint_fast32_t>((x << lead) >> 32), lead);
}
/// The same; 0 gives that of 1.
constexpr Reciprocal inverse_root(std::uint64_t x) { return inverse_root_of_positive(x | std::uint64_t{x == 0}); }

/// The same for a number from 2^32 on, to the bit: small processors find its lead in one word.
constexpr Reciprocal inverse_root_of_long(std::uint64_t x) {
  const auto upper = static_cast<std::uint32_t>(x >> 32), lower = static_cast<std::uint32_t>(x);
  const int lead = std::countl_zero(upper) & ~1;  // at most 30
  return roots::refined_inverse_root((upper << lead) | (lower >> 1 >> (31 - lead)), lead);
}

/// value / sqrt(x), 30 fraction bits, rounded down, where |value| <= sqrt(x) and x is below 2^62: the reciprocal's shift tells how far the value may be raised.
constexpr Narrow share_of_root(Narrow value, const Reciprocal& inverse_root) {
  return static_cast<Narrow>(product(value << (61 - inverse_root.shift), inverse_root.mantissa) >> 31);
}

/// A square root and its reciprocal.
struct Roots {
  Reciprocal inverse;
  Narrow root;
};

/// x         from 1 to 2^59
/// returns   inverse: as `inverse_root`; root: sqrt(x), the leading 31 bits of x times that, rounded down
constexpr Roots roots_of(std::uint64_t x) {
  const int lead = std::countl_zero(x) & ~1;
  const auto m = static_cast<std::uint_fast32_t>((x << lead) >> 32);
  const Reciprocal inverse = roots::refined_inverse_root(m, lead);
  const auto top = static_cast<int>(m >> 31);
  const auto root = upper_product(m >> top, static_cast<std::uint_fast32_t>(inverse.mantissa)) >> (60 - top - inverse.shift);
  return {inverse, static_cast<Narrow>(root)};
}

}  // namespace isotouch
