#include "firmware/core/friction.h"

#include <cstdint>

#include "shared/roots.h"

namespace isotouch::core {

namespace {

// Points within ±8191 voxels differ by less than 2^30 a component, so three squares fit 63 bits.
constexpr int kRatioBits = Ratio::kFractionBits;

/// The unit vector of v, 30 fraction bits; zero for zero.
Vec3<Ratio> direction(const Vec3<Voxel>& v, std::int64_t square) {
  const Reciprocal inverse = inverse_root(static_cast<std::uint64_t>(square));
  const auto part = [&](Voxel q) { return Ratio::from_raw(static_cast<std::int32_t>(share_of_root(q.raw(), inverse))); };
  return {part(v.x), part(v.y), part(v.z)};
}

/// How far v reaches along a unit vector.
Voxel along(const Vec3<Voxel>& v, const Vec3<Ratio>& unit) { return Voxel::from_raw(saturate32(dot_raw(v, unit) >> kRatioBits)); }

/// A length along a unit vector.
Vec3<Voxel> reaching(Voxel length, const Vec3<Ratio>& unit) {
  return {part_of(length, unit.x), part_of(length, unit.y), part_of(length, unit.z)};
}

/// viscous / (stiffness + viscous), from 0 to 1.
Ratio viscous_share(Stiffness stiffness, DampingPerTick viscous) {
  const std::int64_t b = viscous.raw() >> (DampingPerTick::kFractionBits - Stiffness::kFractionBits);
  const Reciprocal sum = reciprocal(static_cast<std::uint64_t>(stiffness.raw() + b));  // its shift is 61 at least
  return Ratio::from_raw(static_cast<std::int32_t>((b * sum.mantissa) >> (sum.shift - kRatioBits)));
}

}  // namespace

Vec3<Voxel> friction_offset(const Contact& contact, Stiffness stiffness, const Friction& friction, FrictionState& state) {
  const bool gripped = state.holds && contact.touching;
  state.holds = contact.touching;
  if (!gripped) {
    state.grip = contact.proxy;
    return {};
  }
  const Vec3<Ratio> normal = direction(contact.deflection, dot_raw(contact.deflection, contact.deflection));
  const Vec3<Voxel> dragged = state.grip - contact.proxy;
  const Vec3<Voxel> offset = dragged - reaching(along(dragged, normal), normal);

  const Voxel rim = mul<Voxel>(along(contact.deflection, normal), friction.coefficient);
  const std::int64_t square = dot_raw(offset, offset);
  if (square <= std::int64_t{rim.raw()} * rim.raw()) return offset;

  const Vec3<Ratio> back = direction(offset, square);
  const Voxel left = rim + part_of(along(offset, back) - rim, viscous_share(stiffness, friction.viscous));
  const Vec3<Voxel> slid = reaching(left, back);
  state.grip = contact.proxy + slid;
  return slid;
}

}  // namespace isotouch::core
