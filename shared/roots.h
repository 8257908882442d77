/// Reciprocals and square roots by a fixed number of Newton steps: no division, so the same instructions on every processor.
///
/// tick      yes
/// source    Newton–Raphson division with a linear start (e.g. Parhami, Computer Arithmetic, 2nd ed., chapter 16)
#pragma once

#include <bit>
#include <cstdint>

namespace isotouch {

/// 1 / x as mantissa / 2^shift; mantissa in [2^30, 2^31], relative error below 2^-29.
struct Reciprocal {
  std::int64_t mantissa;
  int shift;
};

/// x         above 0 (0 gives the reciprocal of 1)
constexpr Reciprocal reciprocal(std::uint64_t x) {
  const int lead = std::countl_zero(x | 1U);
  const auto m = static_cast<std::int64_t>(((x | std::uint64_t{x == 0}) << lead) >> 33);  // in [2^30, 2^31): x = m * 2^(33 - lead)
  // y approximates 2^61 / m, in (2^30, 2^31]. Start 48/17 - 32/17 * m/2^31, error at most 1/17, squared by each of three steps.
  std::int64_t y = 3031741621 - ((m * 2021161081) >> 31);
  for (int step = 0; step < 3; ++step) y += (y * ((std::int64_t{1} << 31) - ((m * y) >> 30))) >> 31;
  return {y, 61 + 33 - lead};
}

/// value * 1/x rounded down; |value| below 2^32.
constexpr std::int64_t times(std::int64_t value, const Reciprocal& r) { return (value * r.mantissa) >> (r.shift < 63 ? r.shift : 63); }

/// 1 / sqrt(x) as mantissa / 2^shift; mantissa in [2^30, 2^31], relative error below 2^-28.
///
/// x         above 0 (0 gives that of 1)
constexpr Reciprocal inverse_root(std::uint64_t x) {
  const int lead = std::countl_zero(x | 1U) & ~1;                                         // even, so that the exponent halves
  const auto m = static_cast<std::int64_t>(((x | std::uint64_t{x == 0}) << lead) >> 32);  // in [2^30, 2^32): x = m * 2^(32 - lead)
  // y approximates 2^46 / sqrt(m) in [2^30, 2^31]. Start 2.22 - 4/3 * m/2^32, error at most 1/9, then
  // y <- y (3 - m y^2) / 2, which turns an error e into 3/2 e^2, four times.
  std::int64_t y = 2383708160 - ((m * 1398101) >> 22);
  for (int step = 0; step < 4; ++step) {
    const std::int64_t square = (y * y) >> 31;               // y^2 / 2^31, at most 2^31
    const std::int64_t product = ((m >> 1) * square) >> 31;  // m y^2 / 2^63, near 2^29
    y = (y * ((std::int64_t{3} << 29) - product)) >> 30;
  }
  return {y, 46 + (32 - lead) / 2};
}

}  // namespace isotouch
