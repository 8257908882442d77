#include "host/evaluate/exact_field.h"

#include <cmath>

namespace isotouch::evaluate {

field::BandField exact_field(const field::Grid& grid, double band, const std::function<double(const Eigen::Vector3d&)>& distance) {
  field::BandField made{grid, band, {}};
  constexpr double kHalfDiagonal = 2.6;  // voxels, from a brick's middle to its outermost samples: 1.5 √3
  const Eigen::Vector3i bricks = (grid.size + Eigen::Vector3i::Constant(3)) / 4;
  for (int z = 0; z < bricks.z(); ++z) {
    for (int y = 0; y < bricks.y(); ++y) {
      for (int x = 0; x < bricks.x(); ++x) {
        const Eigen::Vector3i first(4 * x, 4 * y, 4 * z);
        const Eigen::Vector3d middle = grid.position(first) + Eigen::Vector3d::Constant(1.5 * grid.edge);
        if (std::abs(distance(middle)) > (band + kHalfDiagonal) * grid.edge) continue;
        field::Brick brick{Eigen::Vector3i(x, y, z), {}};
        for (int i = 0; i < 64; ++i) {
          const Eigen::Vector3i sample = first + Eigen::Vector3i(i & 3, (i >> 2) & 3, i >> 4);
          brick.distance[static_cast<std::size_t>(i)] = static_cast<float>(distance(grid.position(sample)) / grid.edge);
        }
        made.bricks.push_back(brick);
      }
    }
  }
  return made;
}

}  // namespace isotouch::evaluate
