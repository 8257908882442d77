#include "host/view/markers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "host/view/palette.h"

namespace isotouch::view {
namespace {

using Eigen::Vector3d;

constexpr double kShaft = 0.3;  // radii: of the bar and of the arrow's shaft
constexpr double kHead = 0.9;   // of the arrow's head

std::optional<Markers::Hit> ball(const Ray& ray, const Vector3d& centre, double radius) {
  const Vector3d to = centre - ray.from;
  const double along = to.dot(ray.direction);
  const double inside = radius * radius - (to - along * ray.direction).squaredNorm();
  if (inside < 0) return std::nullopt;
  const double t = along - std::sqrt(inside);
  return Markers::Hit{t, (ray.at(t) - centre).normalized(), kProxyColour};
}

std::optional<Markers::Hit> cube(const Ray& ray, const Vector3d& centre, double half) {
  double enter = -1e9, leave = 1e9;
  int face = 0;
  for (int a = 0; a < 3; ++a) {
    const double inverse = 1 / (std::fabs(ray.direction[a]) > 1e-12 ? ray.direction[a] : 1e-12);
    const double t0 = (centre[a] - half - ray.from[a]) * inverse, t1 = (centre[a] + half - ray.from[a]) * inverse;
    if (std::min(t0, t1) > enter) {
      enter = std::min(t0, t1);
      face = a;
    }
    leave = std::min(leave, std::max(t0, t1));
  }
  if (enter > leave) return std::nullopt;
  const Vector3d normal = (ray.direction[face] > 0 ? -1.0 : 1.0) * Vector3d::Unit(face);
  return Markers::Hit{enter, normal, kHipColour};
}

}  // namespace

std::optional<Markers::Hit> Markers::Bar::hit(const Ray& ray) const {
  // Where the distance from the axis is the radius at that height: a quadratic equation in t.
  const Vector3d to = ray.from - from;
  const double height = to.dot(axis), climb = ray.direction.dot(axis);
  const Vector3d across = to - height * axis, way = ray.direction - climb * axis;
  const double taper = (to_radius - from_radius) / length;
  const double radius = from_radius + taper * height;
  const double a = way.squaredNorm() - taper * taper * climb * climb;
  const double b = way.dot(across) - taper * climb * radius;
  const double root = b * b - a * (across.squaredNorm() - radius * radius);
  if (std::fabs(a) < 1e-12 || root < 0) return std::nullopt;
  std::array<double, 2> places = {(-b - std::sqrt(root)) / a, (-b + std::sqrt(root)) / a};
  if (places[0] > places[1]) std::swap(places[0], places[1]);
  for (const double t : places) {
    const double at = height + t * climb;
    if (at < 0 || at > length) continue;
    const Vector3d normal = ((across + t * way).normalized() - taper * axis).normalized();
    return Hit{t, normal.dot(ray.direction) > 0 ? Vector3d(-normal) : normal, colour};
  }
  return std::nullopt;
}

Markers::Markers(const Touch& touch, double radius, double arrow) : touch_(touch), radius_(radius) {
  if (touch.depth_mm() > 1e-9) bars_.push_back({touch.hip, touch.out(), touch.depth_mm(), kShaft * radius, kShaft * radius, kHipColour});
  if (touch.force.norm() > 1e-9 && arrow > 0) {
    const Vector3d along = touch.force.normalized();
    const double head = std::min(2.2 * radius, 0.6 * arrow);
    bars_.push_back({touch.proxy, along, arrow - head, kShaft * radius, kShaft * radius, kForceColour});
    bars_.push_back({touch.proxy + (arrow - head) * along, along, head, kHead * radius, 0, kForceColour});
  }
}

std::optional<Markers::Hit> Markers::hit(const Ray& ray) const {
  std::optional<Hit> first;
  const auto offer = [&](const std::optional<Hit>& found) {
    if (found && (!first || found->t < first->t)) first = found;
  };
  offer(ball(ray, touch_.proxy, radius_));
  offer(cube(ray, touch_.hip, 0.85 * radius_));
  for (const Bar& bar : bars_) offer(bar.hit(ray));
  return first;
}

void draw_proxy(Canvas& canvas, Point at, float radius) {
  canvas.disc(at, radius + 0.2F * radius, srgb(0xFFFFFF), 0.8F);
  canvas.disc(at, radius, kProxyColour);
}

void draw_hip(Canvas& canvas, Point at, float radius) {
  const float half = 0.85F * radius, outer = half + 0.2F * radius;
  canvas.fill({at.x - outer, at.y - outer, at.x + outer, at.y + outer}, srgb(0xFFFFFF), 0.8F);
  canvas.fill({at.x - half, at.y - half, at.x + half, at.y + half}, kHipColour);
}

void draw_force(Canvas& canvas, Point from, Point to, float width) {
  const Point way = to - from;
  const float length = std::hypot(way.x, way.y);
  if (length < 1e-3F) return;
  const Point along = way * (1 / length), side{-along.y, along.x};
  const float head = std::min(4 * width, length);
  const Point foot = to - along * head;
  const std::array<Polyline, 2> lines = {Polyline{from, to}, Polyline{foot + side * (0.6F * head), to, foot - side * (0.6F * head)}};
  canvas.stroke(lines, 2.2F * width, srgb(0xFFFFFF), 0.8F);
  canvas.stroke(lines, width, kForceColour);
}

}  // namespace isotouch::view
