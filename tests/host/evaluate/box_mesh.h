/// A closed box of triangles.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>

#include "host/cloud/mesh.h"

namespace isotouch::evaluate {

/// Twelve triangles, outward.
inline cloud::TriangleMesh box(const Eigen::Vector3d& low, const Eigen::Vector3d& high) {
  cloud::TriangleMesh mesh;
  for (int n = 0; n < 8; ++n) {
    mesh.vertices.emplace_back((n & 1) != 0 ? high.x() : low.x(), (n & 2) != 0 ? high.y() : low.y(), (n & 4) != 0 ? high.z() : low.z());
  }
  const std::array<std::array<std::uint32_t, 4>, 6> sides = {
      {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};
  for (const auto& [a, b, c, d] : sides) {
    mesh.faces.push_back({a, b, c});
    mesh.faces.push_back({a, c, d});
  }
  cloud::require_closed(mesh, "box");
  return mesh;
}

}  // namespace isotouch::evaluate
