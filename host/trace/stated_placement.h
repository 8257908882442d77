/// Where the header of a field says that its scan lies in the workspace.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "shared/field_view.h"

namespace isotouch::trace {

/// workspace = scale × scan + offset
struct StatedPlacement {
  double scale;            ///< mm a unit of the scan, positive
  Eigen::Vector3d offset;  ///< mm
};

/// returns   nothing where the header states none that can be: numbers that are not finite, a scale that is not positive, or a box of the field that
///           lies where no scan can
std::optional<StatedPlacement> stated_placement(const FieldView& field);

}  // namespace isotouch::trace
