#include "host/evaluate/node_distances.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "firmware/core/field_sampler.h"
#include "host/field/parallel.h"
#include "host/to_double.h"

namespace isotouch::evaluate {

namespace {

using Eigen::Vector3i;
using Cell = std::array<int, 3>;  // z, y, x: the order of a field's bricks

/// The stored bricks and all that touch one, sorted.
std::vector<Cell> cells_near(const FieldView& field, const Vector3i& cells) {
  const std::int16_t* const first_stored = field.bricks + 2 * image_layout::kSamplesPerBrick;  // after the two constant ones
  std::vector<Cell> near;
  for (int z = 0; z < cells.z(); ++z) {
    for (int y = 0; y < cells.y(); ++y) {
      for (int x = 0; x < cells.x(); ++x) {
        if (field.brick(4 * x, 4 * y, 4 * z) >= first_stored) near.push_back({z, y, x});
      }
    }
  }
  const Cell ends = {cells.z(), cells.y(), cells.x()};
  for (std::size_t axis = 0; axis < 3; ++axis) {  // to both sides along each axis in turn
    for (std::size_t n = 0, count = near.size(); n < count; ++n) {
      for (const int step : {-1, 1}) {
        Cell beside = near[n];
        beside[axis] += step;
        if (beside[axis] >= 0 && beside[axis] < ends[axis]) near.push_back(beside);
      }
    }
    std::sort(near.begin(), near.end());
    near.erase(std::unique(near.begin(), near.end()), near.end());
  }
  return near;
}

}  // namespace

field::BandField node_distances(const FieldView& field) {
  field::BandField nodes;
  nodes.grid = {to_double(field.origin), to_double(field.edge), {field.size[0], field.size[1], field.size[2]}};
  nodes.band = to_double(field.band);
  const std::vector<Cell> near = cells_near(field, (nodes.grid.size + Vector3i::Constant(3)) / 4);
  std::vector<field::Brick> bricks(near.size());
  std::vector<std::uint8_t> within(near.size());
  field::in_parallel(near.size(), 64, [&](std::size_t begin, std::size_t end) {
    for (std::size_t b = begin; b < end; ++b) {
      bricks[b].cell = {near[b][2], near[b][1], near[b][0]};
      for (int n = 0; n < 64; ++n) {
        const Vector3i node = (4 * bricks[b].cell + Vector3i(n & 3, n >> 2 & 3, n >> 4)).cwiseMin(nodes.grid.size - Vector3i::Ones());
        const auto index = [](int i) { return Voxel::from_raw(i << Voxel::kFractionBits); };
        const double d = to_double(core::sample_field(field, {index(node.x()), index(node.y()), index(node.z())}).distance);
        bricks[b].distance[static_cast<std::size_t>(n)] = static_cast<float>(d);
        if (std::abs(d) < nodes.band) within[b] = 1;
      }
    }
  });
  for (std::size_t b = 0; b < bricks.size(); ++b) {
    if (within[b] != 0) nodes.bricks.push_back(bricks[b]);
  }
  return nodes;
}

}  // namespace isotouch::evaluate
