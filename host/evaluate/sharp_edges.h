/// The edges of a mesh at which its surface turns sharply.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "host/cloud/mesh.h"
#include "host/cloud/random.h"
#include "host/evaluate/true_trees.h"

namespace isotouch::evaluate {

struct SharpEdge {
  Eigen::Vector3d begin, end;              ///< in the mesh's unit
  std::array<Eigen::Vector3d, 2> normals;  ///< unit, of the two faces
  double turn_deg;                         ///< between the normals; positive: convex, negative: concave

  /// Unit, from the edge into one of the faces.
  Eigen::Vector3d into_face(std::size_t side) const;
};

/// mesh      closed; vertices at one place count as one
/// least     degrees by which the normals of its two faces differ at least
/// returns   in the order of their vertices' numbers; faces without area have no sharp edges. Where more than two faces meet, one for each two of them
///           that run the edge in opposite directions
std::vector<SharpEdge> sharp_edges(const cloud::TriangleMesh& mesh, double least_deg);

/// Those of a body of several pieces. Where pieces meet, only those parts of the edges stay at which both faces bound the body. The edges that pieces
/// make with each other where they cross are not among them.
std::vector<SharpEdge> bounding_edges(const TrueTrees& trees, double least_deg);

struct EdgePlace {
  SharpEdge edge;
  Eigen::Vector3d point;  ///< on it
};

/// returns   somewhere on one of the edges, each as likely as it is long; nothing where there is none
std::optional<EdgePlace> place_on_edges(const std::vector<SharpEdge>& edges, cloud::Random& random);

}  // namespace isotouch::evaluate
