#include "tests/support/reference.h"

#include <algorithm>

namespace isotouch::test {

namespace {

/// The centred quadratic B-spline and its first two derivatives; a border belongs to the piece on its right.
std::array<double, 3> spline(double t) {
  const double a = std::abs(t), sign = t < 0 ? -1.0 : 1.0;
  if (t >= -0.5 && t < 0.5) return {0.75 - t * t, -2 * t, -2};
  if (t >= -1.5 && t < 1.5) return {(1.5 - a) * (1.5 - a) / 2, -sign * (1.5 - a), 1};
  return {0, 0, 0};
}

/// The distance and its central differences at one sample.
struct AtNode {
  double distance;
  Point slope;
};

AtNode at_node(const FieldView& field, const std::array<std::int32_t, 3>& node) {
  const auto distance = [&](std::int32_t di, std::int32_t dj, std::int32_t dk) {
    return field.coefficient(node[0] + di, node[1] + dj, node[2] + dk) / 4096.0;
  };
  return {distance(0, 0, 0),
          {(distance(1, 0, 0) - distance(-1, 0, 0)) / 2, (distance(0, 1, 0) - distance(0, -1, 0)) / 2,
           (distance(0, 0, 1) - distance(0, 0, -1)) / 2}};
}

ReferenceSample trilinear_sample(const FieldView& field, const Point& index) {
  ReferenceSample sample{};
  std::array<std::int32_t, 3> low{};
  for (std::size_t axis = 0; axis < 3; ++axis) low[axis] = static_cast<std::int32_t>(std::floor(index[axis]));
  std::array<Point, 3> change{};  // change[a]: the gradient's derivative along axis a
  for (std::int32_t corner = 0; corner < 8; ++corner) {
    std::array<std::int32_t, 3> node{};
    Point weight{}, change_of_weight{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      node[axis] = low[axis] + (corner >> axis & 1);
      weight[axis] = 1 - std::abs(index[axis] - node[axis]);
      change_of_weight[axis] = node[axis] == low[axis] ? -1 : 1;
    }
    const AtNode here = at_node(field, node);
    const double share = weight[0] * weight[1] * weight[2];
    sample.distance += here.distance * share;
    sample.gradient = sample.gradient + here.slope * share;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double rest = weight[(axis + 1) % 3] * weight[(axis + 2) % 3];
      change[axis] = change[axis] + here.slope * (change_of_weight[axis] * rest);
    }
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t next = (axis + 1) % 3, last = (axis + 2) % 3;
    sample.second[axis] = change[axis][axis];
    sample.mixed[axis] = (change[next][last] + change[last][next]) / 2;
  }
  return sample;
}

}  // namespace

ReferenceSample reference_sample(const FieldView& field, const Point& index) {
  if (field.interpolation == Interpolation::kTrilinear) return trilinear_sample(field, index);
  ReferenceSample sample{};
  std::array<std::int32_t, 3> nearest{};
  for (std::size_t axis = 0; axis < 3; ++axis) nearest[axis] = static_cast<std::int32_t>(std::floor(index[axis] + 0.5));
  for (std::int32_t dk = -1; dk <= 1; ++dk) {
    for (std::int32_t dj = -1; dj <= 1; ++dj) {
      for (std::int32_t di = -1; di <= 1; ++di) {
        const std::int32_t i = nearest[0] + di, j = nearest[1] + dj, k = nearest[2] + dk;
        const double c = field.coefficient(i, j, k) / 4096.0;
        const auto x = spline(index[0] - i), y = spline(index[1] - j), z = spline(index[2] - k);
        sample.distance += c * x[0] * y[0] * z[0];
        sample.gradient = sample.gradient + Point{x[1] * y[0] * z[0], x[0] * y[1] * z[0], x[0] * y[0] * z[1]} * c;
        sample.second = sample.second + Point{x[2] * y[0] * z[0], x[0] * y[2] * z[0], x[0] * y[0] * z[2]} * c;
        sample.mixed = sample.mixed + Point{x[0] * y[1] * z[1], x[1] * y[0] * z[1], x[1] * y[1] * z[0]} * c;
      }
    }
  }
  return sample;
}

ReferenceStiffness reference_stiffness(const FieldView& field, const Point& index) {
  const Point place = (index - Point{1.5, 1.5, 1.5}) * 0.25;  // brick centres at whole numbers
  std::array<std::int32_t, 3> middle{};
  for (std::size_t axis = 0; axis < 3; ++axis) middle[axis] = static_cast<std::int32_t>(std::floor(place[axis] + 0.5));
  double sum = 0, known = 0;
  Point sum_slope{}, known_slope{};
  for (std::int32_t n = 0; n < 27; ++n) {
    const std::array<std::int32_t, 3> step = {n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1};
    std::array<std::int32_t, 3> cell{};
    Point weight, slope;  // of the quadratic B-spline and of its derivative
    for (std::size_t axis = 0; axis < 3; ++axis) {
      cell[axis] = middle[axis] + step[axis];
      const double t = place[axis] - cell[axis], size = std::abs(t);
      weight[axis] = size <= 0.5 ? 0.75 - t * t : (1.5 - size) * (1.5 - size) / 2;
      slope[axis] = size <= 0.5 ? -2 * t : (t > 0 ? size - 1.5 : 1.5 - size);
    }
    const int part = field.stiffness_parts[field.brick_number(4 * cell[0], 4 * cell[1], 4 * cell[2])];
    const double all = weight[0] * weight[1] * weight[2];
    const Point change = Point{slope[0] * weight[1] * weight[2], weight[0] * slope[1] * weight[2], weight[0] * weight[1] * slope[2]} * 0.25;
    sum += all * part / 255;
    sum_slope = sum_slope + change * (part / 255.0);
    known += part > 0 ? all : 0;
    if (part > 0) known_slope = known_slope + change;
  }
  return {sum / known, sum_slope * (1 / sum) - known_slope * (1 / known)};
}

Point reference_step(const Point& pull, const ReferenceSample& s) {
  const auto shortened = [](const Point& v, double limit) { return length(v) > limit ? v * (limit / length(v)) : v; };
  constexpr double slide_limit = 1.25, restore_first = 32, min_bend = 0.5;
  const double slope_square = std::max(dot(s.gradient, s.gradient), 1.0 / 64);
  const double free_way = std::max(s.distance, 0.0), buried = std::max(-s.distance, 0.0);
  const double clearance = s.distance + dot(s.gradient, pull);
  const Point onto = s.gradient * (-s.distance / slope_square);
  if (clearance >= 0) {
    const Point step = shortened(pull, std::max(0.0, free_way + slide_limit - restore_first * buried));
    return buried > 0 ? step + shortened(onto, free_way + slide_limit) : step;
  }
  const double depth = -clearance / slope_square;
  const Point along = pull - s.gradient * (dot(s.gradient, pull) / slope_square);

  // H restricted to the tangent plane, in an orthonormal basis of it, and its eigenvectors there
  const Frame frame(s.gradient);
  const auto hessian_times = [&](const Point& v) {
    return Point{s.second[0] * v[0] + s.mixed[2] * v[1] + s.mixed[1] * v[2], s.mixed[2] * v[0] + s.second[1] * v[1] + s.mixed[0] * v[2],
                 s.mixed[1] * v[0] + s.mixed[0] * v[1] + s.second[2] * v[2]};
  };
  const double a = dot(frame.y, hessian_times(frame.y)), b = dot(frame.y, hessian_times(frame.z)), c = dot(frame.z, hessian_times(frame.z));
  const double spread = std::sqrt((a - c) * (a - c) / 4 + b * b);
  const double low = (a + c) / 2 - spread, high = (a + c) / 2 + spread;
  const double turn = std::atan2(2 * b, a - c) / 2;  // of the eigenvector of the higher eigenvalue against frame.y
  const Point e_high = frame.y * std::cos(turn) + frame.z * std::sin(turn), e_low = frame.z * std::cos(turn) - frame.y * std::sin(turn);
  const double b_low = std::max(std::abs(1 - depth * low), min_bend);
  const double b_high = std::max(std::abs(1 - depth * high), min_bend);
  const Point slide = e_low * (dot(along, e_low) / b_low) + e_high * (dot(along, e_high) / b_high);
  const Point way = shortened(slide, std::max(0.0, slide_limit + free_way / 2 - restore_first * buried));
  return shortened(onto + way, free_way + slide_limit);
}

}  // namespace isotouch::test
