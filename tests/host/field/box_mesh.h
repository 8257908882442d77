/// Boxes as meshes: what every question about meshes can be answered for by hand.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "host/cloud/mesh.h"

namespace isotouch::field {

/// Closed, faces outward.
inline cloud::TriangleMesh box_mesh(const Eigen::Vector3d& low, const Eigen::Vector3d& high) {
  cloud::TriangleMesh mesh;
  for (int i = 0; i < 8; ++i) {
    mesh.vertices.emplace_back((i & 1) != 0 ? high.x() : low.x(), (i & 2) != 0 ? high.y() : low.y(), (i & 4) != 0 ? high.z() : low.z());
  }
  mesh.faces = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return mesh;
}

inline cloud::TriangleMesh turned(cloud::TriangleMesh mesh) {
  for (auto& face : mesh.faces) std::swap(face[0], face[1]);
  return mesh;
}

inline cloud::TriangleMesh together(cloud::TriangleMesh mesh, const cloud::TriangleMesh& other) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), other.vertices.begin(), other.vertices.end());
  for (const auto& [a, b, c] : other.faces) mesh.faces.push_back({first + a, first + b, first + c});
  return mesh;
}

/// Two meshes of which the second uses the first one's vertices where it has the same places.
inline cloud::TriangleMesh joined(cloud::TriangleMesh mesh, const cloud::TriangleMesh& other) {
  std::vector<std::uint32_t> number;
  for (const Eigen::Vector3d& vertex : other.vertices) {
    const auto found = std::find(mesh.vertices.begin(), mesh.vertices.end(), vertex);
    number.push_back(static_cast<std::uint32_t>(found - mesh.vertices.begin()));
    if (found == mesh.vertices.end()) mesh.vertices.push_back(vertex);
  }
  for (const auto& [a, b, c] : other.faces) mesh.faces.push_back({number[a], number[b], number[c]});
  return mesh;
}

/// Distance to the box round the origin with these half sides.
inline double box_distance(const Eigen::Vector3d& half, const Eigen::Vector3d& p) {
  const Eigen::Vector3d q = p.cwiseAbs() - half;
  return q.cwiseMax(0).norm() + std::min(q.maxCoeff(), 0.0);
}

}  // namespace isotouch::field
