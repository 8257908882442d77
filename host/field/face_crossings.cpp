#include "host/field/face_crossings.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "host/field/on_triangle.h"
#include "host/field/parallel.h"

namespace isotouch::field {

namespace {

using Eigen::Vector3d;

/// Six times the volume of a tetrahedron.
double volume(const Vector3d& a, const Vector3d& b, const Vector3d& c, const Vector3d& d) { return (b - a).cross(c - a).dot(d - a); }

/// Does the edge from `p` to `q` run through the inside of `face`?
bool edge_pierces(const Vector3d& p, const Vector3d& q, const Corners& face) {
  const double from = volume(face[0], face[1], face[2], p), to = volume(face[0], face[1], face[2], q);
  if (!(from < 0 && to > 0) && !(from > 0 && to < 0)) return false;
  const double u = volume(p, q, face[0], face[1]);
  const double v = volume(p, q, face[1], face[2]);
  const double w = volume(p, q, face[2], face[0]);
  return (u > 0 && v > 0 && w > 0) || (u < 0 && v < 0 && w < 0);
}

/// Does an edge of `a` run through the inside of `b`?
bool pierces(const Corners& a, const Corners& b) {
  return edge_pierces(a[0], a[1], b) || edge_pierces(a[1], a[2], b) || edge_pierces(a[2], a[0], b);
}

/// Do the corners of `a` all lie on one side of the plane of `b`, farther than `reach`?
bool is_beside(const Corners& a, const Corners& b, double reach) {
  const Vector3d normal = (b[1] - b[0]).cross(b[2] - b[0]);
  const double limit = reach * normal.norm();
  const double x = normal.dot(a[0] - b[0]), y = normal.dot(a[1] - b[0]), z = normal.dot(a[2] - b[0]);
  return (x > limit && y > limit && z > limit) || (x < -limit && y < -limit && z < -limit);
}

bool a_corner_touches(const Corners& a, const Corners& b, double reach) {
  return std::any_of(a.begin(), a.end(),
                     [&](const Vector3d& p) { return (nearest_on_triangle(p, b).point - p).squaredNorm() <= reach * reach; });
}

/// Do two edges that are not parallel come as near as `reach` between their ends?
bool edges_touch(const Vector3d& a, const Vector3d& a_end, const Vector3d& b, const Vector3d& b_end, double reach) {
  const Vector3d along_a = a_end - a, along_b = b_end - b, between = b - a, across = along_a.cross(along_b);
  const double square = across.squaredNorm(), gap = between.dot(across);
  if (!(square > 0) || gap * gap > reach * reach * square) return false;
  const double s = between.cross(along_b).dot(across), t = between.cross(along_a).dot(across);
  return s >= 0 && s <= square && t >= 0 && t <= square;
}

/// Are two faces that do not cross as near as `reach`? Where they are nearest, one has a corner, or both have an edge.
bool touch(const Corners& a, const Corners& b, double reach) {
  if (is_beside(a, b, reach) || is_beside(b, a, reach)) return false;
  if (a_corner_touches(a, b, reach) || a_corner_touches(b, a, reach)) return true;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      if (edges_touch(a[i], a[(i + 1) % 3], b[j], b[(j + 1) % 3], reach)) return true;
    }
  }
  return false;
}

/// Which corners two faces have in common.
struct Common {
  std::size_t count = 0, of_a = 0, of_b = 0;  ///< the last such corner of each
};

Common common_corners(const std::array<std::uint32_t, 3>& a, const std::array<std::uint32_t, 3>& b) {
  Common common;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      if (a[i] == b[j]) common = {common.count + 1, i, j};
    }
  }
  return common;
}

/// Does the edge of `a` that is opposite its corner `apex` run through `b`? Faces that have only that corner in common meet elsewhere only if one's
/// opposite edge meets the other.
bool opposite_edge_pierces(const Corners& a, std::size_t apex, const Corners& b) {
  return edge_pierces(a[(apex + 1) % 3], a[(apex + 2) % 3], b);
}

/// A face and the box round it, along the coordinates.
struct BoxedFace {
  const FaceTree::Face* face;
  std::uint32_t number;
  Vector3d low, high;

  explicit BoxedFace(const FaceTree::Face& of)
      : face(&of),
        number(of.number),
        low(of.corners[0].cwiseMin(of.corners[1]).cwiseMin(of.corners[2])),
        high(of.corners[0].cwiseMax(of.corners[1]).cwiseMax(of.corners[2])) {}
};

/// Are the boxes no farther apart than `reach` along any coordinate?
bool boxes_meet(const BoxedFace& a, const BoxedFace& b, double reach) {
  return (a.low.array() - reach <= b.high.array()).all() && (b.low.array() - reach <= a.high.array()).all();
}

/// All faces as near as `reach` to some that lie together, these among them.
void faces_near(const FaceTree& tree, std::span<const FaceTree::Face> together, double reach, std::vector<BoxedFace>& near) {
  Vector3d middle = Vector3d::Zero();
  for (const auto& [corners, number] : together)
    middle += (corners[0] + corners[1] + corners[2]) / (3.0 * static_cast<double>(together.size()));
  double square = 0;
  for (const auto& [corners, number] : together) {
    for (const Vector3d& corner : corners) square = std::max(square, (corner - middle).squaredNorm());
  }
  near.clear();
  tree.each_near(middle, std::sqrt(square) + reach, [&](std::uint32_t face) { near.emplace_back(tree.faces()[face]); });
}

double size_of(const cloud::TriangleMesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const Vector3d& vertex : mesh.vertices) box.extend(vertex);
  return box.diagonal().norm();
}

}  // namespace

FaceCrossings face_crossings(const cloud::TriangleMesh& mesh, const FaceTree& tree) {
  constexpr std::size_t kGroup = 8;  // faces that follow each other lie together
  const double reach = 1e-6 * size_of(mesh);
  std::vector<std::uint8_t> crosses(mesh.faces.size()), touches(mesh.faces.size());
  const std::span faces(tree.faces());
  in_parallel((faces.size() + kGroup - 1) / kGroup, 32, [&](std::size_t begin, std::size_t end) {
    std::vector<BoxedFace> near;
    for (std::size_t group = begin; group < end; ++group) {
      const auto together = faces.subspan(kGroup * group, std::min(kGroup, faces.size() - kGroup * group));
      faces_near(tree, together, reach, near);
      for (const FaceTree::Face& face : together) {
        const BoxedFace boxed(face);
        for (const BoxedFace& other : near) {
          if (other.number <= face.number || !boxes_meet(boxed, other, reach)) continue;
          const Corners &a = face.corners, &b = other.face->corners;
          const auto [common, of_a, of_b] = common_corners(mesh.faces[face.number], mesh.faces[other.number]);
          if (common > 1) continue;
          const bool cross = common == 1 ? opposite_edge_pierces(a, of_a, b) || opposite_edge_pierces(b, of_b, a)
                                         : boxes_meet(boxed, other, 0) && (pierces(a, b) || pierces(b, a));
          if (cross) {
            crosses[face.number] = 1;
            break;
          }
          if (common == 0 && touches[face.number] == 0 && touch(a, b, reach)) touches[face.number] = 1;
        }
      }
    }
  });
  FaceCrossings result;
  result.touching = std::find(touches.begin(), touches.end(), 1) != touches.end();
  for (std::size_t face = 0; face < crosses.size(); ++face) {
    if (crosses[face] == 0) continue;
    const auto& [a, b, c] = mesh.faces[face];
    if (result.faces++ == 0) result.first = (mesh.vertices[a] + mesh.vertices[b] + mesh.vertices[c]) / 3;
  }
  return result;
}

}  // namespace isotouch::field
