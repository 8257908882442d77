#include "firmware/core/stiffness_at.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "shared/roots.h"

namespace isotouch::core {

namespace {

using namespace image_layout;

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

Stiffness interpolated_stiffness(const Vec3<Voxel>& point, const FieldView& field, Stiffness largest) {
  const AxisPlace x = place(point.x, field.size[0]), y = place(point.y, field.size[1]), z = place(point.z, field.size[2]);
  // Contracted along x, then y, then z; `known` the same for what has a value. Exact, so the order is free.
  const auto contracted = [&](std::int32_t k, std::int32_t& known) {
    std::int32_t sums[2], weights[2];
    for (std::int32_t j = 0; j < 2; ++j) {
      const std::int32_t brick_y = y.before + j, brick_z = z.before + k;
      const std::uint32_t* cells = field.root + ((brick_z >> 2) * field.root_size[1] + (brick_y >> 2)) * field.root_size[0];
      const std::uint32_t* slots = field.nodes + (((brick_z & 3) << 4) | ((brick_y & 3) << 2));
      const auto part = [&](std::int32_t i) -> std::int32_t {
        const std::int32_t brick_x = x.before + i;
        return field.stiffness_parts[slots[cells[brick_x >> 2] * kBricksPerNode + static_cast<std::uint32_t>(brick_x & 3)]];
      };
      const std::int32_t before = part(0), after = part(1);
      sums[j] = before * x.weight[0] + after * x.weight[1];                           // below 2^22
      weights[j] = (before != 0 ? x.weight[0] : 0) + (after != 0 ? x.weight[1] : 0);  // at most 2^14
    }
    known = weights[0] * y.weight[0] + weights[1] * y.weight[1];
    return std::int64_t{sums[0]} * y.weight[0] + std::int64_t{sums[1]} * y.weight[1];  // below 2^36
  };
  std::int32_t known_before = 0, known_after = 0;
  const std::int64_t sum_before = contracted(0, known_before), sum_after = contracted(1, known_after);
  const std::int64_t sum = sum_before * z.weight[0] + sum_after * z.weight[1];                                    // at most 255 · 2^42
  const std::int64_t known = std::int64_t{known_before} * z.weight[0] + std::int64_t{known_after} * z.weight[1];  // at most 2^42
  // A stored brick weighs 1/8 of the whole at every point within it; below 1/64 the quotient's bits would not suffice.
  constexpr std::int64_t kLeast = std::int64_t{1} << (3 * kWeightBits - 6);
  if (known < kLeast) return largest;
  constexpr int kSpare = 19;  // sum is then below 2^31, and from 2^20 on where known is 1/8
  const Reciprocal over_known = reciprocal(static_cast<std::uint64_t>(kFullStiffness * known));  // shift from 74 to 80
  const std::int64_t part = ((sum >> kSpare) * over_known.mantissa) >> (over_known.shift - kSpare - Ratio::kFractionBits);
  return mul<Stiffness>(largest, Ratio::from_raw(static_cast<std::int32_t>(part)));
}

}  // namespace isotouch::core
