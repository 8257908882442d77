/// A scan that ends in one plane, as a hand ends at the wrist or a table at its edge: the plane, and what closes the body there.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "host/cloud/oriented_points.h"
#include "host/field/open_rim.h"
#include "host/field/scan.h"

namespace isotouch::field {

struct CutPlane {
  Eigen::Vector3d place;                                  ///< on the plane, the scan's unit
  Eigen::Vector3d axis;                                   ///< unit, away from the scan
  double along_axis = 0;                                  ///< mean of the rims' normals along it: 0 at a cut through a limb
  bool is_only_end = false;                               ///< nearly all rims lie on it
  std::vector<RimPlace> on_plane = {};                    ///< of the rims most of whose samples lie on it
  double least_surrounded = 1;                            ///< of the other rims, as `OpenRim::least_surrounded`
  Eigen::Vector3d least_place = Eigen::Vector3d::Zero();  ///< of these, as `OpenRim::least_place`
  bool is_clean = false;  ///< the longest rim is so flat that no hole of another kind ends like this: somebody cut the scan off here

  /// Was it cut off, by a plane into which the surface runs? A hole in a ball may as well be closed by a bulge, and nobody knows which.
  bool is_cut() const { return is_only_end && is_clean && along_axis > -0.5 && along_axis < 0.5; }
  /// Does the surface lie in the plane there?
  bool is_flat() const { return along_axis < -0.7 || along_axis > 0.7; }
  /// Does it look back at the scan, too? Then the object stands on something that was scanned.
  bool is_table() const { return is_flat() && along_axis < 0; }
};

/// returns   the plane of the longest rim; nothing where that lies in none, or where the scan goes on behind it
std::optional<CutPlane> cut_plane(const Scan& scan, const OpenRim& rim);

/// Oriented points on the plane within the rims, about as far apart as the samples are. A stiffness as at the nearest place of a rim.
cloud::OrientedPoints plane_cap(const Scan& scan, const CutPlane& plane);

}  // namespace isotouch::field
