/// The project's objects through the whole path, measured against what they really are.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "host/cloud/shapes.h"
#include "host/encoding/write_image.h"
#include "host/evaluate/damage.h"
#include "host/evaluate/force_error.h"
#include "host/evaluate/surface_error.h"
#include "host/field/band_field.h"
#include "host/field/build_field.h"
#include "host/field_file/open_field.h"

namespace isotouch::evaluate {

inline constexpr double kTrialVoxel = 0.34;         ///< mm, the paper's 300³ over 4 inches; a shape's unit is one voxel
inline constexpr double kTrialBand = field::kBand;  ///< voxels
inline constexpr std::size_t kTrialTruths = 10'000;

/// A shape on the desk: its points, its true surface and its grid, in the workspace.
struct ShapeTrial {
  cloud::Shape shape;
  cloud::OrientedPoints points;  ///< what a method is given
  cloud::OrientedPoints truth;   ///< fresh points, what it is measured at
  field::Grid grid;              ///< at a random place against the shape, so that nothing gains from symmetry

  /// The surface's true place: distance in mm from a point of the workspace.
  double distance(const Eigen::Vector3d& point) const { return kTrialVoxel * shape.distance(point / kTrialVoxel); }
};

/// fails     InputError: no such shape
ShapeTrial shape_trial(const std::string& name, std::uint64_t seed = 1);

/// The same trial with a damaged scan, on a grid wider by as many voxels as strays need.
ShapeTrial damaged_trial(const ShapeTrial& trial, const Damage& damage, std::uint64_t seed = 1);

/// The field that a method makes of the trial's points: kDefault the analytic one, kPublished the paper's levels.
///
/// repair    where given, is told what the default method mended
field_file::OpenField trial_field(const ShapeTrial& trial, Method method, field::Repair* repair = nullptr);

/// The field of the exact distances, on the same grid.
field_file::OpenField floor_field(const ShapeTrial& trial);

/// Fig. 9: 4 voxels deep over the sphere's trial. `speed` in mm/s.
SphereSlide trial_slide(const FieldView& field, double speed);

}  // namespace isotouch::evaluate
