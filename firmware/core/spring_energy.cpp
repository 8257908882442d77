#include "firmware/core/spring_energy.h"

#include <algorithm>
#include <bit>
#include <cstdint>

#include "firmware/core/direction.h"
#include "shared/roots.h"

namespace isotouch::core {

namespace {

constexpr std::int64_t kDeepest = std::int64_t{64} << (2 * Voxel::kFractionBits);  // square voxels: deeper springs lean no further
constexpr Ratio kLeastTrust = Ratio::of(1.0 / 64);
constexpr int kSpareBits = 12;                                                        // of a square, below those that count
constexpr std::int64_t kLongest = (std::int64_t{1} << (32 + kSpareBits)) - 1;         // 64 voxels: longer springs hold no more
constexpr std::int64_t kReserve = std::int64_t{1} << (30 + 2 * 16 - kSpareBits - 4);  // the hardest spring at a quarter of a voxel
constexpr Slope kMostTurn = Slope::of(256);

/// Halves what would swing, and trusts again by little.
Ratio renewed(Ratio trust, bool turns_back) {
  const std::int32_t raw = turns_back ? trust.raw() >> 1 : trust.raw() + (trust.raw() >> 4);
  return within(Ratio::from_raw(raw), kLeastTrust, Ratio::of(1));
}

/// -½ |d|² ∇ ln k, each component within `most`.
Vec3<Voxel> towards_least_energy(std::int64_t square, const Vec3<PerVoxel>& slope, Voxel most) {
  const std::int64_t half_square = std::min(square, kDeepest) >> (Voxel::kFractionBits + 1);
  const auto part = [&](PerVoxel s) {
    return within(Voxel::from_raw(saturate32(-((half_square * s.raw()) >> PerVoxel::kFractionBits))), most);
  };
  return {part(slope.x), part(slope.y), part(slope.z)};
}

/// H v: how the surface's normal turns along v.
Vec3<Slope> turned(const FieldSample& surface, const Vec3<Voxel>& v) {
  const Vec3<Curvature>&second = surface.second, &mixed = surface.mixed;
  const auto row = [&](Curvature x, Curvature y, Curvature z) {
    return within(Slope::from_raw(saturate32(dot_raw(Vec3<Curvature>{x, y, z}, v) >> Curvature::kFractionBits)), kMostTurn);
  };
  return {row(second.x, mixed.z, mixed.y), row(mixed.z, second.y, mixed.x), row(mixed.y, mixed.x, second.z)};
}

/// |v|² as a number that the parts of stiffness are multiplied with: 20 fraction bits, below 2^32.
std::int64_t square_length(const Vec3<Voxel>& v) { return std::min(dot_raw(v, v), kLongest) >> kSpareBits; }

/// The part at most `there` whose energy the spring has. What is not used of it stays in the reserve as far as that reaches.
Ratio afforded(Ratio there, std::int64_t square, std::int64_t energy, std::int64_t& reserve) {
  const std::int64_t wanted = there.raw() * square;
  const bool enough = wanted <= energy;
  reserve = enough ? std::min(energy - wanted, kReserve) : 0;
  if (enough) return there;
  const Reciprocal over = reciprocal32_of_positive(static_cast<std::uint32_t>(square));
  const int cut = std::max(0, static_cast<int>(std::bit_width(static_cast<std::uint64_t>(energy))) - 31);
  const std::int64_t quotient = product(static_cast<Narrow>(energy >> cut), over.mantissa) >> (over.shift - cut);
  return Ratio::from_raw(static_cast<std::int32_t>(std::max<std::int64_t>(quotient, 1)));
}

}  // namespace

void lean_to_the_softer(const FieldSample& surface, SpringState& state, Contact& contact) {
  if (!state.holds || !contact.touching) return;
  const Vec3<Ratio> normal = direction(contact.deflection);
  const Voxel depth = along(contact.deflection, normal), most = Voxel::from_raw(depth.raw() >> 1);
  const std::int64_t stretch = dot_raw(contact.deflection, contact.deflection) + dot_raw(state.lean, state.lean);
  const Vec3<Voxel> least = towards_least_energy(stretch, state.felt.slope, most) + mul<Voxel>(state.turn, depth);
  const Vec3<Voxel> step = across(within(least, most) - state.lean, normal);
  state.trust = renewed(state.trust, dot_raw(step, state.step) < 0);
  state.step = step;
  state.lean = across(within(state.lean + part_of(step, state.trust), most), normal);
  state.turn = turned(surface, state.lean);
  const Voxel fall = Voxel::from_raw(saturate32(dot_raw(state.lean, state.turn) >> (Slope::kFractionBits + 1)));
  const Vec3<Voxel> offset = state.lean - reaching(within(fall, most), normal);
  contact.proxy = contact.proxy + offset;
  contact.deflection = contact.deflection + offset;
}

Stiffness felt_stiffness(const Contact& contact, const FieldView& field, Stiffness largest, SpringState& state) {
  if (field.stiffness_parts == nullptr) return largest;
  StiffnessSample there = sample_stiffness(contact.proxy, field);
  if (state.holds) {
    const Vec3<Voxel> hip = contact.proxy - contact.deflection;
    const std::int64_t energy =
        state.felt.part.raw() * square_length(state.proxy - hip) + state.reserve;  // of the stretched spring, below 2^63
    there.part = afforded(there.part, square_length(contact.deflection), energy, state.reserve);
  } else {
    state = {};
    state.reserve = kReserve;
  }
  state.felt = there;
  state.proxy = contact.proxy;
  state.holds = contact.touching && field.method != Method::kPublished;
  return part_of(largest, there.part);
}

}  // namespace isotouch::core
