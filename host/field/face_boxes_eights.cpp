#include "host/field/face_boxes_lanes.h"

namespace isotouch::field {

const FacesWithin kWithinByEights{boxes_within, faces_within};

}  // namespace isotouch::field
