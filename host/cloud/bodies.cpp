#include "host/cloud/bodies.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace isotouch::cloud {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

/// v / |v|, and a fixed direction where v is too short to have one (the axis of a capsule, the centre of a sphere).
Vector3d direction(const Vector3d& v) {
  const double length = v.norm();
  return length > 1e-150 ? Vector3d(v / length) : Vector3d::UnitX();
}

/// A point seen along an axis: how far along it, how far from it, and which way that is.
struct AxisView {
  double along;
  double across;
  Vector3d outward;
};

AxisView look_along(const Vector3d& p, const Vector3d& start, const Vector3d& axis) {
  const Vector3d offset = p - start;
  const double along = offset.dot(axis);
  const Vector3d radial = offset - along * axis;
  const double across = radial.norm();
  return {along, across, across > 1e-150 ? Vector3d(radial / across) : axis.unitOrthogonal()};
}

/// The nearest point to p on the segment from a to b.
Vector2d nearest_on_segment(const Vector2d& p, const Vector2d& a, const Vector2d& b) {
  const Vector2d ab = b - a;
  const double t = std::clamp((p - a).dot(ab) / ab.squaredNorm(), 0.0, 1.0);
  return a + t * ab;
}

/// Rotation whose rows are an orthonormal right-handed frame.
Eigen::Matrix3d frame(const Vector3d& first, const Vector3d& second) {
  const Vector3d u = direction(first);
  const Vector3d v = direction(second - second.dot(u) * u);
  Eigen::Matrix3d rows;
  rows << u.transpose(), v.transpose(), u.cross(v).transpose();
  return rows;
}

}  // namespace

Body sphere(const Vector3d& centre, double radius) {
  return {[=](const Vector3d& p) { return Probe{(p - centre).norm() - radius, direction(p - centre)}; }, centre, radius};
}

Body capsule(const Vector3d& a, const Vector3d& b, double radius) {
  const Vector3d ab = b - a;
  return {[=](const Vector3d& p) {
            const double t = std::clamp((p - a).dot(ab) / ab.squaredNorm(), 0.0, 1.0);
            const Vector3d from_axis = p - (a + t * ab);
            return Probe{from_axis.norm() - radius, direction(from_axis)};
          },
          0.5 * (a + b), 0.5 * ab.norm() + radius};
}

Body round_cone(const Vector3d& a, double radius_a, const Vector3d& b, double radius_b) {
  const double length = (b - a).norm();
  const Vector3d axis = (b - a) / length;
  const double slope = (radius_a - radius_b) / length;  // sine of the mantle's half angle
  const double rise = std::sqrt(1.0 - slope * slope);
  return {[=](const Vector3d& p) {
            const AxisView view = look_along(p, a, axis);
            const double foot = view.along * rise - view.across * slope;  // where along the mantle's direction the point's foot lies
            if (foot < 0.0) return Probe{(p - a).norm() - radius_a, direction(p - a)};
            if (foot > length * rise) return Probe{(p - b).norm() - radius_b, direction(p - b)};
            return Probe{view.across * rise + view.along * slope - radius_a, rise * view.outward + slope * axis};
          },
          0.5 * (a + b), 0.5 * length + std::max(radius_a, radius_b)};
}

Body cone_stump(const Vector3d& a, double radius_a, const Vector3d& b, double radius_b) {
  const double length = (b - a).norm();
  const Vector3d axis = (b - a) / length;
  const Vector2d mantle_out = Vector2d(length, radius_a - radius_b).normalized();  // (across, along)
  return {[=](const Vector3d& p) {
            const AxisView view = look_along(p, a, axis);
            const Vector2d q(view.across, view.along);
            const double under = -view.along;
            const double over = view.along - length;
            const double beside = (q - Vector2d(radius_a, 0.0)).dot(mantle_out);
            const double deepest = std::max({under, over, beside});
            const auto in_space = [&](const Vector2d& d) { return Vector3d(d.x() * view.outward + d.y() * axis); };
            const auto flat = [&](double depth) { return depth == beside ? in_space(mantle_out) : depth == over ? axis : Vector3d(-axis); };
            if (deepest <= 0.0) return Probe{deepest, flat(deepest)};
            const std::array<Vector2d, 3> nearest = {nearest_on_segment(q, Vector2d(0.0, 0.0), Vector2d(radius_a, 0.0)),
                                                     nearest_on_segment(q, Vector2d(radius_a, 0.0), Vector2d(radius_b, length)),
                                                     nearest_on_segment(q, Vector2d(0.0, length), Vector2d(radius_b, length))};
            const Vector2d foot = *std::min_element(nearest.begin(), nearest.end(), [&](const Vector2d& l, const Vector2d& r) {
              return (q - l).squaredNorm() < (q - r).squaredNorm();
            });
            const double away = (q - foot).norm();
            if (away <= deepest + 1e-12 * length)
              return Probe{away, flat(deepest)};  // the foot lies within a flat part: its normal is known exactly
            return Probe{away, in_space((q - foot) / away)};
          },
          0.5 * (a + b), 0.5 * length + std::max(radius_a, radius_b)};
}

Body cylinder(const Vector3d& a, const Vector3d& b, double radius) {
  const Vector3d centre = 0.5 * (a + b);
  const double half_length = 0.5 * (b - a).norm();
  const Vector3d axis = (b - a).normalized();
  return {[=](const Vector3d& p) {
            const AxisView view = look_along(p, centre, axis);
            const Vector3d cap_out = view.along < 0.0 ? Vector3d(-axis) : axis;
            const double beyond_cap = std::abs(view.along) - half_length;
            const double beyond_mantle = view.across - radius;
            if (beyond_cap <= 0.0 || beyond_mantle <= 0.0) {
              return beyond_cap > beyond_mantle ? Probe{beyond_cap, cap_out} : Probe{beyond_mantle, view.outward};
            }
            const double away = std::sqrt(beyond_cap * beyond_cap + beyond_mantle * beyond_mantle);
            return Probe{away, (beyond_cap * cap_out + beyond_mantle * view.outward) / away};
          },
          centre, half_length + radius};
}

Body torus(const Vector3d& centre, const Vector3d& axis, double ring, double tube) {
  const Vector3d unit_axis = direction(axis);
  return {[=](const Vector3d& p) {
            const AxisView view = look_along(p, centre, unit_axis);
            const Vector3d from_ring = p - (centre + ring * view.outward);
            return Probe{from_ring.norm() - tube, direction(from_ring)};
          },
          centre, ring + tube};
}

Body box(const Vector3d& centre, const Vector3d& half_extents, double rounding) {
  const Vector3d core = half_extents - Vector3d::Constant(rounding);
  return {[=](const Vector3d& p) {
            const Vector3d offset = p - centre;
            const Vector3d beyond = offset.cwiseAbs() - core;
            const Vector3d side = offset.unaryExpr([](double v) { return v < 0.0 ? -1.0 : 1.0; });
            const Vector3d outside = beyond.cwiseMax(0.0);
            const double away = outside.norm();
            if (away > 0.0) return Probe{away - rounding, outside.cwiseProduct(side) / away};
            Eigen::Index nearest_face = 0;
            const double depth = beyond.maxCoeff(&nearest_face);
            return Probe{depth - rounding, side[nearest_face] * Vector3d::Unit(nearest_face)};
          },
          centre, half_extents.norm()};
}

Body ellipsoid(const Vector3d& centre, const Vector3d& semi_axes, const Vector3d& first, const Vector3d& second) {
  const Eigen::Matrix3d to_axes = frame(first, second);
  const double smallest = semi_axes.minCoeff();
  return {[=](const Vector3d& p) {
            const Vector3d scaled = (to_axes * (p - centre)).cwiseQuotient(semi_axes);
            const double radius = scaled.norm();
            if (radius < 1e-9) return Probe{-smallest, to_axes.row(0).transpose()};
            const Vector3d slope = to_axes.transpose() * scaled.cwiseQuotient(semi_axes) / radius;  // of `radius`, at most 1 / smallest
            // Dividing by the slope would give the distance to first order, but a function that may change faster than the point moves.
            return Probe{(radius - 1.0) * smallest, direction(slope)};
          },
          centre, semi_axes.maxCoeff()};
}

Body half_space(const Vector3d& point, const Vector3d& normal) {
  const Vector3d unit = direction(normal);
  return {[=](const Vector3d& p) { return Probe{(p - point).dot(unit), unit}; }, point, std::numeric_limits<double>::infinity()};
}

Body unite(std::vector<Body> parts) {
  Vector3d centre = Vector3d::Zero();
  for (const Body& part : parts) centre += part.centre / static_cast<double>(parts.size());
  double radius = 0.0;
  for (const Body& part : parts) radius = std::max(radius, (part.centre - centre).norm() + part.radius);
  const auto probe = [parts = std::move(parts)](const Vector3d& p) {
    Probe nearest = parts.front()(p);
    for (std::size_t i = 1; i < parts.size(); ++i) {
      const double reach = parts[i].radius + nearest.distance;  // a ball farther than this holds nothing nearer
      if (reach <= 0.0 || (p - parts[i].centre).squaredNorm() >= reach * reach) continue;
      const Probe part = parts[i](p);
      if (part.distance < nearest.distance) nearest = part;
    }
    return nearest;
  };
  return {probe, centre, radius};
}

Body intersect(std::vector<Body> parts) {
  const Body smallest = *std::min_element(parts.begin(), parts.end(), [](const Body& a, const Body& b) { return a.radius < b.radius; });
  const auto probe = [parts = std::move(parts)](const Vector3d& p) {
    Probe farthest = parts.front()(p);
    for (std::size_t i = 1; i < parts.size(); ++i) {
      const Probe part = parts[i](p);
      if (part.distance > farthest.distance) farthest = part;
    }
    return farthest;
  };
  return {probe, smallest.centre, smallest.radius};
}

Body subtract(const Body& from, const Body& what) {
  const auto probe = [from, what](const Vector3d& p) {
    const Probe kept = from(p);
    const Probe hole = what(p);
    return kept.distance >= -hole.distance ? kept : Probe{-hole.distance, -hole.gradient};
  };
  return {probe, from.centre, from.radius};
}

Body mirror_x(const Body& half) {
  const auto probe = [half](const Vector3d& p) {
    Probe mirrored = half(Vector3d(std::abs(p.x()), p.y(), p.z()));
    if (p.x() < 0.0) mirrored.gradient.x() = -mirrored.gradient.x();
    return mirrored;
  };
  return {probe, {0.0, half.centre.y(), half.centre.z()}, std::abs(half.centre.x()) + half.radius};
}

}  // namespace isotouch::cloud
