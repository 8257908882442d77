#include "host/field/face_crossings.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "host/field/parallel.h"

namespace isotouch::field {

namespace {

using Eigen::Vector3d;
using Corners = std::array<Vector3d, 3>;

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

bool crosses_another(const cloud::TriangleMesh& mesh, const FaceTree& tree, const FaceTree::Face& face) {
  const auto& own = mesh.faces[face.number];
  const auto share_a_corner = [&](std::uint32_t other) {
    return std::any_of(own.begin(), own.end(), [&](std::uint32_t v) {
      const auto& f = mesh.faces[other];
      return f[0] == v || f[1] == v || f[2] == v;
    });
  };
  const Vector3d low = face.corners[0].cwiseMin(face.corners[1]).cwiseMin(face.corners[2]);
  const Vector3d high = face.corners[0].cwiseMax(face.corners[1]).cwiseMax(face.corners[2]);
  std::array<std::uint32_t, 64> waiting;
  std::size_t count = 0;
  waiting[count++] = 0;
  while (count > 0) {
    const std::uint32_t number = waiting[--count];
    const FaceTree::Node& node = tree.nodes[number];
    if ((node.low.array() > high.array()).any() || (node.high.array() < low.array()).any()) continue;
    if (node.right != 0) {
      waiting[count++] = node.right;
      waiting[count++] = number + 1;
      continue;
    }
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
      const FaceTree::Face& other = tree.faces[i];
      if (other.number <= face.number || share_a_corner(other.number)) continue;
      if (pierces(face.corners, other.corners) || pierces(other.corners, face.corners)) return true;
    }
  }
  return false;
}

}  // namespace

FaceCrossings face_crossings(const cloud::TriangleMesh& mesh, const FaceTree& tree) {
  std::vector<std::uint8_t> crosses(mesh.faces.size());
  in_parallel(tree.faces.size(), 256, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) crosses[tree.faces[i].number] = crosses_another(mesh, tree, tree.faces[i]) ? 1 : 0;
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
