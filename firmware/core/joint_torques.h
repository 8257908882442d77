/// Force on the hand → torques of the arms.
#pragma once

#include <array>

#include "firmware/core/kinematics.h"
#include "shared/units.h"
#include "shared/vec3.h"

namespace isotouch::core {

using JointTorques = std::array<NewtonMm, 3>;

/// τ = J⁻ᵀ F, by the levers and the inverse of the closures.
///
/// force     within ±128 N a component
/// returns   within 0.01 N·mm and 1e-5 of the exact torque; near a singular pose too small, see Statics
/// fails     never: saturates at 524 N·m
/// tick      yes
/// source    principle of virtual work; follows from Jᵀ τ = F with J = G / d
inline JointTorques joint_torques(const Vec3<Newton>& force, const Statics& statics) {
  constexpr int kBits = 30;                             // of μ = inverse · F, N/mm
  constexpr std::int64_t kMax = std::int64_t{1} << 33;  // 8 N/mm: keeps μ times a lever below 2^62
  JointTorques torques;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::int64_t sum = std::int64_t{statics.inverse[i].x.raw()} * force.x.raw() +  // each below 2^31 * 2^23
                             std::int64_t{statics.inverse[i].y.raw()} * force.y.raw() +
                             std::int64_t{statics.inverse[i].z.raw()} * force.z.raw();
    const std::int64_t mu = round_shift(sum, PerMm::kFractionBits + Newton::kFractionBits - kBits);
    constexpr int kShift = kBits + SquareMm::kFractionBits - NewtonMm::kFractionBits;
    const auto torque = [&](std::int64_t moment) { return NewtonMm::from_raw(saturate32(round_shift(moment, kShift))); };
    if (is_within_bits<31>(mu)) [[likely]] {  // below 2 N/mm
      torques[i] = torque(product(static_cast<Narrow>(mu), statics.levers[i].raw()));
      continue;
    }
    const std::int64_t bounded = mu < -kMax ? -kMax : mu > kMax ? kMax : mu;
    torques[i] = torque(bounded * statics.levers[i].raw());
  }
  return torques;
}

}  // namespace isotouch::core
