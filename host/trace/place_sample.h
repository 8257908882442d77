/// What a field says at a place, as the controller's core computes it, in the units of people.
#pragma once

#include <Eigen/Core>

#include "shared/field_view.h"

namespace isotouch::trace {

struct PlaceSample {
  double distance_mm = 0;                              ///< within ± the band, negative inside
  Eigen::Vector3d gradient = Eigen::Vector3d::Zero();  ///< mm a mm, points out; zero beyond the band
  double stiffness_n_mm = 0;
  bool in_band = false;  ///< a voxel or more within the band; else the surface may be farther away, and in another direction
};

/// place     workspace, mm, finite; outside the sampled box it counts as the nearest place of its border
/// fails     never; allocates nothing
PlaceSample sample_place(const FieldView& field, const Eigen::Vector3d& place);

}  // namespace isotouch::trace
