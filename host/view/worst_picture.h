/// The worst place of a field: its surface and the true one side by side, through the same camera, with their distance in colours.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>

#include "host/cloud/mesh.h"
#include "host/view/picture.h"
#include "shared/field_view.h"

namespace isotouch::view {

/// What a hand feels there.
struct WorstTouch {
  Eigen::Vector3d hip, god, proxy;  ///< mm: the hand, where a god-object rests on the true surface, where the field's proxy is
  std::string words;                ///< for the caption
};

struct WorstPlace {
  Eigen::Vector3d place = Eigen::Vector3d::Zero();  ///< mm, on one of the two surfaces
  bool on_truth = false;                            ///< on the true one
  double distance_mm = 0;                           ///< from there to the other surface
  double voxel_mm = 1;
  std::optional<WorstTouch> touch = {};  ///< then lines lead from the hand to what holds it, on the field's surface and on the true one
};

struct WorstOptions {
  int width = 1280, height = 720;
  std::string title = {};
};

/// The eye stands where the place can be seen, a little beside its normal; where no eye sees it, what hides it is cut away.
///
/// field            lights its surface: normals are the gradient's as sampled
/// surface          the field's zero surface in triangles: closed, workspace, mm
/// truth, closed    the true surface: the faces that bound it, which need not be closed; and all of them, which are and say what is inside
Picture worst_picture(const FieldView& field, const cloud::TriangleMesh& surface, const cloud::TriangleMesh& truth,
                      const cloud::TriangleMesh& closed, const WorstPlace& worst, const WorstOptions& options);

}  // namespace isotouch::view
