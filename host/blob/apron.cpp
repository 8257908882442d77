#include "host/blob/apron.h"

#include <algorithm>
#include <cmath>

#include "host/blob/brick_rows.h"
#include "host/field/parallel.h"

namespace isotouch::blob {

std::vector<Neighbours> neighbours(const field::BandField& field) {
  const BrickRows rows(field);
  std::vector<Neighbours> found(field.bricks.size());
  field::in_parallel(found.size(), 256, [&](std::size_t begin, std::size_t end) {
    for (std::size_t b = begin; b < end; ++b) {
      const Eigen::Vector3i& cell = field.bricks[b].cell;
      found[b].fill(kAbsent);
      for (int z = -1; z <= 1; ++z) {
        for (int y = -1; y <= 1; ++y) {
          const auto row = rows.row(cell.y() + y, cell.z() + z);
          const auto first = [](const field::Brick& brick, int x) { return brick.cell.x() < x; };
          for (auto at = std::lower_bound(row.begin(), row.end(), cell.x() - 1, first); at != row.end(); ++at) {
            const int x = at->cell.x() - cell.x();
            if (x > 1) break;
            found[b][static_cast<std::size_t>(((z + 1) * 3 + y + 1) * 3 + x + 1)] = static_cast<std::uint32_t>(rows.place(*at));
          }
        }
      }
    }
  });
  return found;
}

Apron gather(const std::vector<Samples>& samples, const Neighbours& around) {
  static constexpr Samples kNone = [] {
    Samples none{};
    none.fill(NAN);
    return none;
  }();
  const auto brick = [&](int n) {
    return around[static_cast<std::size_t>(n)] == kAbsent ? kNone.data() : samples[around[static_cast<std::size_t>(n)]].data();
  };
  Apron apron;
  float* out = apron.data();
  for (int z = -1; z < 5; ++z) {
    for (int y = -1; y < 5; ++y) {
      const int row = ((z + 4) / 4 * 3 + (y + 4) / 4) * 3;
      const std::size_t at = sample_number(0, y & 3, z & 3);
      *out++ = brick(row)[at + 3];
      out = std::copy_n(brick(row + 1) + at, 4, out);
      *out++ = brick(row + 2)[at];
    }
  }
  return apron;
}

}  // namespace isotouch::blob
