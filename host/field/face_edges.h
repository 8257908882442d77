/// The edges of a mesh's faces, those of one edge together.
#pragma once

#include <compare>
#include <cstdint>
#include <vector>

#include "host/cloud/mesh.h"

namespace isotouch::field {

/// One side of one face.
struct FaceEdge {
  std::uint32_t low, high;  ///< its vertices; low < high
  std::uint32_t face;
  std::uint32_t side;  ///< from the face's corner of this number to the next

  bool same_edge(const FaceEdge& o) const { return low == o.low && high == o.high; }
  /// Does the face run it from `high` to `low`?
  bool is_back(const cloud::TriangleMesh& mesh) const { return mesh.faces[face][side] == high; }

  auto operator<=>(const FaceEdge&) const = default;
};

/// All sides of all faces, in their order.
std::vector<FaceEdge> face_edges(const cloud::TriangleMesh& mesh);

}  // namespace isotouch::field
