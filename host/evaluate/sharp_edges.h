/// The edges of a mesh at which its surface turns sharply.
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <vector>

#include "host/cloud/mesh.h"
#include "host/cloud/random.h"

namespace isotouch::evaluate {

struct SharpEdge {
  Eigen::Vector3d begin, end;              ///< in the mesh's unit
  std::array<Eigen::Vector3d, 2> normals;  ///< unit, of the two faces
  double turn_deg;                         ///< between the normals; positive: convex, negative: concave
};

/// mesh      closed; vertices at one place count as one
/// least     degrees by which the normals of its two faces differ at least
/// returns   in the order of their vertices' numbers; faces without area have no sharp edges
std::vector<SharpEdge> sharp_edges(const cloud::TriangleMesh& mesh, double least_deg);

struct EdgePlace {
  SharpEdge edge;
  Eigen::Vector3d point;  ///< on it
};

/// returns   somewhere on one of the edges, each as likely as it is long; nothing where there is none
std::optional<EdgePlace> place_on_edges(const std::vector<SharpEdge>& edges, cloud::Random& random);

}  // namespace isotouch::evaluate
