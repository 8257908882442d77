#include "host/view/markers.h"

#include <cmath>

namespace isotouch::view {
namespace {

std::optional<double> sphere(const Ray& ray, const Eigen::Vector3d& centre, double radius) {
  const Eigen::Vector3d to = centre - ray.from;
  const double along = to.dot(ray.direction);
  const double inside = radius * radius - (to - along * ray.direction).squaredNorm();
  if (inside < 0) return std::nullopt;
  return along - std::sqrt(inside);
}

/// The side of a cylinder between two points; its ends lie in the balls.
std::optional<double> cylinder(const Ray& ray, const Eigen::Vector3d& a, const Eigen::Vector3d& b, double radius) {
  const double length = (b - a).norm();
  if (length < 1e-9) return std::nullopt;
  const Eigen::Vector3d axis = (b - a) / length;
  const auto across = [&](const Eigen::Vector3d& v) { return Eigen::Vector3d(v - v.dot(axis) * axis); };
  const Eigen::Vector3d d = across(ray.direction), f = across(ray.from - a);
  const double dd = d.squaredNorm(), df = d.dot(f), root = df * df - dd * (f.squaredNorm() - radius * radius);
  if (dd < 1e-12 || root < 0) return std::nullopt;
  const double t = (-df - std::sqrt(root)) / dd;
  const double place = (ray.at(t) - a).dot(axis);
  return place >= 0 && place <= length ? std::optional(t) : std::nullopt;
}

}  // namespace

std::optional<Markers::Hit> Markers::hit(const Ray& ray) const {
  std::optional<Hit> first;
  const auto offer = [&](std::optional<double> t, const auto& normal_at, std::uint32_t colour) {
    if (t && (!first || *t < first->t)) first = Hit{*t, normal_at(ray.at(*t)).normalized(), srgb(colour)};
  };
  const auto from = [](const Eigen::Vector3d& centre) {
    return [&centre](const Eigen::Vector3d& p) { return Eigen::Vector3d(p - centre); };
  };
  offer(sphere(ray, touch_.proxy, radius_), from(touch_.proxy), kProxyColour);
  offer(sphere(ray, touch_.hip, radius_), from(touch_.hip), kHipColour);
  const Eigen::Vector3d axis = (touch_.hip - touch_.proxy).normalized();
  const auto off_axis = [&](const Eigen::Vector3d& p) { return Eigen::Vector3d(p - touch_.hip - (p - touch_.hip).dot(axis) * axis); };
  offer(cylinder(ray, touch_.proxy, touch_.hip, radius_ / 3), off_axis, kHipColour);
  return first;
}

}  // namespace isotouch::view
