#include "host/encoding/apron.h"

#include <algorithm>
#include <cmath>

#include "host/encoding/brick_rows.h"
#include "host/field/parallel.h"

namespace isotouch::encoding {

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
  std::array<const float*, 27> bricks;
  for (std::size_t n = 0; n < bricks.size(); ++n) bricks[n] = around[n] == kAbsent ? kNone.data() : samples[around[n]].data();
  Apron apron;
  float* out = apron.data();
  const auto gather_row = [&](std::size_t row, std::size_t at) {
    const float *before = bricks[row] + at, *here = bricks[row + 1] + at, *behind = bricks[row + 2] + at;
    out[0] = before[3];
    std::copy_n(here, 4, out + 1);
    out[5] = behind[0];
    out += 6;
  };
  const auto gather_layer = [&](std::size_t layer, std::size_t at) {
    gather_row(layer, at + 12);
    for (std::size_t y = 0; y < 4; ++y) gather_row(layer + 3, at + 4 * y);
    gather_row(layer + 6, at);
  };
  gather_layer(0, 48);
  for (std::size_t z = 0; z < 4; ++z) gather_layer(9, 16 * z);
  gather_layer(18, 0);
  return apron;
}

}  // namespace isotouch::encoding
