/// The edges of a mesh at which its surface turns sharply.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "host/cloud/mesh.h"

namespace isotouch::evaluate {

struct SharpEdge {
  Eigen::Vector3d begin, end;              ///< in the mesh's unit
  std::array<Eigen::Vector3d, 2> normals;  ///< unit, of the two faces
  double turn_deg;                         ///< between the normals; positive: convex, negative: concave
};

/// mesh      closed
/// least     degrees by which the normals of its two faces differ at least
/// returns   in the order of their vertices' numbers; faces without area have no sharp edges
std::vector<SharpEdge> sharp_edges(const cloud::TriangleMesh& mesh, double least_deg);

}  // namespace isotouch::evaluate
