#include "host/field/face_crossings.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "host/field/face_pairs.h"
#include "host/field/on_triangle.h"
#include "host/field/parallel.h"

namespace isotouch::field {

namespace {

using Eigen::Vector3d;

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

/// Does the edge of `a` that is opposite its corner `apex` run through `b`? Faces that have only that corner in common meet elsewhere only if one's
/// opposite edge meets the other.
bool opposite_edge_pierces(const Corners& a, std::size_t apex, const Corners& b) {
  return edge_pierces(a[(apex + 1) % 3], a[(apex + 2) % 3], b);
}

double size_of(const cloud::TriangleMesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const Vector3d& vertex : mesh.vertices) box.extend(vertex);
  return box.diagonal().norm();
}

}  // namespace

FaceCrossings face_crossings(const cloud::TriangleMesh& mesh, const FaceTree& tree, double touching) {
  constexpr std::size_t kGroup = 8;  // faces that follow each other lie together
  const double reach = touching * size_of(mesh);
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
