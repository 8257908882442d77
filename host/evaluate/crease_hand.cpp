#include "host/evaluate/crease_hand.h"

#include <utility>

namespace isotouch::evaluate {

using Eigen::Vector3d;

namespace {

constexpr double kTurning = 0.2;     // share of the way to the new direction in one tick, as a steered hand's
constexpr double kSamePlace = 1e-6;  // mm

}  // namespace

CreaseHand::CreaseHand(const std::vector<SharpEdge>& creases, const EdgePlace& place, FeltPath& path, double depth)
    : creases_(creases),
      path_(path),
      depth_(depth),
      at_(place.point),
      end_(place.edge.end),
      start_(place.edge.begin),
      normals_(place.edge.normals),
      way_(below(0)) {}

/// The unit way from the crease to the hand.
Vector3d CreaseHand::below(double side) const { return -((1 - side) * normals_[0] + (1 + side) * normals_[1]).normalized(); }

void CreaseHand::sink(double mm_per_tick) { path_.move(at_ + depth_ * way_, mm_per_tick); }

void CreaseHand::step(double ahead, double side) {
  walk(ahead);
  way_ = (way_ + kTurning * (below(side) - way_)).normalized();
  path_.step(at_ + depth_ * way_);
}

void CreaseHand::walk(double ahead) {
  const double left = (end_ - at_).norm();
  if (ahead < left) {
    at_ += ahead / left * (end_ - at_);
    return;
  }
  at_ = end_;
  const Vector3d along = (end_ - start_).normalized();
  std::swap(start_, end_);
  const SharpEdge* found = nullptr;
  double straightest = 0;
  for (const SharpEdge& edge : creases_) {
    for (const auto& [near, far] : {std::pair(edge.begin, edge.end), std::pair(edge.end, edge.begin)}) {
      const double straight = along.dot((far - near).normalized());
      if ((near - at_).norm() > kSamePlace || straight <= straightest) continue;
      straightest = straight;
      found = &edge;
      start_ = near;
      end_ = far;
    }
  }
  if (found == nullptr) return;
  const auto& [first, second] = found->normals;
  const bool same_order = first.dot(normals_[0]) + second.dot(normals_[1]) >= second.dot(normals_[0]) + first.dot(normals_[1]);
  normals_ = same_order ? std::array{first, second} : std::array{second, first};
}

}  // namespace isotouch::evaluate
