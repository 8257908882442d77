#include "host/view/camera.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace isotouch::view {
namespace {

constexpr double kHalfAngleDeg = 11;  // of the field of view, along the shorter side of the area
constexpr double kMargin = 1.03;      // free space around the points

double radians(double degrees) { return degrees * std::numbers::pi / 180.0; }

}  // namespace

Eigen::Vector3d Direction::up_axis() const {
  return up == 'x' ? Eigen::Vector3d::UnitX() : up == 'z' ? Eigen::Vector3d::UnitZ() : Eigen::Vector3d::UnitY();
}

Eigen::Vector3d Direction::towards_eye() const {
  const Eigen::Vector3d right = up == 'x' ? Eigen::Vector3d(-Eigen::Vector3d::UnitY()) : Eigen::Vector3d::UnitX();
  const Eigen::Vector3d front = right.cross(up_axis());
  const double azimuth = radians(azimuth_deg), elevation = radians(elevation_deg);
  return std::cos(elevation) * (std::sin(azimuth) * right + std::cos(azimuth) * front) + std::sin(elevation) * up_axis();
}

Camera::Camera(const Eigen::Vector3d& towards_eye, const Eigen::Vector3d& up, std::span<const Eigen::Vector3d> points, const Rect& area)
    : back_(towards_eye.normalized()),
      centre_x_(static_cast<double>(area.left + area.right) / 2),
      centre_y_(static_cast<double>(area.top + area.bottom) / 2) {
  right_ = up.cross(back_);
  if (right_.norm() < 1e-6) right_ = back_.unitOrthogonal();
  right_.normalize();
  up_ = back_.cross(right_);
  const double half_width = static_cast<double>(area.width()) / 2, half_height = static_cast<double>(area.height()) / 2;
  focus_ = std::min(half_width, half_height) / std::tan(radians(kHalfAngleDeg));

  // A point (x, y, z) in the picture's axes lies in the area when |x - shift| <= slope * (distance - z). The extremes of x + slope * z and
  // -x + slope * z give the shift and the least distance at once; the same for y.
  struct Reach {
    double slope, plus = -1e300, minus = -1e300;
    void add(double side, double z) {
      plus = std::max(plus, side + slope * z);
      minus = std::max(minus, -side + slope * z);
    }
    double shift() const { return (plus - minus) / 2; }
    double distance() const { return (plus + minus) / 2 / slope; }
  };
  Reach x{half_width / focus_ / kMargin}, y{half_height / focus_ / kMargin};
  double nearest = -1e300;
  for (const Eigen::Vector3d& p : points) {
    x.add(p.dot(right_), p.dot(back_));
    y.add(p.dot(up_), p.dot(back_));
    nearest = std::max(nearest, p.dot(back_));
  }
  const double distance = std::max({x.distance(), y.distance(), nearest + 1e-3});  // one point alone would put the eye on itself
  eye_ = x.shift() * right_ + y.shift() * up_ + distance * back_;
}

Ray Camera::ray(double x, double y) const {
  const Eigen::Vector3d direction = (x - centre_x_) * right_ - (y - centre_y_) * up_ - focus_ * back_;
  return {eye_, direction.normalized()};
}

Camera::Projected Camera::project(const Eigen::Vector3d& point) const {
  const Eigen::Vector3d p = point - eye_;
  const double distance = -p.dot(back_);
  const double scale = focus_ / distance;
  return {centre_x_ + p.dot(right_) * scale, centre_y_ - p.dot(up_) * scale, distance, scale};
}

}  // namespace isotouch::view
