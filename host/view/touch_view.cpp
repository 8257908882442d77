#include "host/view/touch_view.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace isotouch::view {
namespace {

constexpr double kBeyond = 1e5;   // mm: beyond everything
constexpr double kSlanted = 55;   // degrees: the surface is seen, and so is what sticks out of it
constexpr double kHidden = 1000;  // more than any angle costs

double angle_deg(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::acos(std::clamp(a.dot(b), -1.0, 1.0)) * 180 / std::numbers::pi;
}

}  // namespace

double slant_cost(const Touch& touch, const Direction& direction) {
  return std::fabs(angle_deg(direction.towards_eye(), touch.out()) - kSlanted);
}

double view_cost(const Touch& touch, const Direction& direction, const FieldRays& rays) {
  const Eigen::Vector3d eye = direction.towards_eye();
  const bool hidden = rays.hit({touch.proxy + 2 * rays.edge() * touch.out(), eye}, 0, kBeyond).has_value();
  return slant_cost(touch, direction) + (hidden ? kHidden : 0);
}

Direction direction_showing(const Touch& touch, const FieldRays& rays, char up) {
  const Direction standard{.up = up};
  Direction best = standard;
  double best_cost = 1e9;
  for (const double elevation : {20.0, 40.0, 0.0, -20.0}) {
    for (int turn = 0; turn < 24; ++turn) {
      const Direction candidate{-165.0 + 15.0 * turn, elevation, up};
      const double walk = angle_deg(candidate.towards_eye(), standard.towards_eye());
      const double cost = view_cost(touch, candidate, rays) + 0.5 * walk;
      if (cost < best_cost) {
        best_cost = cost;
        best = candidate;
      }
    }
  }
  return best;
}

}  // namespace isotouch::view
