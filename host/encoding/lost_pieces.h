/// Closed pieces of a mesh of which its field shows little or nothing, because they are thinner than the grid can hold.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <string>
#include <vector>

#include "host/cloud/mesh.h"
#include "shared/field_view.h"

namespace isotouch::encoding {

struct LostPieces {
  std::size_t pieces = 0;                           ///< bodies
  std::size_t cavities = 0;                         ///< whose faces point inward
  Eigen::Vector3d place = Eigen::Vector3d::Zero();  ///< on the first of them, where it is missed; workspace, mm
  double thickness_voxel = 0;                       ///< of it, there

  std::vector<std::string> warnings(const cloud::Placement& placement) const;
};

/// A piece is lost if most of its area is missed: that of its area which bounds the union of all pieces. A place of it is missed if no coefficient
/// near it has the piece's sign, or the field has the other sign all around those that have: at every sample and half way between them.
///
/// mesh      closed, workspace, mm; its pieces are those of `pieces_of_faces`
/// view      the field as it was written
LostPieces lost_pieces(const cloud::TriangleMesh& mesh, const FieldView& view);

}  // namespace isotouch::encoding
