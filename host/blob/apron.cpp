#include "host/blob/apron.h"

#include <cmath>

namespace isotouch::blob {

Neighbours neighbours(const BrickRows& rows, const Eigen::Vector3i& cell) {
  Neighbours found{};
  std::size_t n = 0;
  for (int z = -1; z <= 1; ++z) {
    for (int y = -1; y <= 1; ++y) {
      for (int x = -1; x <= 1; ++x) found[n++] = rows.find(cell + Eigen::Vector3i(x, y, z));
    }
  }
  return found;
}

Apron gather(const std::vector<Samples>& samples, const Neighbours& around) {
  Apron apron{};
  std::size_t n = 0;
  for (int z = -1; z < 5; ++z) {
    for (int y = -1; y < 5; ++y) {
      for (int x = -1; x < 5; ++x) {
        const int cell = ((z + 4) / 4 * 3 + (y + 4) / 4) * 3 + (x + 4) / 4;
        const std::size_t brick = around[static_cast<std::size_t>(cell)];
        apron[n++] = brick == BrickRows::kAbsent ? NAN : samples[brick][sample_number(x & 3, y & 3, z & 3)];
      }
    }
  }
  return apron;
}

}  // namespace isotouch::blob
