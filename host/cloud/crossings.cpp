#include "host/cloud/crossings.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "host/cloud/random.h"
#include "host/error.h"

namespace isotouch::cloud {
namespace {

using Eigen::Vector3d;

/// Uniform in the unit ball, without its innermost part, which has no good direction.
Vector3d in_ball(Random& random) {
  for (;;) {
    const double x = random.uniform(-1.0, 1.0);
    const double y = random.uniform(-1.0, 1.0);
    const double z = random.uniform(-1.0, 1.0);
    const Vector3d v(x, y, z);
    if (v.squaredNorm() <= 1.0 && v.squaredNorm() > 1e-4) return v;
  }
}

/// Start on the ball of radius 1 about the origin; uniform over all lines that meet the ball.
struct Line {
  Vector3d start;
  Vector3d direction;
  double length;
};

Line random_line(Random& random) {
  const Vector3d direction = in_ball(random).normalized();
  const Vector3d u = direction.unitOrthogonal();
  const Vector3d v = direction.cross(u);
  for (;;) {
    const double a = random.uniform(-1.0, 1.0);
    const double b = random.uniform(-1.0, 1.0);
    const double squared = a * a + b * b;
    if (squared >= 1.0) continue;
    const double half_chord = std::sqrt(1.0 - squared);
    return {a * u + b * v - half_chord * direction, direction, 2.0 * half_chord};
  }
}

}  // namespace

Crossings crossings(const Shape& shape, std::size_t count, std::uint64_t seed) {
  const Vector3d centre = 0.5 * (shape.low + shape.high);
  const double radius = 0.5 * (shape.high - shape.low).norm();
  const double shortest_step = 1e-5 * radius;
  Random random(seed);
  Crossings found;
  std::size_t lines = 0;
  while (found.points.size() < count) {
    if (++lines > 10000 + 1000 * count) throw InputError("the shape has no surface within its box");
    const Line line = random_line(random);
    const auto at = [&](double t) { return Vector3d(centre + radius * line.start + t * line.direction); };
    const double end = radius * line.length;
    double here = 0.0;
    double distance = shape.distance(at(here));
    while (here < end && found.points.size() < count) {
      const double there = std::min(here + std::max(std::abs(distance), shortest_step), end);
      const double next = shape.distance(at(there));
      if ((distance < 0.0) != (next < 0.0)) {
        double before = here;
        double after = there;
        for (int halving = 0; halving < 60; ++halving) {
          const double middle = 0.5 * (before + after);
          if (middle <= before || middle >= after) break;
          ((shape.distance(at(middle)) < 0.0) == (distance < 0.0) ? before : after) = middle;
        }
        found.points.positions.push_back(at(after));
        found.points.normals.push_back(shape.normal(at(after)));
      }
      here = there;
      distance = next;
    }
  }
  constexpr double kPi = 3.14159265358979323846;
  found.area = static_cast<double>(found.points.size()) / static_cast<double>(lines) * 2.0 * kPi * radius * radius;
  return found;
}

}  // namespace isotouch::cloud
