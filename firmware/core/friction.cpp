#include "firmware/core/friction.h"

#include <cstdint>

#include "firmware/core/direction.h"
#include "shared/roots.h"

namespace isotouch::core {

namespace {

/// viscous / (stiffness + viscous), from 0 to 1.
Ratio viscous_share(Stiffness stiffness, DampingPerTick viscous) {
  const std::int64_t b = viscous.raw() >> (DampingPerTick::kFractionBits - Stiffness::kFractionBits);
  const Reciprocal sum = reciprocal(static_cast<std::uint64_t>(stiffness.raw() + b));  // its shift is 61 at least
  return Ratio::from_raw(static_cast<std::int32_t>((b * sum.mantissa) >> (sum.shift - Ratio::kFractionBits)));
}

}  // namespace

Vec3<Voxel> friction_offset(const Contact& contact, Stiffness stiffness, const Friction& friction, FrictionState& state) {
  const bool gripped = state.holds && contact.touching;
  state.holds = contact.touching;
  if (!gripped) {
    state.grip = contact.proxy;
    return {};
  }
  const Vec3<Ratio> normal = direction(contact.deflection);
  const Vec3<Voxel> offset = across(state.grip - contact.proxy, normal);

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
