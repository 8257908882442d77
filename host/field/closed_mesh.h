/// What a mesh must be before its distances are asked for, and what is put right on the way.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <string>
#include <vector>

#include "host/cloud/mesh.h"

namespace isotouch::field {

/// What was found and what was done. Places and lengths in the mesh's unit.
struct MeshRepair {
  std::size_t repeated = 0;                           ///< faces that were written before, and dropped
  std::size_t holes = 0;                              ///< closed by fans
  double rim_length = 0;                              ///< of all of them
  Eigen::Vector3d rim = Eigen::Vector3d::Zero();      ///< the middle of the longest
  std::size_t branching = 0;                          ///< edges of more than two faces
  Eigen::Vector3d branch = Eigen::Vector3d::Zero();   ///< the middle of the first of them
  bool turned = false;                                ///< all faces were turned round
  std::size_t swallowed = 0;                          ///< closed pieces that lie in others and face outwards: they bound nothing
  Eigen::Vector3d swallow = Eigen::Vector3d::Zero();  ///< the middle of a face of the first of them
  double coarse = 0;                                  ///< not looked for here, see `MeshDistance::coarse_parts`
  std::size_t crossing = 0;                           ///< faces that run through others; not looked for here, see `MeshDistance::crossings`
  Eigen::Vector3d cross = Eigen::Vector3d::Zero();    ///< the middle of the first of them

  /// One sentence for each of these.
  std::vector<std::string> warnings() const;
};

/// Checks and mends, in this order:
///
/// repeated    where the edges are not run as often in one direction as in the other, faces that are written twice are dropped
/// direction   two faces that share an edge must run it in opposite directions
/// holes       every rim gets a fan round the mean of its edges. Then each edge is run as often in one direction as in the other, and winding
///             numbers are whole
/// inside out  a mesh of negative volume is turned round. Pieces are not turned one by one: a piece that faces inward is a hollow when all of
///             it lies in others. Each of its faces is asked at its middle and at its corners. A piece that is closed only together with others
///             (sheets.h) is asked whichever way it faces, and faces inward if most of its area does; tiny ones may face as they will.
///             Hollows may overlap; but one that lies wholly in others may as well be a body, and a body where they overlap would be lost
///
/// swallowed   closed pieces that face outward and lie in others are counted: their union with these has no trace of them
///
/// name        of the file, for the sentences
/// fails       InputError with the place: hardly any faces share their corners, although these lie side by side; faces turn against each other; nothing
///             is enclosed; a piece, or a part of it, faces inward beside the others, or outward where most face inward; a hollow lies in another one,
///             or a body where hollows overlap. Of a piece with fans it says that the mesh is open
cloud::TriangleMesh closed_mesh(cloud::TriangleMesh mesh, const std::string& name, MeshRepair& repair);

}  // namespace isotouch::field
