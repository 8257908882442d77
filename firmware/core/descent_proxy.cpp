#include "firmware/core/descent_proxy.h"

#include <algorithm>

namespace isotouch::core {

namespace {

constexpr int kGammaBits = 32;
constexpr std::int64_t kGamma = 138547332;
static_assert(kGamma * (1 + 3 * kDescentPenalty) == (std::int64_t{1} << kGammaBits) - 4, "the nearest to 1 / (1 + 3λ)");

/// One coordinate after a step. The worst: |φ| is 8 voxels (2^19), |g| 16 (2^20), so λφg is within 1280 voxels, and p, a mean of places and such pushes,
/// within 9471; then p - h is below 17662 voxels, and with the push below 18942: 2^31.
Voxel descend(Voxel p, Voxel h, Narrow penalised_depth, Slope g) {
  const auto push = static_cast<Narrow>(product(penalised_depth, g.raw()) >> Slope::kFractionBits);
  const std::int64_t pull = std::int64_t{p.raw()} - h.raw() + push;
  return Voxel::from_raw(p.raw() - static_cast<std::int32_t>((pull * kGamma + (std::int64_t{1} << (kGammaBits - 1))) >> kGammaBits));
}

Vec3<Voxel> descend(const Vec3<Voxel>& p, const Vec3<Voxel>& h, const FieldSample& at) {
  const Narrow depth = kDescentPenalty * std::min<Narrow>(at.distance.raw(), 0);  // outside nothing is penalised
  return {descend(p.x, h.x, depth, at.gradient.x), descend(p.y, h.y, depth, at.gradient.y), descend(p.z, h.z, depth, at.gradient.z)};
}

}  // namespace

Contact descend_proxy(const Vec3<Voxel>& hip, const FieldView& field, ProxyState& state) {
  if (state.mode == ProxyMode::kUnplaced || state.mode == ProxyMode::kHeldInside) return rest_at(hip, field, state);

  state.hip = hip;
  if (state.mode == ProxyMode::kFree) state.point = hip;
  for (int step = 0; step < kDescentSteps; ++step) {
    sample_field(field, state.point, state.sample);
    state.point = descend(state.point, hip, state.sample);
  }
  sample_field(field, state.point, state.sample);

  Contact contact;
  contact.touching = state.sample.distance < Voxel{};
  contact.proxy = contact.touching ? state.point : hip;
  if (contact.touching) contact.deflection = contact.proxy - hip;
  contact.outside_grid = state.sample.outside_grid;
  state.proxy = contact.proxy;
  state.mode = contact.touching ? ProxyMode::kContact : ProxyMode::kFree;
  return contact;
}

}  // namespace isotouch::core
