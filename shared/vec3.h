/// Three quantities of one unit, along the device's right-handed axes x, y, z.
///
/// tick      yes
#pragma once

#include <cstdint>

#include "shared/fixed.h"

namespace isotouch {

template <class Q>
struct Vec3 {
  Q x{};
  Q y{};
  Q z{};

  constexpr Vec3 operator+(const Vec3& o) const { return {x + o.x, y + o.y, z + o.z}; }
  constexpr Vec3 operator-(const Vec3& o) const { return {x - o.x, y - o.y, z - o.z}; }
  constexpr Vec3 operator-() const { return {-x, -y, -z}; }
  constexpr bool operator==(const Vec3&) const = default;
};

/// Every component times one factor, in the format R.
template <class R, class A, int FA, class B, int FB>
constexpr Vec3<R> mul(const Vec3<Fixed<A, FA>>& v, Fixed<B, FB> factor) {
  return {mul<R>(v.x, factor), mul<R>(v.y, factor), mul<R>(v.z, factor)};
}

/// A part of every component, from none to all of it.
template <class Q, int FP>
constexpr Vec3<Q> part_of(const Vec3<Q>& v, Fixed<Unit<0, 0, 0, 0>, FP> part) {
  return {part_of(v.x, part), part_of(v.y, part), part_of(v.z, part)};
}

/// Every component, if it is not beyond ±limit; else that.
template <class Q>
constexpr Vec3<Q> within(const Vec3<Q>& v, Q limit) {
  return {within(v.x, limit), within(v.y, limit), within(v.z, limit)};
}

/// The dot product of the raw values, in the product's format. Each |raw| must stay below 2^30, so that three products fit 63 bits.
template <class A, int FA, class B, int FB>
constexpr std::int64_t dot_raw(const Vec3<Fixed<A, FA>>& a, const Vec3<Fixed<B, FB>>& b) {
  return std::int64_t{a.x.raw()} * b.x.raw() + std::int64_t{a.y.raw()} * b.y.raw() + std::int64_t{a.z.raw()} * b.z.raw();
}

}  // namespace isotouch
