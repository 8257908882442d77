/// Angles as parts of a turn, and their sine and cosine from a table: no maths library, the same bits on every processor.
///
/// tick      yes
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "shared/fixed.h"
#include "shared/units.h"

namespace isotouch {

/// An angle, 2^32 to the turn: it wraps where angles do. Resolution 8.4e-8 degrees.
class Angle {
 public:
  constexpr Angle() = default;
  static constexpr Angle from_raw(std::uint32_t raw) { return Angle(raw); }
  /// A physical literal in the source, within ±360.
  static consteval Angle degrees(double value) {
    const double turns = value * (4294967296.0 / 360.0);
    return Angle(static_cast<std::uint32_t>(static_cast<std::int64_t>(turns < 0 ? turns - 0.5 : turns + 0.5)));
  }
  constexpr std::uint32_t raw() const { return raw_; }
  constexpr Angle operator+(Angle other) const { return Angle(raw_ + other.raw_); }
  constexpr Angle operator-(Angle other) const { return Angle(raw_ - other.raw_); }
  constexpr bool operator==(const Angle&) const = default;

 private:
  constexpr explicit Angle(std::uint32_t raw) : raw_(raw) {}
  std::uint32_t raw_ = 0;
};

/// What one count of an encoder turns, 2^40 to the turn: range ±0.7 degrees, the error over 2^15 counts is below 5.4e-6 degrees.
class AnglePerCount {
 public:
  static constexpr int kFractionBits = 8;  ///< beyond those of Angle
  constexpr AnglePerCount() = default;
  static constexpr AnglePerCount from_raw(std::int32_t raw) { return AnglePerCount(raw); }
  static consteval AnglePerCount degrees(double value) {
    const double scaled = value * (4294967296.0 * 256.0 / 360.0);
    if (scaled >= 2147483647.0 || scaled <= -2147483647.0) the_value_does_not_fit_its_format();
    return AnglePerCount(static_cast<std::int32_t>(scaled < 0 ? scaled - 0.5 : scaled + 0.5));
  }
  constexpr std::int32_t raw() const { return raw_; }
  constexpr bool operator==(const AnglePerCount&) const = default;

 private:
  constexpr explicit AnglePerCount(std::int32_t raw) : raw_(raw) {}
  std::int32_t raw_ = 0;
};

struct SineCosine {
  Ratio sine;
  Ratio cosine;
};

namespace angle_detail {

inline constexpr int kQuarterBits = 7;  ///< 128 parts of a quarter turn

/// sin(i / 128 of a quarter turn), 30 fraction bits, to the nearest: the Taylor series, at compile time.
inline constexpr auto kSine = [] {
  std::array<std::int32_t, (std::size_t{1} << kQuarterBits) + 1> table{};
  for (std::size_t i = 0; i < table.size(); ++i) {
    const double x = 1.57079632679489661923 * static_cast<double>(i) / static_cast<double>(table.size() - 1);
    double sum = 0;
    double term = x;
    for (int n = 1; n < 30; n += 2) {
      sum += term;
      term *= -x * x / ((n + 1) * (n + 2));
    }
    table[i] = static_cast<std::int32_t>(sum * 1073741824.0 + 0.5);
  }
  return table;
}();

}  // namespace angle_detail

/// Both to within 2^-29 of the exact value.
///
/// tick      yes: six products, no branch
/// source    addition theorem around the nearest place of the table, with the rest's series up to its cube
constexpr SineCosine sine_cosine(Angle angle) {
  using namespace angle_detail;
  constexpr int kRestBits = 30 - kQuarterBits;                          // of an angle: what lies between two places
  const std::uint32_t nearest = angle.raw() + (1U << (kRestBits - 1));  // rounds to the nearest place
  const std::size_t place = (nearest >> kRestBits) & ((1U << kQuarterBits) - 1);
  const std::uint32_t quarter = nearest >> 30;
  const Narrow rest = static_cast<std::int32_t>((nearest & ((1U << kRestBits) - 1))) - (1 << (kRestBits - 1));  // within ±2^22

  // In radians with 34 fraction bits: 2π / 2^32 * 2^34 = 8π, here with 26 bits; below 2^22 * 2^31.
  // One factor of a product is raised where that makes the upper word the result.
  const Narrow r = round_shift_narrow(product(rest * 64, 1686629713), 32);     // below 0.0062, 2^27
  const Narrow square = 4 * round_shift_narrow(product(r, r), 39);             // r²/2 with 30 fraction bits, below 2^15, raised by 2
  const Narrow third = round_shift_narrow(product(square, 357913941), 32);     // r²/6
  const Narrow sine_rest = r - round_shift_narrow(product(4 * r, third), 32);  // r - r³/6, 34 fraction bits
  const Narrow s = kSine[place];
  const Narrow c = kSine[(std::size_t{1} << kQuarterBits) - place];
  const Narrow sine = s + round_shift_narrow(product(c, sine_rest), 34) - round_shift_narrow(product(s, square), 32);
  const Narrow cosine = c - round_shift_narrow(product(s, sine_rest), 34) - round_shift_narrow(product(c, square), 32);
  const bool swapped = (quarter & 1) != 0, below = (quarter & 2) != 0, left = ((quarter + 1) & 2) != 0;
  const Narrow y = swapped ? cosine : sine, x = swapped ? sine : cosine;
  const auto ratio = [](Narrow raw) { return Ratio::from_raw(static_cast<std::int32_t>(raw)); };
  return {ratio(below ? -y : y), ratio(left ? -x : x)};
}

}  // namespace isotouch
