#include "host/field/face_boxes.h"

#include "host/field/vector_lanes.h"

namespace isotouch::field {

const FacesWithin& widest_within() {
  switch (vector_lanes()) {
    case 16: return kWithinBySixteens;
    case 8: return kWithinByEights;
    default: return kWithinByFours;
  }
}

}  // namespace isotouch::field
