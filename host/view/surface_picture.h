/// The lit zero iso-surface of a field as the core samples it, with the touch of one tick in it.
///
/// source    what the paper shows its user (its section 4): surface under a known light, proxy, HIP, a line for the penetration
#pragma once

#include <optional>
#include <string>

#include "host/field_file/marks.h"
#include "host/view/camera.h"
#include "host/view/markers.h"
#include "host/view/picture.h"
#include "shared/field_view.h"

namespace isotouch::view {

struct SurfaceOptions {
  int width = 960, height = 720;
  std::optional<Direction> direction = {};  ///< none: the default one, or with a touch one that shows it from the side
  char up = 'y';                            ///< for the direction that is chosen
  std::optional<Touch> touch = {};          ///< also draws a close-up, cut open through proxy and HIP
  std::string title = {};
  field_file::Marks invented = {};  ///< bricks whose surface nobody scanned: hatched, with a legend
};

Picture surface_picture(const FieldView& field, const SurfaceOptions& options);

}  // namespace isotouch::view
