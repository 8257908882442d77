/// Pairs of faces of a mesh: which may meet, and where.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "host/field/face_tree.h"
#include "host/field/on_triangle.h"

namespace isotouch::field {

/// Six times the volume of a tetrahedron.
inline double volume(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c, const Eigen::Vector3d& d) {
  return (b - a).cross(c - a).dot(d - a);
}

/// Does the edge from `p` to `q` run through the inside of `face`?
inline bool edge_pierces(const Eigen::Vector3d& p, const Eigen::Vector3d& q, const Corners& face) {
  const double from = volume(face[0], face[1], face[2], p), to = volume(face[0], face[1], face[2], q);
  if (!(from < 0 && to > 0) && !(from > 0 && to < 0)) return false;
  const double u = volume(p, q, face[0], face[1]);
  const double v = volume(p, q, face[1], face[2]);
  const double w = volume(p, q, face[2], face[0]);
  return (u > 0 && v > 0 && w > 0) || (u < 0 && v < 0 && w < 0);
}

/// Do two edges that are not parallel come as near as `reach` between their ends?
inline bool edges_touch(const Eigen::Vector3d& a, const Eigen::Vector3d& a_end, const Eigen::Vector3d& b, const Eigen::Vector3d& b_end,
                        double reach) {
  const Eigen::Vector3d along_a = a_end - a, along_b = b_end - b, between = b - a, across = along_a.cross(along_b);
  const double square = across.squaredNorm(), gap = between.dot(across);
  if (!(square > 0) || gap * gap > reach * reach * square) return false;
  const double s = between.cross(along_b).dot(across), t = between.cross(along_a).dot(across);
  return s >= 0 && s <= square && t >= 0 && t <= square;
}

/// Which corners two faces have in common.
struct Common {
  std::size_t count = 0, of_a = 0, of_b = 0;  ///< the last such corner of each
};

inline Common common_corners(const std::array<std::uint32_t, 3>& a, const std::array<std::uint32_t, 3>& b) {
  Common common;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      if (a[i] == b[j]) common = {common.count + 1, i, j};
    }
  }
  return common;
}

/// Does an edge come as near to a face as `reach`?
inline bool edge_touches(const Eigen::Vector3d& p, const Eigen::Vector3d& q, const Corners& face, double reach) {
  if (((p.cwiseMax(q).array() + reach) < face[0].cwiseMin(face[1]).cwiseMin(face[2]).array()).any()) return false;
  if (((p.cwiseMin(q).array() - reach) > face[0].cwiseMax(face[1]).cwiseMax(face[2]).array()).any()) return false;
  const auto is_near = [&](const Eigen::Vector3d& end) {
    return (nearest_on_triangle(end, face).point - end).squaredNorm() <= reach * reach;
  };
  if (is_near(p) || is_near(q) || edge_pierces(p, q, face)) return true;
  for (std::size_t i = 0; i < 3; ++i)
    if (edges_touch(p, q, face[i], face[(i + 1) % 3], reach)) return true;
  return false;
}

/// A face and the box round it, along the coordinates.
struct BoxedFace {
  const FaceTree::Face* face;
  std::uint32_t number;
  Eigen::Vector3d low, high;

  explicit BoxedFace(const FaceTree::Face& of)
      : face(&of),
        number(of.number),
        low(of.corners[0].cwiseMin(of.corners[1]).cwiseMin(of.corners[2])),
        high(of.corners[0].cwiseMax(of.corners[1]).cwiseMax(of.corners[2])) {}
};

/// Are the boxes no farther apart than `reach` along any coordinate?
inline bool boxes_meet(const BoxedFace& a, const BoxedFace& b, double reach) {
  return (a.low.array() - reach <= b.high.array()).all() && (b.low.array() - reach <= a.high.array()).all();
}

/// All faces as near as `reach` to some that lie together, these among them.
inline void faces_near(const FaceTree& tree, std::span<const FaceTree::Face> together, double reach, std::vector<BoxedFace>& near) {
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const auto& [corners, number] : together)
    middle += (corners[0] + corners[1] + corners[2]) / (3.0 * static_cast<double>(together.size()));
  double square = 0;
  for (const auto& [corners, number] : together) {
    for (const Eigen::Vector3d& corner : corners) square = std::max(square, (corner - middle).squaredNorm());
  }
  near.clear();
  tree.each_near(middle, std::sqrt(square) + reach, [&](std::uint32_t face) { near.emplace_back(tree.faces()[face]); });
}

}  // namespace isotouch::field
