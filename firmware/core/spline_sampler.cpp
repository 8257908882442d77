#include "firmware/core/spline_sampler.h"

#include <algorithm>
#include <array>
#include <cstring>

#include "firmware/core/brick_line.h"
#include "firmware/core/four.h"
#include "firmware/core/inner_format.h"

namespace isotouch::core {

namespace {

using namespace image_layout;

/// Three neighbours contracted along one axis by the quadratic B-spline: value, first and second derivative at offset t from the middle one. Of one number, or
/// of four at once.
template <class Number>
struct AxisSample {
  Number value, slope, second;
};

/// t: 32 fraction bits, from -1/2 to below 1/2, so that the upper half of a product is what is wanted. Two products, each below 2^26 * 2^31; what is cut
/// off is below 2^-20.
template <class Number>
inline AxisSample<Number> along(Number before, Number at, Number after, Number t) {
  const Number second = before - 2 * at + after;
  const Number rise = after - before;
  const Number slope_change = upper_words(second, t);
  const Number value_change = upper_words(rise + slope_change, t) >> 1;
  return {at + (second >> 3) + value_change, (rise >> 1) + slope_change, second};
}

/// One axis of the point: the three samples around it, numbered 0 to 2.
struct AxisPlace {
  std::int32_t t;       // offset from the middle sample, 32 fraction bits of which the lower 16 are 0, from -1/2 to below 1/2
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

#ifdef ISOTOUCH_FOUR

using Sample = AxisSample<Four>;
using TwoRows = std::uint64_t __attribute__((vector_size(16)));

/// The bricks before and after the point along x, in one line of bricks.
struct BrickPair {
  const std::int16_t *before, *after;
};

/// Two such lines, before and after the point along z.
using Column = std::array<BrickPair, 2>;

Column column(const FieldView& field, const AxisPlace& x, std::int32_t brick_y, const AxisPlace& z) {
  const auto pair = [&](std::int32_t brick_z) -> BrickPair {
    const BrickLine bricks(field, brick_y, brick_z);
    return {bricks[x.before], bricks[x.after]};
  };
  return {pair(z.before), pair(z.after)};
}

/// The four samples of a brick's row.
inline std::uint64_t row_at(const std::int16_t* first) {
  std::uint64_t row = 0;
  std::memcpy(&row, first, sizeof row);
  return row;
}

/// The lower and the upper halves of two vectors, lane beside lane.
inline EightShorts zip_low(EightShorts a, EightShorts b) { return __builtin_shufflevector(a, b, 0, 8, 1, 9, 2, 10, 3, 11); }
inline EightShorts zip_high(EightShorts a, EightShorts b) { return __builtin_shufflevector(a, b, 4, 12, 5, 13, 6, 14, 7, 15); }
inline Four zip_low(Four a, Four b) { return __builtin_shufflevector(a, b, 0, 4, 1, 5); }
inline Four zip_high(Four a, Four b) { return __builtin_shufflevector(a, b, 2, 6, 3, 7); }
inline Four low_halves(Four a, Four b) { return __builtin_shufflevector(a, b, 0, 1, 4, 5); }
inline Four high_halves(Four a, Four b) { return __builtin_shufflevector(a, b, 2, 3, 6, 7); }

inline Four low_to_inner(EightShorts coefficients) {
  return std::bit_cast<Four>(zip_low(EightShorts{}, coefficients)) >> (16 - kRaisedBits);
}
inline Four high_to_inner(EightShorts coefficients) {
  return std::bit_cast<Four>(zip_high(EightShorts{}, coefficients)) >> (16 - kRaisedBits);
}

/// Three rows of constant y, contracted along x: a lane for each z.
inline Sample contract_rows(const Column& column, const AxisPlace& x, const AxisPlace& z, std::int32_t line) {
  const auto offset = [&](std::int32_t k) { return (z.in_brick(k) << 4) | line; };
  const BrickPair &p0 = column[0], &p1 = column[z.middle_is_after()], &p2 = column[1];
  const std::int32_t o0 = offset(0), o1 = offset(1), o2 = offset(2);
  // The first sample goes to the lowest lane of its row. In two shifts, because a row is not shifted by all of its 64 bits.
  const auto from_first = [shift = 16 * static_cast<std::uint64_t>(x.at)](TwoRows before, TwoRows after) {
    return std::bit_cast<EightShorts>((before >> shift) | ((after << 1) << (63 - shift)));
  };
  const EightShorts rows01 =
      from_first(TwoRows{row_at(p0.before + o0), row_at(p1.before + o1)}, TwoRows{row_at(p0.after + o0), row_at(p1.after + o1)});
  const EightShorts rows2 = from_first(TwoRows{row_at(p2.before + o2), 0}, TwoRows{row_at(p2.after + o2), 0});
  const EightShorts even = zip_low(rows01, rows2), odd = zip_high(rows01, rows2);
  const EightShorts before_and_at = zip_low(even, odd), after = zip_high(even, odd);
  return along(low_to_inner(before_and_at), high_to_inner(before_and_at), low_to_inner(after), four(x.t));
}

}  // namespace

/// Rows of three z at once, then what they give.
void sample_spline(const FieldView& field, const Vec3<Voxel>& point, FieldSample& sample) {
  bool outside = false;
  const AxisPlace x = place(point.x.raw(), field.size[0], outside);
  const AxisPlace y = place(point.y.raw(), field.size[1], outside);
  const AxisPlace z = place(point.z.raw(), field.size[2], outside);
  const std::array<Column, 2> columns = {column(field, x, y.before, z), column(field, x, y.after, z)};
  const auto rows = [&](const Column& around, std::int32_t j) { return contract_rows(around, x, z, y.in_brick(j) << 2); };
  const Sample row0 = rows(columns[0], 0), row1 = rows(columns[y.middle_is_after()], 1), row2 = rows(columns[1], 2);
  const Four ty = four(y.t), tz = four(z.t);
  const Sample value = along(row0.value, row1.value, row2.value, ty);
  const Sample slope = along(row0.slope, row1.slope, row2.slope, ty);
  const Four dxx = along(row0.second, row1.second, row2.second, ty).value;

  // From lanes of z to those of value, dx, dy, dxx, and of dyy, dxy.
  const Four value_dx = zip_low(value.value, slope.value), value_dx2 = zip_high(value.value, slope.value);
  const Four dy_dxx = zip_low(value.slope, dxx), dy_dxx2 = zip_high(value.slope, dxx);
  const Four dyy_dxy = zip_low(value.second, slope.slope), dyy_dxy2 = zip_high(value.second, slope.slope);
  const Sample four_of = along(low_halves(value_dx, dy_dxx), high_halves(value_dx, dy_dxx), low_halves(value_dx2, dy_dxx2), tz);
  const Sample two_of = along(dyy_dxy, high_halves(dyy_dxy, dyy_dxy), dyy_dxy2, tz);

  const Four values = to_outer(four_of.value), slopes = to_outer(four_of.slope), seconds = to_outer(four_of.second),
             others = to_outer(two_of.value);
  sample.distance = Voxel::from_raw(values[0]);
  sample.gradient = {Slope::from_raw(values[1]), Slope::from_raw(values[2]), Slope::from_raw(slopes[0])};
  sample.second = {Curvature::from_raw(values[3]), Curvature::from_raw(others[0]), Curvature::from_raw(seconds[0])};
  sample.mixed = {Curvature::from_raw(slopes[2]), Curvature::from_raw(slopes[1]), Curvature::from_raw(others[1])};
  sample.outside_grid = outside;
}

#else

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

using Sample = AxisSample<std::int32_t>;

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
  const Sample row0 = contract_row(rows[0], 0), row1 = contract_row(rows[y.middle_is_after()], 1), row2 = contract_row(rows[1], 2);
  const Sample value = along(row0.value, row1.value, row2.value, y.t);
  const Sample slope = along(row0.slope, row1.slope, row2.slope, y.t);
  const std::int32_t dxx = along(row0.second, row1.second, row2.second, y.t).value;
  return {value.value, slope.value, value.slope, dxx, value.second, slope.slope};
}

}  // namespace

/// Row by row and plane by plane.
void sample_spline(const FieldView& field, const Vec3<Voxel>& point, FieldSample& sample) {
  bool outside = false;
  const AxisPlace x = place(point.x.raw(), field.size[0], outside);
  const AxisPlace y = place(point.y.raw(), field.size[1], outside);
  const AxisPlace z = place(point.z.raw(), field.size[2], outside);
  const std::array<Rows, 2> rows = rows_around(field, x, y, z);
  const auto plane = [&](const Rows& around, std::int32_t k) { return contract_plane(around, x, y, z.in_brick(k) << 4); };
  const Plane p0 = plane(rows[0], 0), p1 = plane(rows[z.middle_is_after()], 1), p2 = plane(rows[1], 2);
  const Sample value = along(p0.value, p1.value, p2.value, z.t);
  const Sample dx = along(p0.dx, p1.dx, p2.dx, z.t);
  const Sample dy = along(p0.dy, p1.dy, p2.dy, z.t);
  const std::int32_t dxx = along(p0.dxx, p1.dxx, p2.dxx, z.t).value;
  const std::int32_t dyy = along(p0.dyy, p1.dyy, p2.dyy, z.t).value;
  const std::int32_t dxy = along(p0.dxy, p1.dxy, p2.dxy, z.t).value;

  sample.distance = Voxel::from_raw(to_outer(value.value));
  sample.gradient = {Slope::from_raw(to_outer(dx.value)), Slope::from_raw(to_outer(dy.value)), Slope::from_raw(to_outer(value.slope))};
  sample.second = {Curvature::from_raw(to_outer(dxx)), Curvature::from_raw(to_outer(dyy)), Curvature::from_raw(to_outer(value.second))};
  sample.mixed = {Curvature::from_raw(to_outer(dy.slope)), Curvature::from_raw(to_outer(dx.slope)), Curvature::from_raw(to_outer(dxy))};
  sample.outside_grid = outside;
}

#endif

}  // namespace isotouch::core
