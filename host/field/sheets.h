/// What of a mesh hangs together.
#pragma once

#include <cstdint>
#include <vector>

#include "host/cloud/mesh.h"

namespace isotouch::field {

/// Faces that hang together by edges that have no third face.
struct Sheets {
  std::vector<std::uint32_t> of;   ///< of each face, one of its sheet
  std::vector<std::uint8_t> open;  ///< of that one: is the sheet closed only together with others?
};

/// mesh      closed: every edge is run as often in one direction as in the other
Sheets sheets_of(const cloud::TriangleMesh& mesh);

/// Of each face one of its piece: open sheets are of one piece with those that they end at. So every piece is closed, and what only touches another
/// piece, at a corner or along an edge, is a piece of its own.
///
/// mesh      closed
std::vector<std::uint32_t> pieces_of_faces(const cloud::TriangleMesh& mesh);

}  // namespace isotouch::field
