#include "host/evaluate/node_distances.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "firmware/core/field_sampler.h"
#include "host/evaluate/stored_surface.h"
#include "host/field/brick_neighbours.h"
#include "host/field/parallel.h"
#include "host/to_double.h"

namespace isotouch::evaluate {

namespace {

using Eigen::Vector3i;
using Cell = std::array<int, 3>;  // z, y, x: the order of a field's bricks

/// The stored bricks, those far inside that touch one far outside with a face, and all that touch one of these, sorted.
std::vector<Cell> cells_near(const FieldView& field, const Vector3i& cells) {
  using namespace image_layout;
  const auto number = [&](const Vector3i& cell) { return field.brick_number(4 * cell.x(), 4 * cell.y(), 4 * cell.z()); };
  std::vector<Cell> near;
  for (int z = 0; z < cells.z(); ++z) {
    for (int y = 0; y < cells.y(); ++y) {
      for (int x = 0; x < cells.x(); ++x) {
        const std::uint32_t here = number({x, y, z});
        if (here > kInside || jumps_beside(field, {x, y, z})) near.push_back({z, y, x});
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

/// Does the sign change from one sample to the next within the brick?
bool changes_sign(const field::Brick& brick) {
  const bool inside = brick.distance[0] < 0;
  return std::any_of(brick.distance.begin(), brick.distance.end(), [=](float d) { return (d < 0) != inside; });
}

/// The same from a brick to the one that follows it along an axis.
bool changes_sign(const field::Brick& brick, const field::Brick& next, std::size_t axis) {
  const std::size_t step = std::size_t{1} << 2 * axis;
  for (std::size_t n = 0; n < 64; ++n) {
    if (n / step % 4 == 0 && (next.distance[n] < 0) != (brick.distance[n + 3 * step] < 0)) return true;
  }
  return false;
}

}  // namespace

field::BandField node_distances(const FieldView& field) {
  require_stored_surface(field);
  field::BandField nodes;
  nodes.grid = {to_double(field.origin), to_double(field.edge), {field.size[0], field.size[1], field.size[2]}};
  nodes.band = to_double(field.band);
  const std::vector<Cell> near = cells_near(field, (nodes.grid.size + Vector3i::Constant(3)) / 4);
  std::vector<field::Brick> bricks(near.size());
  std::vector<std::uint8_t> listed(near.size());
  field::in_parallel(near.size(), 64, [&](std::size_t begin, std::size_t end) {
    for (std::size_t b = begin; b < end; ++b) {
      bricks[b].cell = {near[b][2], near[b][1], near[b][0]};
      for (int n = 0; n < 64; ++n) {
        const Vector3i node = (4 * bricks[b].cell + Vector3i(n & 3, n >> 2 & 3, n >> 4)).cwiseMin(nodes.grid.size - Vector3i::Ones());
        const auto index = [](int i) { return Voxel::from_raw(i << Voxel::kFractionBits); };
        const double d = to_double(core::sample_field(field, {index(node.x()), index(node.y()), index(node.z())}).distance);
        bricks[b].distance[static_cast<std::size_t>(n)] = static_cast<float>(d);
        if (std::abs(d) < nodes.band) listed[b] = 1;
      }
      if (changes_sign(bricks[b])) listed[b] = 1;
    }
  });
  const field::Following next = field::following(bricks);
  for (std::size_t b = 0; b < bricks.size(); ++b) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::uint32_t after = next[b][axis];
      if (after != field::kNoBrick && changes_sign(bricks[b], bricks[after], axis)) listed[b] = listed[after] = 1;
    }
  }
  for (std::size_t b = 0; b < bricks.size(); ++b) {
    if (listed[b] != 0) nodes.bricks.push_back(bricks[b]);
  }
  return nodes;
}

}  // namespace isotouch::evaluate
