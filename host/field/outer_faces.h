/// The faces of a closed mesh that bound the union of what its parts enclose.
#pragma once

#include <optional>

#include "host/cloud/mesh.h"
#include "host/field/face_tree.h"
#include "host/field/triangle_tree.h"

namespace isotouch::field {

/// Of the mesh's size. Gaps and walls thinner than `kThinnest` are none; faces within `kNear` touch, so that both sides of such a gap are seen to.
inline constexpr double kThinnest = 2e-6, kNear = 4e-6;

/// A face that has the union on both sides, or on neither, is left out. One that does in part is cut in halves across its longest side, again and
/// again, until each part bounds the union everywhere or nowhere, or is no longer than a two-thousandth of the mesh's size. Such a small part stays
/// whole if its middle or a corner of it bounds the union. So, but for slivers a thousandth as wide as that, all of the union's surface is there, and
/// what is there inside it is within that length of the surface. Where that adds more than half a million parts, it is twice that length, or four
/// times, until there are no more; then surface may be missing where gaps or pieces are narrower than such a part.
struct OuterFaces {
  /// The faces that stay, in their order; those that are cut have vertices of their own behind the mesh's. Nothing if all faces stay, or none would.
  std::optional<cloud::TriangleMesh> mesh;
  double coarse = 0;  ///< length of the smallest parts over the mesh's size, if they had to be longer
};

/// Faces within `kThinnest` count as lying on each other.
///
/// mesh      closed: every edge is run as often in one direction as in the other
/// faces     of the mesh
/// turns     of the mesh
/// meet      whether faces cross, or touch within `kNear`
OuterFaces outer_faces(const cloud::TriangleMesh& mesh, const FaceTree& faces, const TriangleTree& turns, bool meet);

}  // namespace isotouch::field
