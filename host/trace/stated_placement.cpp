#include "host/trace/stated_placement.h"

#include <bit>
#include <cmath>
#include <cstdint>

#include "host/to_double.h"
#include "shared/bytes.h"

namespace isotouch::trace {

std::optional<StatedPlacement> stated_placement(const FieldView& field) {
  using namespace image_layout;
  const auto real = [&](std::size_t at) { return std::bit_cast<double>(load_le<std::uint64_t>(field.image.data() + at)); };
  const StatedPlacement stated{real(kScaleAt), {real(kOffsetAt), real(kOffsetAt + 8), real(kOffsetAt + 16)}};
  if (!(stated.scale > 0 && std::isfinite(stated.scale) && stated.offset.allFinite())) return std::nullopt;
  const Eigen::Vector3d low = to_double(field.origin);
  const Eigen::Vector3d high = low + to_double(field.edge) * Eigen::Vector3d(field.size[0], field.size[1], field.size[2]);
  for (const Eigen::Vector3d& corner :
       {low, high}) {  // coordinates of a scan are 1e12 at most (host/cloud/check.h), and the box is a little larger
    if (!((corner - stated.offset).array().abs() < 1e14 * stated.scale).all()) return std::nullopt;
  }
  return stated;
}

}  // namespace isotouch::trace
