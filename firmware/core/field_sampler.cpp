#include "firmware/core/field_sampler.h"

#include <algorithm>
#include <array>
#include <cstring>

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

/// One axis of the point: its nearest sample, the offset from it, and where the brick of the sample before and the brick of the sample after lie.
struct AxisPlace {
  std::int32_t t;                          // offset from the nearest sample, 16 fraction bits, within ±1/2
  std::int32_t first;                      // index of the sample before the nearest one
  std::array<std::int32_t, 2> root, slot;  // of the brick before and the brick after; equal where the three samples share one brick
};

AxisPlace place(std::int32_t coordinate, std::int32_t size, bool& outside) {
  const std::int32_t inside = std::clamp(coordinate, 1 << 16, (size - 2) << 16);
  outside |= inside != coordinate;
  const std::int32_t first = ((inside + 0x8000) >> 16) - 1;  // in [0, size - 3]
  const std::int32_t before = first >> kBrickShift, after = (first + 2) >> kBrickShift;
  return {inside - ((first + 1) << 16), first, {before >> 2, after >> 2}, {before & 3, after & 3}};
}

/// The eight bricks around the point, equal ones repeated; index bit 0 is x, bit 1 y, bit 2 z: 0 before, 1 after.
std::array<const std::int16_t*, 8> bricks_around(const BlobView& field, const AxisPlace& x, const AxisPlace& y, const AxisPlace& z) {
  std::array<const std::int16_t*, 8> bricks;
  for (std::size_t sz = 0; sz < 2; ++sz) {
    for (std::size_t sy = 0; sy < 2; ++sy) {
      const std::uint32_t* cells = field.root + (z.root[sz] * field.root_size[1] + y.root[sy]) * field.root_size[0];
      const std::uint32_t* slots = field.nodes + ((z.slot[sz] << 4) | (y.slot[sy] << 2));
      for (std::size_t sx = 0; sx < 2; ++sx) {
        const std::uint32_t brick = slots[cells[x.root[sx]] * kBricksPerNode + static_cast<std::uint32_t>(x.slot[sx])];
        bricks[(sz << 2) | (sy << 1) | sx] = field.bricks + brick * kSamplesPerBrick;
      }
    }
  }
  return bricks;
}

/// Three samples in a row along x, contracted: from the brick row that holds the first (four samples, first in the low bits) and the next one.
Along contract_row(const std::int16_t* brick_before, const std::int16_t* brick_after, int shift, std::int32_t t) {
  std::uint64_t low, high;
  std::memcpy(&low, brick_before, sizeof low);
  std::memcpy(&high, brick_after, sizeof high);
  const std::uint64_t row = (low >> shift) | ((high << 1) << (63 - shift));
  const auto sample = [row](int place) { return std::int32_t{static_cast<std::int16_t>(row >> place)} * (1 << kCoefficientBits); };
  return along(sample(0), sample(16), sample(32), t);
}

/// Nine samples of constant z, contracted along x and y: the value and its derivatives within the plane.
struct Plane {
  std::int32_t value, dx, dy, dxx, dyy, dxy;
};

Plane contract_plane(const std::int16_t* const* bricks, const AxisPlace& x, const AxisPlace& y, std::int32_t in_brick_z) {
  const int shift = 16 * (x.first & 3);
  const auto row = [&](std::int32_t j) {
    const std::int32_t in_column = (y.first & 3) + j;
    const std::int16_t* const* pair = bricks + ((in_column >> kBrickShift) << 1);
    const std::int32_t offset = in_brick_z | ((in_column & 3) << 2);
    return contract_row(pair[0] + offset, pair[1] + offset, shift, x.t);
  };
  const Along row0 = row(0), row1 = row(1), row2 = row(2);
  const Along value = along(row0.value, row1.value, row2.value, y.t);
  const Along slope = along(row0.slope, row1.slope, row2.slope, y.t);
  const std::int32_t dxx = along(row0.bend, row1.bend, row2.bend, y.t).value;
  return {value.value, slope.value, value.slope, dxx, value.bend, slope.slope};
}

constexpr std::int32_t outer(std::int32_t inner) { return (inner + (1 << (kOuterBits - 1))) >> kOuterBits; }

}  // namespace

FieldSample sample_field(const BlobView& field, const Vec3<Voxel>& point) {
  bool outside = false;
  const AxisPlace x = place(point.x.raw(), field.size[0], outside);
  const AxisPlace y = place(point.y.raw(), field.size[1], outside);
  const AxisPlace z = place(point.z.raw(), field.size[2], outside);
  const std::array<const std::int16_t*, 8> bricks = bricks_around(field, x, y, z);

  const auto plane = [&](std::int32_t k) {
    const std::int32_t in_column = (z.first & 3) + k;
    return contract_plane(bricks.data() + ((in_column >> kBrickShift) << 2), x, y, (in_column & 3) << 4);
  };
  const Plane p0 = plane(0), p1 = plane(1), p2 = plane(2);
  const Along value = along(p0.value, p1.value, p2.value, z.t);
  const Along dx = along(p0.dx, p1.dx, p2.dx, z.t);
  const Along dy = along(p0.dy, p1.dy, p2.dy, z.t);
  const std::int32_t dxx = along(p0.dxx, p1.dxx, p2.dxx, z.t).value;
  const std::int32_t dyy = along(p0.dyy, p1.dyy, p2.dyy, z.t).value;
  const std::int32_t dxy = along(p0.dxy, p1.dxy, p2.dxy, z.t).value;

  FieldSample sample;
  sample.distance = Voxel::from_raw(outer(value.value));
  sample.gradient = {Slope::from_raw(outer(dx.value)), Slope::from_raw(outer(dy.value)), Slope::from_raw(outer(value.slope))};
  sample.second = {Curvature::from_raw(outer(dxx)), Curvature::from_raw(outer(dyy)), Curvature::from_raw(outer(value.bend))};
  sample.mixed = {Curvature::from_raw(outer(dy.slope)), Curvature::from_raw(outer(dx.slope)), Curvature::from_raw(outer(dxy))};
  sample.outside_grid = outside;
  return sample;
}

}  // namespace isotouch::core
