/// Where on a field's surface nobody scanned: its marks (shared/SPEC.md, section 4.4), smooth between the bricks, and how a picture shows them.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

#include "host/field_file/marks.h"
#include "host/view/canvas.h"
#include "shared/field_view.h"

namespace isotouch::view {

class Invented {
 public:
  /// field     stays alive as long as this; without marks nothing was invented
  Invented(const FieldView& field, const field_file::Marks& marks);

  bool any() const { return share_ > 0; }
  /// Of the whole surface, 0 to 1.
  double share() const { return share_; }

  /// Was the surface here invented? Trilinear between the middles of the bricks that the surface passes through.
  ///
  /// point     index coordinates, near the surface
  bool at(const Eigen::Vector3d& point) const;

 private:
  const FieldView& field_;
  std::vector<std::int8_t> bricks_;  ///< -1 without surface, 0 scanned, 1 invented
  double share_;
};

/// How much of the hatch's colour a pixel has, 0 to 1: lines that rise to the right.
///
/// pixel     may lie between pixels
/// scale     `drawing_scale` of the picture
float hatch(double x, double y, float scale);

/// A hatched square and what it means, its left end on the base line at `at`.
void draw_invented_legend(Canvas& canvas, Point at, double share);

}  // namespace isotouch::view
