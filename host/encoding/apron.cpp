#include "host/encoding/apron.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "host/encoding/brick_rows.h"
#include "host/field/parallel.h"

namespace isotouch::encoding {

std::vector<Neighbours> neighbours(const field::BandField& field) {
  const BrickRows rows(field);
  std::vector<Neighbours> found(field.bricks.size());
  field::in_parallel(found.size(), 256, [&](std::size_t begin, std::size_t end) {
    // The bricks of a row follow each other, and so do their neighbours in each row beside it.
    std::array<std::span<const field::Brick>, 9> beside;
    const field::Brick* before = nullptr;
    for (std::size_t b = begin; b < end; ++b) {
      const field::Brick& brick = field.bricks[b];
      const Eigen::Vector3i& cell = brick.cell;
      const auto too_low = [&](const field::Brick& other) { return other.cell.x() < cell.x() - 1; };
      if (before == nullptr || before->cell.y() != cell.y() || before->cell.z() != cell.z()) {
        for (std::size_t n = 0; n < beside.size(); ++n) {
          const auto row = rows.row(cell.y() + static_cast<int>(n % 3) - 1, cell.z() + static_cast<int>(n / 3) - 1);
          beside[n] = {std::partition_point(row.begin(), row.end(), too_low), row.end()};
        }
      }
      before = &brick;
      found[b].fill(kAbsent);
      for (std::size_t n = 0; n < beside.size(); ++n) {
        auto& row = beside[n];
        while (!row.empty() && too_low(row.front())) row = row.subspan(1);
        for (std::size_t k = 0; k < row.size(); ++k) {
          const int x = row[k].cell.x() - cell.x();
          if (x > 1) break;
          found[b][3 * n + static_cast<std::size_t>(x + 1)] = static_cast<std::uint32_t>(rows.place(row[k]));
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
