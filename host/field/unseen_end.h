/// Where a scan sees into a hollow, such as a bottle, but not to its end.
#pragma once

#include <Eigen/Core>

#include "host/field/band_field.h"
#include "host/field/spacings.h"

namespace isotouch::field {

struct UnseenEnd {
  double share = 0;                                 ///< of the field's surface: it closes such hollows
  Eigen::Vector3d place = Eigen::Vector3d::Zero();  ///< on the largest piece of it, mm
};

/// Through its mouth a hollow shows the beginning of its wall. The field closes it somewhere behind, and nobody knows how far it goes on or how wide
/// it becomes. A piece of surface closes one when of the points round it
///
/// - none near it looks its way, though as dense as all are together, three would lie on it;
/// - the normals point all round, and hardly along one axis, unless twenty are missing: they are the wall of a tube;
/// - seen along that axis, some look at it: from behind, the end of a limb looks alike.
///
/// spacings  of the points from which `field` was built; workspace, mm
UnseenEnd unseen_end(const BandField& field, const Spacings& spacings);

}  // namespace isotouch::field
