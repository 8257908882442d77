#include "host/evaluate/god_object.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace isotouch::evaluate {

using Eigen::Vector3d;
using field::TriangleTree;

namespace {

// Gaps by which a face reaches beyond its edges and to both sides of its plane: far above what doubles round. Of 0.5, 0.25, 0.1 and 0.01 this one
// left the fewest hands on a rough ball short of the nearest place, 2026-11-28.
constexpr double kSkin = 0.25;
constexpr int kPasses = 1000;        // of one tick; some tens on the finest meshes at 1 m/s
constexpr double kParallel = 1e-12;  // determinant of unit normals below which planes count as parallel

}  // namespace

GodObject::GodObject(const TriangleTree& tree, const Vector3d& start) : tree_(tree), position_(start) {
  const auto& box = tree.box(TriangleTree::root());
  gap_ = kGap * (box.high - box.low).maxCoeff();
}

bool GodObject::first_on_way(const Vector3d& way, Obstacle& found) const {
  const Vector3d end = position_ + way;
  const Vector3d low = position_.cwiseMin(end) - Vector3d::Constant(gap_);
  const Vector3d high = position_.cwiseMax(end) + Vector3d::Constant(gap_);
  const double skin = kSkin * gap_;
  found.share = std::numeric_limits<double>::max();
  const auto meets = [&](const TriangleTree::Box& box) {
    return (box.low.array() <= high.array()).all() && (box.high.array() >= low.array()).all();
  };
  tree_.visit(meets, [&](std::uint32_t face) {
    const auto [a, b, c] = tree_.corners(face);
    const Vector3d ab = b - a, ac = c - a, across = ab.cross(ac), to = position_ - a;
    const double slope = -way.dot(across);
    if (!(slope > 0)) return;  // along the face or out of it
    const double size = across.norm();
    const double ahead = to.dot(across) / size, down = slope / size;  // in front of the face, and nearer on the way
    const double share = (ahead - gap_) / down;
    // The part of the way that runs in the face's skin. Where the way crosses the plane itself is no measure: along a face it hardly comes down, and
    // that place is known no better than to 1e-8 of the way.
    double from = std::max((ahead - skin) / down, 0.0), until = std::min((ahead + skin) / down, 1.0);
    if (share >= found.share || from > until) return;
    const Vector3d normal = across / size;
    const auto cut = [&](const Vector3d& side, const Vector3d& start) {
      const Vector3d inward = normal.cross(side);
      const double before = inward.dot(start) + skin * side.norm(), change = inward.dot(way);
      if (change > 0) from = std::max(from, -before / change);
      if (change < 0) until = std::min(until, -before / change);
      return from <= until && (change != 0 || before >= 0);
    };
    if (!cut(ab, to) || !cut(c - b, position_ - b) || !cut(-ac, position_ - c)) return;
    found = {share, {normal, normal.dot(a) + gap_}};
  });
  return found.share < 1;
}

/// For each set: x = hip + Σ λ n with n · x = height, found by the normals' Gram matrix. Of the sets that keep to all planes, the nearest.
Vector3d GodObject::best_under_planes(const Vector3d& hip) const {
  Vector3d best = position_;
  double best_square = std::numeric_limits<double>::max();
  const auto consider = [&](const Vector3d& place) {
    const double square = (place - hip).squaredNorm();
    if (square >= best_square) return;
    for (std::size_t i = 0; i < plane_count_; ++i) {
      if (planes_[i].normal.dot(place) < planes_[i].height - 0.1 * gap_) return;
    }
    best_square = square;
    best = place;
  };
  const auto missing = [&](std::size_t i) { return planes_[i].height - planes_[i].normal.dot(hip); };
  consider(hip);
  for (std::size_t i = 0; i < plane_count_; ++i) {
    const Vector3d& n = planes_[i].normal;
    consider(hip + missing(i) * n);
    for (std::size_t j = i + 1; j < plane_count_; ++j) {
      const Vector3d& m = planes_[j].normal;
      const double cosine = n.dot(m), determinant = 1 - cosine * cosine;
      if (determinant < kParallel) continue;
      consider(hip + (missing(i) - cosine * missing(j)) / determinant * n + (missing(j) - cosine * missing(i)) / determinant * m);
      for (std::size_t k = j + 1; k < plane_count_; ++k) {
        Eigen::Matrix3d normals;
        normals << n.transpose(), m.transpose(), planes_[k].normal.transpose();
        if (std::abs(normals.determinant()) < kParallel) continue;
        consider(hip + normals.inverse() * Vector3d(missing(i), missing(j), missing(k)));
      }
    }
  }
  return best;
}

const Vector3d& GodObject::follow(const Vector3d& hip) {
  plane_count_ = 0;
  Vector3d goal = hip;
  for (;;) {
    const Vector3d way = goal - position_;
    Obstacle obstacle{};
    if (!first_on_way(way, obstacle)) {
      position_ = goal;
      return position_;
    }
    position_ += std::max(0.0, obstacle.share) * way;
    if (plane_count_ == kPlanes) return position_;
    planes_[plane_count_++] = obstacle.plane;
    goal = best_under_planes(hip);
  }
}

/// Goes along a face that it touches as far as nothing is in the way, if that leads nearer to the hand. The nearest place of a face may lie at a
/// steep wall, whose other faces do not let it come so far.
bool GodObject::leave_corner(const Vector3d& hip) {
  constexpr double kTouches = 10;  // gaps: where planes meet at a sharp angle it stays farther from them
  const double distance = (position_ - hip).norm();
  const double near = kTouches * gap_;
  Vector3d best = position_;
  double best_distance = distance - gap_;
  tree_.visit([&](const TriangleTree::Box& box) { return box.squared_distance(position_) <= near * near; },
              [&](std::uint32_t face) {
                const field::Corners corners = tree_.corners(face);
                if ((field::nearest_on_triangle(position_, corners).point - position_).norm() > near) return;
                const Vector3d across = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
                const Vector3d goal = field::nearest_on_triangle(hip, corners).point + 1.01 * gap_ * across.normalized();
                if ((goal - hip).norm() >= best_distance) return;
                const Vector3d way = goal - position_;
                Obstacle obstacle{};
                const Vector3d end = first_on_way(way, obstacle) ? Vector3d(position_ + std::max(0.0, obstacle.share) * way) : goal;
                const double reached = (end - hip).norm();
                if (reached >= best_distance) return;
                best = end;
                best_distance = reached;
              });
  const bool moved = best_distance < distance - gap_;
  position_ = best;
  return moved;
}

const Vector3d& GodObject::settle(const Vector3d& hip) {
  for (int pass = 0; pass < kPasses; ++pass) {
    const double before = (position_ - hip).norm();
    follow(hip);
    if ((position_ - hip).norm() < before - gap_) continue;
    if (plane_count_ < 2 || !leave_corner(hip)) break;
  }
  return position_;
}

}  // namespace isotouch::evaluate
