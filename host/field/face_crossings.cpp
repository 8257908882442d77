#include "host/field/face_crossings.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "host/field/parallel.h"

namespace isotouch::field {

namespace {

using Eigen::Vector3d;

/// Six times the volume of a tetrahedron.
double volume(const Vector3d& a, const Vector3d& b, const Vector3d& c, const Vector3d& d) { return (b - a).cross(c - a).dot(d - a); }

/// Does an edge of `a` run through the inside of `b`?
bool pierces(const Corners& a, const Corners& b) {
  std::array<double, 3> height;
  for (std::size_t i = 0; i < 3; ++i) height[i] = volume(b[0], b[1], b[2], a[i]);
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    if (!(height[i] < 0 && height[j] > 0) && !(height[i] > 0 && height[j] < 0)) continue;
    const double u = volume(a[i], a[j], b[0], b[1]);
    const double v = volume(a[i], a[j], b[1], b[2]);
    const double w = volume(a[i], a[j], b[2], b[0]);
    if ((u > 0 && v > 0 && w > 0) || (u < 0 && v < 0 && w < 0)) return true;
  }
  return false;
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

bool boxes_meet(const BoxedFace& a, const BoxedFace& b) {
  return (a.low.array() <= b.high.array()).all() && (b.low.array() <= a.high.array()).all();
}

/// All faces near to some that lie together, these among them.
void faces_near(const FaceTree& tree, std::span<const FaceTree::Face> together, std::vector<BoxedFace>& near) {
  Vector3d middle = Vector3d::Zero();
  for (const auto& [corners, number] : together)
    middle += (corners[0] + corners[1] + corners[2]) / (3.0 * static_cast<double>(together.size()));
  double square = 0;
  for (const auto& [corners, number] : together) {
    for (const Vector3d& corner : corners) square = std::max(square, (corner - middle).squaredNorm());
  }
  near.clear();
  tree.each_near(middle, std::sqrt(square), [&](std::uint32_t face) { near.emplace_back(tree.faces()[face]); });
}

}  // namespace

FaceCrossings face_crossings(const cloud::TriangleMesh& mesh, const FaceTree& tree) {
  const auto share_a_corner = [&](std::uint32_t a, std::uint32_t b) {
    const auto& f = mesh.faces[b];
    return std::any_of(mesh.faces[a].begin(), mesh.faces[a].end(), [&](std::uint32_t v) { return f[0] == v || f[1] == v || f[2] == v; });
  };
  constexpr std::size_t kGroup = 8;  // faces that follow each other lie together
  std::vector<std::uint8_t> crosses(mesh.faces.size());
  const std::span faces(tree.faces());
  in_parallel((faces.size() + kGroup - 1) / kGroup, 32, [&](std::size_t begin, std::size_t end) {
    std::vector<BoxedFace> near;
    for (std::size_t group = begin; group < end; ++group) {
      const auto together = faces.subspan(kGroup * group, std::min(kGroup, faces.size() - kGroup * group));
      faces_near(tree, together, near);
      for (const FaceTree::Face& face : together) {
        const BoxedFace boxed(face);
        crosses[face.number] = std::any_of(near.begin(), near.end(), [&](const BoxedFace& other) {
          return other.number > face.number && boxes_meet(boxed, other) && !share_a_corner(face.number, other.number) &&
                 (pierces(face.corners, other.face->corners) || pierces(other.face->corners, face.corners));
        });
      }
    }
  });
  FaceCrossings result;
  for (std::size_t face = 0; face < crosses.size(); ++face) {
    if (crosses[face] == 0) continue;
    const auto& [a, b, c] = mesh.faces[face];
    if (result.faces++ == 0) result.first = (mesh.vertices[a] + mesh.vertices[b] + mesh.vertices[c]) / 3;
  }
  return result;
}

}  // namespace isotouch::field
