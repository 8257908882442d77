/// One view of a field: rays through an area of a picture, two by two to a pixel.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "host/view/camera.h"
#include "host/view/canvas.h"
#include "host/view/field_ray.h"
#include "host/view/invented.h"
#include "host/view/markers.h"

namespace isotouch::view {

/// Everything on the eye's side of the plane is cut away, and the cut shows lines of equal distance one voxel apart.
struct CutPlane {
  Eigen::Vector3d point;
  Eigen::Vector3d normal;  ///< unit, towards the eye
};

struct Scene {
  const FieldRays& rays;
  const Camera& camera;
  std::optional<Markers> markers;  ///< shine through the surface where it hides them
  std::optional<CutPlane> cut;
  const Invented* invented = nullptr;  ///< of the field; hatched
};

/// What is seen in `area`, whose edges are whole pixels of the picture.
///
/// scale     `drawing_scale` of the picture
Image scene_image(const Rect& area, const Scene& scene, float scale);

}  // namespace isotouch::view
