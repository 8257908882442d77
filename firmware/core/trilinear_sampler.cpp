#include "firmware/core/trilinear_sampler.h"

#include <algorithm>
#include <array>

#include "firmware/core/brick_line.h"
#include "firmware/core/inner_format.h"

namespace isotouch::core {

namespace {

using namespace image_layout;

/// a at t = 0, b at t = 1. t: 31 fraction bits, from 0 to below 1. The difference is below 2^26 where both are within ±2^25.
std::int32_t between(std::int32_t a, std::int32_t b, std::int32_t t) {
  return a + static_cast<std::int32_t>((std::int64_t{b - a} * t) >> 31);
}

/// Four numbers in a row, at -1, 0, 1 and 2, and a point at t between the middle two: what linear interpolation gives there.
struct AxisSample {
  std::int32_t value;   // of the numbers
  std::int32_t slope;   // of their central differences
  std::int32_t second;  // how the slope changes
  std::int32_t rise;    // how the value changes
};

AxisSample along(std::int32_t before, std::int32_t low, std::int32_t high, std::int32_t after, std::int32_t t) {
  const std::int32_t at_low = (high - before) >> 1, at_high = (after - low) >> 1;
  return {between(low, high, t), between(at_low, at_high, t), at_high - at_low, high - low};
}

/// One axis of the point: the four samples around it, numbered 0 to 3, the point between 1 and 2.
struct AxisPlace {
  std::int32_t t;       // from sample 1, 31 fraction bits, from 0 to below 1
  std::int32_t before;  // the brick of sample 0
  std::int32_t after;   // the brick of sample 3
  std::int32_t at;      // place of sample 0 in its brick, 0 to 3

  constexpr std::int32_t in_brick(std::int32_t sample) const { return (at + sample) & 3; }
  constexpr std::size_t is_after(std::int32_t sample) const { return static_cast<std::size_t>(at + sample) >> kBrickShift; }
};

AxisPlace place(std::int32_t coordinate, std::int32_t size, bool& outside) {
  // The last place has its sample 3 in the grid: just before size - 2, where a point is far outside anyway.
  const std::int32_t inside = std::clamp<std::int32_t>(coordinate, 1 << 16, ((size - 2) << 16) - 1);
  outside |= coordinate < inside || coordinate > (size - 2) << 16;
  const std::int32_t first = (inside >> 16) - 1;  // in [0, size - 4]
  return {(inside & 0xFFFF) << 15, first >> kBrickShift, (first + 3) >> kBrickShift, first & 3};
}

/// Four samples in a row along x: where each one's line of bricks begins.
using Row = std::array<const std::int16_t*, 4>;

/// The rows of the bricks before and after the point along y, in those before and after it along z.
std::array<std::array<Row, 2>, 2> rows_around(const FieldView& field, const AxisPlace& x, const AxisPlace& y, const AxisPlace& z) {
  const auto row = [&](std::int32_t brick_y, std::int32_t brick_z) -> Row {
    const BrickLine line(field, brick_y, brick_z);
    const std::array<const std::int16_t*, 2> bricks = {line[x.before], line[x.after]};
    const auto sample = [&](std::int32_t i) { return bricks[x.is_after(i)] + x.in_brick(i); };
    return {sample(0), sample(1), sample(2), sample(3)};
  };
  return {{{row(y.before, z.before), row(y.after, z.before)}, {row(y.before, z.after), row(y.after, z.after)}}};
}

/// The samples of one z, contracted along x and y.
struct Plane {
  std::int32_t value, dx, dy, dxx, dyy;
  std::int32_t rise_x, rise_y;  // how the value changes along x and y
  std::int32_t dxy;             // twice the mixed derivative: how dx changes along y and dy along x
};

}  // namespace

void sample_trilinear(const FieldView& field, const Vec3<Voxel>& point, FieldSample& sample) {
  bool outside = false;
  const AxisPlace x = place(point.x.raw(), field.size[0], outside);
  const AxisPlace y = place(point.y.raw(), field.size[1], outside);
  const AxisPlace z = place(point.z.raw(), field.size[2], outside);
  const std::array<std::array<Row, 2>, 2> rows = rows_around(field, x, y, z);

  // Only the rows of the cell itself need slopes; the others are those beyond it, which its central differences reach.
  const auto number = [&](std::int32_t i, std::int32_t j, std::int32_t k) {
    const Row& row = rows[z.is_after(k)][y.is_after(j)];
    return to_inner(row[static_cast<std::size_t>(i)][(z.in_brick(k) << 4) | (y.in_brick(j) << 2)]);
  };
  const auto inner_row = [&](std::int32_t j, std::int32_t k) {
    return along(number(0, j, k), number(1, j, k), number(2, j, k), number(3, j, k), x.t);
  };
  const auto outer_row = [&](std::int32_t j, std::int32_t k) -> AxisSample {
    const std::int32_t low = number(1, j, k), high = number(2, j, k);
    return {between(low, high, x.t), 0, 0, high - low};
  };
  const auto inner_plane = [&](std::int32_t k) -> Plane {
    const AxisSample row0 = outer_row(0, k), row1 = inner_row(1, k), row2 = inner_row(2, k), row3 = outer_row(3, k);
    const AxisSample value = along(row0.value, row1.value, row2.value, row3.value, y.t);
    const AxisSample rise = along(row0.rise, row1.rise, row2.rise, row3.rise, y.t);
    return {
        value.value, between(row1.slope, row2.slope, y.t), value.slope, between(row1.second, row2.second, y.t), value.second, rise.value,
        value.rise,  row2.slope - row1.slope + rise.slope};
  };
  const auto outer_plane = [&](std::int32_t k) -> Plane {
    const AxisSample row1 = outer_row(1, k), row2 = outer_row(2, k);
    return {between(row1.value, row2.value, y.t), 0, 0, 0, 0, between(row1.rise, row2.rise, y.t), row2.value - row1.value, 0};
  };
  const Plane p0 = outer_plane(0), p1 = inner_plane(1), p2 = inner_plane(2), p3 = outer_plane(3);
  const AxisSample value = along(p0.value, p1.value, p2.value, p3.value, z.t);
  const auto across = [&](std::int32_t Plane::*of) { return between(p1.*of, p2.*of, z.t); };
  // Of a mixed derivative with z: how the plane's slope changes from plane to plane, and the slope along z of what changes in the plane.
  const std::int32_t dyz = p2.dy - p1.dy + along(p0.rise_y, p1.rise_y, p2.rise_y, p3.rise_y, z.t).slope;
  const std::int32_t dzx = p2.dx - p1.dx + along(p0.rise_x, p1.rise_x, p2.rise_x, p3.rise_x, z.t).slope;

  sample.distance = Voxel::from_raw(to_outer(value.value));
  sample.gradient = {Slope::from_raw(to_outer(across(&Plane::dx))), Slope::from_raw(to_outer(across(&Plane::dy))),
                     Slope::from_raw(to_outer(value.slope))};
  sample.second = {Curvature::from_raw(to_outer(across(&Plane::dxx))), Curvature::from_raw(to_outer(across(&Plane::dyy))),
                   Curvature::from_raw(to_outer(value.second))};
  sample.mixed = {Curvature::from_raw(to_outer(dyz >> 1)), Curvature::from_raw(to_outer(dzx >> 1)),
                  Curvature::from_raw(to_outer(across(&Plane::dxy) >> 1))};
  sample.outside_grid = outside;
}

}  // namespace isotouch::core
