#include "firmware/core/spline_sampler.h"

#include <algorithm>
#include <array>

#include "firmware/core/brick_line.h"
#include "firmware/core/inner_format.h"

namespace isotouch::core {

namespace {

using namespace image_layout;

/// Three neighbours contracted along one axis by the quadratic B-spline: value, first and second derivative at offset t from the middle one.
struct AxisSample {
  std::int32_t value, slope, second;
};

/// t: 32 fraction bits, from -1/2 to below 1/2, so that the upper half of a product is what is wanted. Two products, each below 2^26 * 2^31; what is cut
/// off is below 2^-20.
AxisSample along(std::int32_t before, std::int32_t at, std::int32_t after, std::int32_t t) {
  const std::int32_t second = before - 2 * at + after;
  const std::int32_t rise = after - before;
  const auto slope_change = static_cast<std::int32_t>((std::int64_t{second} * t) >> 32);
  const auto value_change = static_cast<std::int32_t>((std::int64_t{rise + slope_change} * t) >> 32) >> 1;
  return {at + (second >> 3) + value_change, (rise >> 1) + slope_change, second};
}

/// One axis of the point: the three samples around it, numbered 0 to 2.
struct AxisPlace {
  std::int32_t t;       // offset from the middle sample, 32 fraction bits, from -1/2 to below 1/2
  std::int32_t before;  // the brick of sample 0
  std::int32_t after;   // the brick of sample 2
  std::int32_t at;      // place of sample 0 in its brick, 0 to 3

  constexpr std::int32_t in_brick(std::int32_t sample) const { return (at + sample) & 3; }
  // The first sample is never in a brick that is called after, the last one always may be.
  constexpr std::size_t middle_is_after() const { return static_cast<std::size_t>(at + 1) >> kBrickShift; }
};

AxisPlace place(std::int32_t coordinate, std::int32_t size, bool& outside) {
  const std::int32_t inside = std::clamp<std::int32_t>(coordinate, 1 << 16, (size - 2) << 16);
  outside |= inside != coordinate;
  const std::int32_t first = ((inside + 0x8000) >> 16) - 1;  // in [0, size - 3]
  return {(inside - ((first + 1) << 16)) * (1 << 16), first >> kBrickShift, (first + 2) >> kBrickShift, first & 3};
}

/// Three samples in a row along x: where each one's line of bricks begins.
using Row = std::array<const std::int16_t*, 3>;

/// The rows of two columns of bricks around the point, along x: before the point along y, and after it.
using Rows = std::array<Row, 2>;

/// Those of the bricks before the point along z, and of those after it.
std::array<Rows, 2> rows_around(const FieldView& field, const AxisPlace& x, const AxisPlace& y, const AxisPlace& z) {
  const std::int32_t x1 = x.in_brick(1), x2 = x.in_brick(2);
  const auto row = [&](std::int32_t brick_y, std::int32_t brick_z) -> Row {
    const BrickLine bricks(field, brick_y, brick_z);
    const std::int16_t *before = bricks[x.before], *after = bricks[x.after];
    return {before + x.at, (x.at == 3 ? after : before) + x1, after + x2};
  };
  return {Rows{row(y.before, z.before), row(y.after, z.before)}, Rows{row(y.before, z.after), row(y.after, z.after)}};
}

/// Nine samples of constant z, contracted along x and y: the value and its derivatives within the plane.
struct Plane {
  std::int32_t value, dx, dy, dxx, dyy, dxy;
};

inline Plane contract_plane(const Rows& rows, const AxisPlace& x, const AxisPlace& y, std::int32_t layer) {
  const auto contract_row = [&](const Row& row, std::int32_t j) {
    const std::int32_t offset = layer | (y.in_brick(j) << 2);
    const auto sample = [&](std::size_t i) { return to_inner(row[i][offset]); };
    return along(sample(0), sample(1), sample(2), x.t);
  };
  const AxisSample row0 = contract_row(rows[0], 0), row1 = contract_row(rows[y.middle_is_after()], 1), row2 = contract_row(rows[1], 2);
  const AxisSample value = along(row0.value, row1.value, row2.value, y.t);
  const AxisSample slope = along(row0.slope, row1.slope, row2.slope, y.t);
  const std::int32_t dxx = along(row0.second, row1.second, row2.second, y.t).value;
  return {value.value, slope.value, value.slope, dxx, value.second, slope.slope};
}

}  // namespace

void sample_spline(const FieldView& field, const Vec3<Voxel>& point, FieldSample& sample) {
  bool outside = false;
  const AxisPlace x = place(point.x.raw(), field.size[0], outside);
  const AxisPlace y = place(point.y.raw(), field.size[1], outside);
  const AxisPlace z = place(point.z.raw(), field.size[2], outside);
  const std::array<Rows, 2> rows = rows_around(field, x, y, z);

  const auto plane = [&](const Rows& around, std::int32_t k) { return contract_plane(around, x, y, z.in_brick(k) << 4); };
  const Plane p0 = plane(rows[0], 0), p1 = plane(rows[z.middle_is_after()], 1), p2 = plane(rows[1], 2);
  const AxisSample value = along(p0.value, p1.value, p2.value, z.t);
  const AxisSample dx = along(p0.dx, p1.dx, p2.dx, z.t);
  const AxisSample dy = along(p0.dy, p1.dy, p2.dy, z.t);
  const std::int32_t dxx = along(p0.dxx, p1.dxx, p2.dxx, z.t).value;
  const std::int32_t dyy = along(p0.dyy, p1.dyy, p2.dyy, z.t).value;
  const std::int32_t dxy = along(p0.dxy, p1.dxy, p2.dxy, z.t).value;

  sample.distance = Voxel::from_raw(to_outer(value.value));
  sample.gradient = {Slope::from_raw(to_outer(dx.value)), Slope::from_raw(to_outer(dy.value)), Slope::from_raw(to_outer(value.slope))};
  sample.second = {Curvature::from_raw(to_outer(dxx)), Curvature::from_raw(to_outer(dyy)), Curvature::from_raw(to_outer(value.second))};
  sample.mixed = {Curvature::from_raw(to_outer(dy.slope)), Curvature::from_raw(to_outer(dx.slope)), Curvature::from_raw(to_outer(dxy))};
  sample.outside_grid = outside;
}

}  // namespace isotouch::core
