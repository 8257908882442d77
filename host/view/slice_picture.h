/// A cross-section of the field as the core samples it: colours for the distance, a line at the surface and thin ones a voxel apart.
#pragma once

#include <optional>
#include <string>

#include "host/view/markers.h"
#include "host/view/picture.h"
#include "shared/field_view.h"

namespace isotouch::view {

struct SliceOptions {
  int width = 960, height = 720;
  std::optional<char> axis = {};  ///< across the slice: 'x' shows z and y, 'y' shows x and z, 'z' shows x and y; none: z, or another from
                                  ///< where more of the touch is seen
  std::optional<double> at_mm = {};  ///< where on that axis, workspace; none: at the touch, or where the object is widest
  std::optional<Touch> touch = {};   ///< drawn as it is seen along the axis
  std::string title = {};
};

Picture slice_picture(const FieldView& field, const SliceOptions& options);

}  // namespace isotouch::view
