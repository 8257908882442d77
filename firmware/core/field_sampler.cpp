#include "firmware/core/field_sampler.h"

#include <algorithm>
#include <array>

namespace isotouch::core {

namespace {

using namespace blob_layout;

// Inside the sampler numbers carry 20 fraction bits. Coefficients are within ±8, so a second difference is within ±32: 2^25.
constexpr int kInnerBits = 20;
constexpr int kCoefficientBits = kInnerBits - Distance::kFractionBits;
constexpr int kOuterBits = kInnerBits - Voxel::kFractionBits;

/// Three neighbours contracted along one axis by the quadratic B-spline: value, first and second derivative at offset t from the middle one.
struct Along {
  std::int32_t value, slope, bend;
};

/// t: 16 fraction bits, within ±1/2. Two products, each below 2^26 * 2^16; what is cut off is below 2^-20.
Along along(std::int32_t before, std::int32_t at, std::int32_t after, std::int32_t t) {
  const std::int32_t bend = before - 2 * at + after;
  const std::int32_t rise = after - before;
  const auto turn = static_cast<std::int32_t>((std::int64_t{bend} * t) >> 16);
  const auto tilt = static_cast<std::int32_t>((std::int64_t{rise + turn} * t) >> 17);
  return {at + (bend >> 3) + tilt, (rise >> 1) + turn, bend};
}

std::int32_t value_along(std::int32_t before, std::int32_t at, std::int32_t after, std::int32_t t) { return along(before, at, after, t).value; }

/// One axis of the point: its nearest sample, the offset from it, and where its three neighbours lie in the tree.
struct AxisPlace {
  std::int32_t t;                           // 16 fraction bits, within ±1/2
  std::array<std::int32_t, 2> root, slot;     // of the brick before and the brick after; equal where the three share one brick
  std::array<std::int32_t, 3> in_brick;       // sample within its brick
  std::array<std::int32_t, 3> which;          // brick before or after
};

AxisPlace place(std::int32_t coordinate, std::int32_t size, bool& outside) {
  const std::int32_t low = 1 << 16;
  const std::int32_t high = (size - 2) << 16;
  outside |= coordinate < low || coordinate > high;
  const std::int32_t inside = std::clamp(coordinate, low, high);
  const std::int32_t nearest = (inside + 0x8000) >> 16;   // in [1, size - 2]
  AxisPlace axis;
  axis.t = inside - (nearest << 16);
  const std::int32_t first_brick = (nearest - 1) >> kBrickShift;
  const std::array<std::int32_t, 2> brick = {first_brick, (nearest + 1) >> kBrickShift};
  for (std::size_t side = 0; side < 2; ++side) {
    axis.root[side] = brick[side] >> (kNodeShift - kBrickShift);
    axis.slot[side] = brick[side] & 3;
  }
  for (std::size_t tap = 0; tap < 3; ++tap) {
    const std::int32_t index = nearest - 1 + static_cast<std::int32_t>(tap);
    axis.in_brick[tap] = index & 3;
    axis.which[tap] = (index >> kBrickShift) - first_brick;
  }
  return axis;
}

/// The eight bricks around the point, equal ones repeated: [z][y][x], each index 0 = before, 1 = after.
using BrickCorner = std::array<const std::int16_t*, 8>;

BrickCorner bricks_around(const BlobView& field, const AxisPlace& x, const AxisPlace& y, const AxisPlace& z) {
  BrickCorner bricks;
  for (std::size_t corner = 0; corner < 8; ++corner) {
    const std::size_t sx = corner & 1, sy = (corner >> 1) & 1, sz = corner >> 2;
    const std::int32_t cell = (z.root[sz] * field.root_size[1] + y.root[sy]) * field.root_size[0] + x.root[sx];
    const std::int32_t slot = (z.slot[sz] << 4) | (y.slot[sy] << 2) | x.slot[sx];
    const std::size_t node = field.root[cell];
    bricks[corner] = field.bricks + std::size_t{field.nodes[node * kBricksPerNode + static_cast<std::size_t>(slot)]} * kSamplesPerBrick;
  }
  return bricks;
}

constexpr std::int32_t outer(std::int32_t inner) { return (inner + (1 << (kOuterBits - 1))) >> kOuterBits; }

}  // namespace

FieldSample sample_field(const BlobView& field, const Vec3<Voxel>& point) {
  bool outside = false;
  const AxisPlace x = place(point.x.raw(), field.size[0], outside);
  const AxisPlace y = place(point.y.raw(), field.size[1], outside);
  const AxisPlace z = place(point.z.raw(), field.size[2], outside);
  const BrickCorner bricks = bricks_around(field, x, y, z);

  std::array<Along, 3> by_value, by_slope, by_bend;   // planes of constant z, after x and y are contracted
  for (std::size_t k = 0; k < 3; ++k) {
    std::array<Along, 3> row;
    for (std::size_t j = 0; j < 3; ++j) {
      const std::int32_t corner = (z.which[k] << 2) | (y.which[j] << 1);
      const std::int32_t in_brick = (z.in_brick[k] << 4) | (y.in_brick[j] << 2);
      const auto coefficient = [&](std::size_t i) {
        return std::int32_t{bricks[static_cast<std::size_t>(corner | x.which[i])][in_brick | x.in_brick[i]]} * (1 << kCoefficientBits);
      };
      row[j] = along(coefficient(0), coefficient(1), coefficient(2), x.t);
    }
    by_value[k] = along(row[0].value, row[1].value, row[2].value, y.t);
    by_slope[k] = along(row[0].slope, row[1].slope, row[2].slope, y.t);
    by_bend[k].value = value_along(row[0].bend, row[1].bend, row[2].bend, y.t);
  }
  const Along value = along(by_value[0].value, by_value[1].value, by_value[2].value, z.t);
  const Along dx = along(by_slope[0].value, by_slope[1].value, by_slope[2].value, z.t);
  const Along dy = along(by_value[0].slope, by_value[1].slope, by_value[2].slope, z.t);
  const std::int32_t dxx = value_along(by_bend[0].value, by_bend[1].value, by_bend[2].value, z.t);
  const std::int32_t dyy = value_along(by_value[0].bend, by_value[1].bend, by_value[2].bend, z.t);
  const std::int32_t dxy = value_along(by_slope[0].slope, by_slope[1].slope, by_slope[2].slope, z.t);

  FieldSample sample;
  sample.distance = Voxel::from_raw(outer(value.value));
  sample.gradient = {Slope::from_raw(outer(dx.value)), Slope::from_raw(outer(dy.value)), Slope::from_raw(outer(value.slope))};
  sample.second = {Curvature::from_raw(outer(dxx)), Curvature::from_raw(outer(dyy)), Curvature::from_raw(outer(value.bend))};
  sample.mixed = {Curvature::from_raw(outer(dy.slope)), Curvature::from_raw(outer(dx.slope)), Curvature::from_raw(outer(dxy))};
  sample.outside_grid = outside;
  return sample;
}

}  // namespace isotouch::core
