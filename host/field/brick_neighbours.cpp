#include "host/field/brick_neighbours.h"

#include <algorithm>
#include <cstddef>

namespace isotouch::field {

Following following(const std::vector<Brick>& bricks) {
  Following next(bricks.size(), {kNoBrick, kNoBrick, kNoBrick});
  for (std::size_t axis = 0; axis < 3; ++axis) {
    std::size_t ahead = 0;
    for (std::size_t b = 0; b < bricks.size(); ++b) {
      const Eigen::Vector3i wanted = bricks[b].cell + Eigen::Vector3i::Unit(static_cast<Eigen::Index>(axis));
      while (ahead < bricks.size() && sort_key(bricks[ahead].cell) < sort_key(wanted)) ++ahead;
      if (ahead < bricks.size() && bricks[ahead].cell == wanted) next[b][axis] = static_cast<std::uint32_t>(ahead);
    }
  }
  return next;
}

std::vector<BrickMask> with_neighbours(const std::vector<BrickMask>& sets, const Following& next) {
  std::vector<BrickMask> all(sets.size());
  std::transform(sets.begin(), sets.end(), all.begin(), grown);
  for (std::size_t b = 0; b < sets.size(); ++b) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::uint32_t ahead = next[b][axis];
      if (ahead == kNoBrick) continue;
      all[ahead] |= face(sets[b], axis, 1);
      all[b] |= face(sets[ahead], axis, 0) << kAcross[axis];
    }
  }
  return all;
}

}  // namespace isotouch::field
