/// Quantities: a 32-bit integer with a physical unit and a number of fraction bits, both in the type.
///
/// A `Fixed<U, F>` holds `raw / 2^F` in the unit U. Nothing converts to or from a plain number by itself; sums need the
/// same unit and format; a product names its result (`mul<Newton>(k, x)`) and does not compile when the units disagree.
/// Rounding is to nearest, ties towards plus infinity: add half, shift right arithmetically. It is written here, once.
///
/// tick      yes: every function is constant cost, without division and without failure
#pragma once

#include <cassert>
#include <compare>
#include <cstdint>
#include <limits>
#include <type_traits>

namespace isotouch {

/// Powers of the base units: millimetre, newton, second, voxel edge.
template <int MmPower, int NewtonPower, int SecondPower, int VoxelPower>
struct Unit {
  static constexpr int kMm = MmPower;
  static constexpr int kNewton = NewtonPower;
  static constexpr int kSecond = SecondPower;
  static constexpr int kVoxel = VoxelPower;
};

template <class R, class A, class B>
inline constexpr bool is_product_of = R::kMm == A::kMm + B::kMm&& R::kNewton == A::kNewton + B::kNewton&& R::kSecond ==
                                      A::kSecond + B::kSecond&& R::kVoxel == A::kVoxel + B::kVoxel;

/// `value / 2^bits` rounded to nearest, ties up; `bits` from 0 to 62, |value| + 2^(bits-1) below 2^63.
constexpr std::int64_t round_shift(std::int64_t value, int bits) {
  return bits == 0 ? value : (value + (std::int64_t{1} << (bits - 1))) >> bits;
}

/// A number that is known to fit 32 bits, in the width that costs the processor least: 32-bit ones multiply two of them by one instruction, others need not
/// extend signs. The same numbers on all of them.
using Narrow = std::int_fast32_t;

/// The whole product of two.
constexpr std::int64_t product(Narrow a, Narrow b) { return std::int64_t{a} * b; }

/// The nearest value within ±limit, for what is hardly ever beyond: one comparison decides.
constexpr Narrow within(Narrow value, Narrow limit) {
  if (static_cast<std::uint_fast32_t>(value) + static_cast<std::uint_fast32_t>(limit) <= 2 * static_cast<std::uint_fast32_t>(limit))
      [[likely]] {
    return value;
  }
  return value < 0 ? -limit : limit;
}

/// `round_shift` where the result is known to fit 32 bits.
constexpr Narrow round_shift_narrow(std::int64_t value, int bits) { return static_cast<Narrow>(round_shift(value, bits)); }

/// `value / 2^32` rounded down: on 32-bit processors no shift at all.
constexpr Narrow upper_word(std::int64_t value) { return static_cast<Narrow>(value >> 32); }

/// The same of the product of two that are not negative.
constexpr std::uint_fast32_t upper_product(std::uint_fast32_t a, std::uint_fast32_t b) {
  return static_cast<std::uint_fast32_t>((std::uint64_t{a} * b) >> 32);
}

/// Is |value| below 2^bits, or value -2^bits?
template <int bits>
constexpr bool is_within_bits(std::int64_t value) {
  return static_cast<std::uint64_t>(value + (std::int64_t{1} << bits)) >> (bits + 1) == 0;
}

/// The nearest value that fits 32 bits: saturates, never wraps.
constexpr std::int32_t saturate32(std::int64_t value) {
  const auto kept = static_cast<std::int32_t>(value);
  return kept == value ? kept : static_cast<std::int32_t>(value >> 63) ^ std::numeric_limits<std::int32_t>::max();
}

/// a + b and a - b, saturated, without a wider number: where they overflow, the sum has the sign of a.
constexpr std::int32_t saturated_sum(std::int32_t a, std::int32_t b) {
  std::int32_t sum = 0;
  return __builtin_add_overflow(a, b, &sum) ? (a >> 31) ^ std::numeric_limits<std::int32_t>::max() : sum;
}
constexpr std::int32_t saturated_difference(std::int32_t a, std::int32_t b) {
  std::int32_t difference = 0;
  return __builtin_sub_overflow(a, b, &difference) ? (a >> 31) ^ std::numeric_limits<std::int32_t>::max() : difference;
}

/// Never defined: a literal out of range reaches it at compile time, and the compiler prints its name.
void the_value_does_not_fit_its_format();

template <class U, int F>
class Fixed {
 public:
  using UnitType = U;
  static constexpr int kFractionBits = F;
  static_assert(F >= 0 && F < 32);

  constexpr Fixed() = default;

  /// The stored integer, as it is.
  static constexpr Fixed from_raw(std::int32_t raw) { return Fixed(raw); }
  /// A physical literal in the source, an integer in the program; does not compile out of range.
  static consteval Fixed of(double value) {
    const double scaled = value * static_cast<double>(std::int64_t{1} << F);
    const double rounded = scaled < 0 ? scaled - 0.5 : scaled + 0.5;
    if (rounded >= 2147483648.0 || rounded <= -2147483649.0) the_value_does_not_fit_its_format();
    return Fixed(static_cast<std::int32_t>(rounded));
  }
  static constexpr Fixed max() { return Fixed(std::numeric_limits<std::int32_t>::max()); }

  constexpr std::int32_t raw() const { return raw_; }

  /// Sums saturate: they are exact whenever the true sum fits.
  constexpr Fixed operator+(Fixed other) const { return Fixed(saturated_sum(raw_, other.raw_)); }
  constexpr Fixed operator-(Fixed other) const { return Fixed(saturated_difference(raw_, other.raw_)); }
  constexpr Fixed operator-() const { return Fixed(saturated_difference(0, raw_)); }
  constexpr auto operator<=>(const Fixed&) const = default;

 private:
  constexpr explicit Fixed(std::int32_t raw) : raw_(raw) {}
  std::int32_t raw_ = 0;
};

/// The nearest value from `low` to `high`. Of numbers, not of references as std::clamp is: what these refer to must lie in memory.
template <class U, int F>
constexpr Fixed<U, F> within(Fixed<U, F> value, std::type_identity_t<Fixed<U, F>> low, std::type_identity_t<Fixed<U, F>> high) {
  const std::int32_t v = value.raw(), l = low.raw(), h = high.raw();
  return Fixed<U, F>::from_raw(v < l ? l : h < v ? h : v);
}

/// The same within ±limit, which is not below 0, for what is hardly ever beyond.
template <class U, int F>
constexpr Fixed<U, F> within(Fixed<U, F> value, std::type_identity_t<Fixed<U, F>> limit) {
  return Fixed<U, F>::from_raw(static_cast<std::int32_t>(within(Narrow{value.raw()}, Narrow{limit.raw()})));
}

/// The product in the format R, rounded once, saturated. Worst case 2^62 before the shift: fits.
template <class R, class A, int FA, class B, int FB>
constexpr R mul(Fixed<A, FA> a, Fixed<B, FB> b) {
  static_assert(is_product_of<typename R::UnitType, A, B>, "the result's unit is not the product of the factors' units");
  constexpr int shift = FA + FB - R::kFractionBits;
  static_assert(shift >= 0, "the result has more fraction bits than the product");
  return R::from_raw(saturate32(round_shift(std::int64_t{a.raw()} * b.raw(), shift)));
}

/// A part of a quantity, none (0) to all of it (1 or -1): what `mul` gives in its own format, which it cannot leave.
template <class U, int F, int FP>
constexpr Fixed<U, F> part_of(Fixed<U, F> whole, Fixed<Unit<0, 0, 0, 0>, FP> part) {
  return Fixed<U, F>::from_raw(static_cast<std::int32_t>(round_shift_narrow(product(whole.raw(), part.raw()), FP)));
}

}  // namespace isotouch
