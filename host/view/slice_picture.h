/// A cross-section of the field as the core samples it: colours for the distance, a line at the surface and thin ones a voxel apart.
#pragma once

#include <optional>
#include <string>

#include "host/view/image.h"
#include "shared/field_view.h"

namespace isotouch::view {

struct SliceOptions {
  int width = 960, height = 720;
  char axis = 'z';                   ///< across the slice: 'x' shows z and y, 'y' shows x and z, 'z' shows x and y
  std::optional<double> at_mm = {};  ///< where on that axis, workspace; none: where the object is widest
  std::string title = {};
};

Image slice_picture(const FieldView& field, const SliceOptions& options);

}  // namespace isotouch::view
