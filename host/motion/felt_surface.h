/// A field's surface as the core samples it, in millimetres of the workspace: for whoever wants to touch it or measure it.
///
/// Only + − × ÷ and square roots stand between the core's integers and these numbers, so they are the same on every machine.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "shared/field_view.h"

namespace isotouch::motion {

struct FeltSample {
  double distance = 0;                                 ///< mm, clamped to the band; negative inside
  Eigen::Vector3d gradient = Eigen::Vector3d::Zero();  ///< mm a mm, points out; zero beyond the band
  double curvature = 0;  ///< 1/voxel, Frobenius norm of the second derivatives: high at edges, corners and creases
};

struct SurfacePoint {
  Eigen::Vector3d position;  ///< mm
  Eigen::Vector3d normal;    ///< unit, outward
};

class FeltSurface {
 public:
  /// field     stays alive as long as this
  explicit FeltSurface(const FieldView& field);

  double voxel_mm() const { return edge_; }
  /// A ball that contains the whole grid.
  const Eigen::Vector3d& centre() const { return centre_; }
  double radius() const { return radius_; }

  FeltSample sample(const Eigen::Vector3d& point) const;

  /// The first place where a straight way comes from outside to inside.
  ///
  /// direction  unit
  /// reach      mm, the way's length
  std::optional<SurfacePoint> first_hit(const Eigen::Vector3d& from, const Eigen::Vector3d& direction, double reach) const;

  /// How far a straight way that begins inside stays inside, at most `reach`.
  double way_out(const Eigen::Vector3d& from, const Eigen::Vector3d& direction, double reach) const;

  /// The zero near a point, by Newton steps along the gradient; nothing where the band ends or the steps do not settle within 1/100 voxel.
  std::optional<SurfacePoint> project(const Eigen::Vector3d& point) const;

 private:
  const FieldView& field_;
  Eigen::Vector3d origin_;
  double edge_;
  Eigen::Vector3d centre_;
  double radius_;
};

}  // namespace isotouch::motion
