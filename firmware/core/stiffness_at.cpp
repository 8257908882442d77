#include "firmware/core/stiffness_at.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "shared/roots.h"

namespace isotouch::core {

namespace {

using namespace blob_layout;

constexpr int kPlaceBits = Voxel::kFractionBits + kBrickShift;          // of a place in units of bricks
constexpr int kWeightBits = 14;                                         // a place to 1/4096 voxel; three weights fit 42 bits
constexpr std::int32_t kFirstCentre = 3 << (Voxel::kFractionBits - 1);  // the middle of samples 0 to 3 lies at 1.5

/// One axis of the point: the brick whose centre lies before it, and the weights of that one and the next, together 2^14.
struct AxisPlace {
  std::int32_t before;
  std::int32_t weight[2];
};

AxisPlace place(Voxel coordinate, std::int32_t size) {
  const std::int32_t last = (size - 1) >> kBrickShift;  // at least 1, at most 1023
  const std::int32_t along = std::clamp<std::int32_t>(coordinate.raw() - kFirstCentre, 0, (last << kPlaceBits) - 1);
  const std::int32_t after = (along & ((1 << kPlaceBits) - 1)) >> (kPlaceBits - kWeightBits);
  return {along >> kPlaceBits, {(1 << kWeightBits) - after, after}};
}

}  // namespace

Stiffness interpolated_stiffness(const Vec3<Voxel>& point, const BlobView& field, Stiffness largest) {
  const AxisPlace x = place(point.x, field.size[0]), y = place(point.y, field.size[1]), z = place(point.z, field.size[2]);
  std::int64_t sum = 0, known = 0;  // at most 255 · 2^42, and 2^42
  for (std::int32_t n = 0; n < 8; ++n) {
    const std::int32_t i = n & 1, j = (n >> 1) & 1, k = n >> 2;
    const std::uint32_t brick =
        field.brick_number((x.before + i) << kBrickShift, (y.before + j) << kBrickShift, (z.before + k) << kBrickShift);
    const std::int32_t part = field.stiffness_parts[brick];
    const std::int64_t weight = std::int64_t{x.weight[i] * y.weight[j]} * z.weight[k];
    sum += part * weight;
    known += part != 0 ? weight : 0;
  }
  // A stored brick weighs 1/8 of the whole at every point within it; below 1/64 the quotient's bits would not suffice.
  constexpr std::int64_t kLeast = std::int64_t{1} << (3 * kWeightBits - 6);
  if (known < kLeast) return largest;
  constexpr int kSpare = 19;  // sum is then below 2^31, and from 2^20 on where known is 1/8
  const Reciprocal over_known = reciprocal(static_cast<std::uint64_t>(kFullStiffness * known));  // shift from 74 to 80
  const std::int64_t part = ((sum >> kSpare) * over_known.mantissa) >> (over_known.shift - kSpare - Ratio::kFractionBits);
  return mul<Stiffness>(largest, Ratio::from_raw(static_cast<std::int32_t>(part)));
}

}  // namespace isotouch::core
