/// Closed pieces of a mesh that its field does not show, because they are thinner than the grid can hold.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <string>
#include <vector>

#include "host/cloud/mesh.h"
#include "shared/field_view.h"

namespace isotouch::encoding {

struct LostPieces {
  std::size_t pieces = 0;                           ///< without anything inside
  std::size_t cavities = 0;                         ///< whose faces point inward: without anything outside
  Eigen::Vector3d place = Eigen::Vector3d::Zero();  ///< on the first of them, workspace, mm
  double thickness_voxel = 0;                       ///< of it, there

  std::vector<std::string> warnings(const cloud::Placement& placement) const;
};

/// A piece is lost if no coefficient within a voxel of its faces has its sign, or the field has the other sign all around those that have: at every
/// sample and half way between them. A hollow that other pieces fill is none.
///
/// mesh      closed, workspace, mm; faces that share a vertex are of one piece
/// view      the field as it was written
LostPieces lost_pieces(const cloud::TriangleMesh& mesh, const FieldView& view);

}  // namespace isotouch::encoding
