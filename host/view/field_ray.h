/// Where a ray meets the surface as the core samples it.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "host/view/camera.h"
#include "shared/field_view.h"

namespace isotouch::view {

/// A checked field, seen in millimetres of the workspace.
class FieldRays {
 public:
  /// field     stays alive as long as this
  explicit FieldRays(const FieldView& field);

  struct Value {
    double distance = 0;                                 ///< voxels, clamped to the band, negative inside
    Eigen::Vector3d gradient = Eigen::Vector3d::Zero();  ///< voxels a voxel
    bool outside_grid = false;                           ///< then both are those of the border
  };
  Value value(const Eigen::Vector3d& point) const;

  /// The first place between `from` and `to` (mm along the ray) where the field is zero, within 1/500 voxel. A ray that begins inside hits
  /// where it begins. Walks in steps of four fifths of the distance, and over bricks that are far outside in one step.
  ///
  /// returns   mm along the ray, or nothing
  std::optional<double> hit(const Ray& ray, double from, double to) const;

  /// The object in dots, a brick apart: enough to place a camera by.
  const std::vector<Eigen::Vector3d>& outline() const { return outline_; }
  double edge() const { return edge_; }
  Eigen::Vector3d to_index(const Eigen::Vector3d& point) const { return (point - origin_) / edge_; }
  const FieldView& field() const { return field_; }

 private:
  double distance_at(const Eigen::Vector3d& index) const;
  /// Voxels along the ray to the far side of the block around a point that is far outside throughout; 0 where distances are stored.
  ///
  /// inverse   of each component of the ray's direction
  double empty_way(const Eigen::Vector3d& index, const Eigen::Vector3d& inverse) const;

  /// A place on a ray in index coordinates, voxels.
  struct Place {
    double t, distance;
  };
  double crossing(const Ray& ray, Place outside, Place inside) const;

  const FieldView& field_;
  Eigen::Vector3d origin_;
  double edge_;
  double band_;
  Box object_;  ///< index coordinates; contains the surface, within the grid
  std::vector<Eigen::Vector3d> outline_;
};

}  // namespace isotouch::view
