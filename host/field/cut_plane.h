/// A scan that ends in one plane, as a hand ends at the wrist: the plane, and what closes the body there.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "host/cloud/oriented_points.h"
#include "host/field/open_rim.h"
#include "host/field/scan.h"

namespace isotouch::field {

struct CutPlane {
  Eigen::Vector3d place;  ///< on the plane, the scan's unit
  Eigen::Vector3d axis;   ///< unit, away from the scan
  bool is_end =
      false;  ///< the surface runs into the plane, it does not turn into it: it was cut off there, and no hole closes with a bulge
};

/// The plane as good an end as any; what a hole in the middle should look like, nobody knows.
///
/// returns   nothing where the rims of `scan` lie in no plane, or where it goes on behind that
std::optional<CutPlane> cut_plane(const Scan& scan, const OpenRim& rim);

/// Oriented points on the plane within the rims, about as far apart as the samples are. A stiffness as at the nearest place of a rim.
cloud::OrientedPoints plane_cap(const Scan& scan, const OpenRim& rim, const CutPlane& plane);

}  // namespace isotouch::field
