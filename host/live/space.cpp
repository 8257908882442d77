#include "host/live/space.h"

#include <array>

#include "host/field/default_grid.h"
#include "host/field/make_grid.h"
#include "host/live/live_field.h"

namespace isotouch::live {

Space space_for(const Eigen::AlignedBox3d& box, const SpaceOptions& options) {
  const std::array<Eigen::Vector3d, 2> corners = {box.min(), box.max()};
  Space space{box, options.stays ? cloud::Placement{} : cloud::place(corners, options.size), {}};
  const Eigen::Vector3d low = space.placement.to_workspace(corners[0]), high = space.placement.to_workspace(corners[1]);
  const double edge = options.voxel_mm.value_or((high - low).maxCoeff() / options.grid.value_or(field::kCoarseGrid));
  space.grid = field::make_grid(low, high, edge, margin(options.band));
  return space;
}

}  // namespace isotouch::live
