#include "host/live/brick_surroundings.h"

#include <algorithm>

#include "shared/field_view.h"

namespace isotouch::live {

namespace {

std::array<const Node*, 27> around(const Node& node, const Nodes& nodes) {
  std::array<const Node*, 27> found{};
  const Eigen::Vector3i own = node.cell / 4;
  for (int n = 0; n < 27; ++n)
    found[static_cast<std::size_t>(n)] = nodes.find(own.x() + n % 3 - 1, own.y() + n / 3 % 3 - 1, own.z() + n / 9 - 1);
  return found;
}

/// A brick with so many of its two rings fewer.
template <class Cube, std::size_t kFewer>
Cube without_rings(const encoding::Surroundings& surroundings) {
  Cube cube;
  auto out = cube.begin();
  for (std::size_t z = kFewer; z < 8 - kFewer; ++z) {
    for (std::size_t y = kFewer; y < 8 - kFewer; ++y) out = std::copy_n(&surroundings[(z * 8 + y) * 8 + kFewer], 8 - 2 * kFewer, out);
  }
  return cube;
}

/// Of a set and all that touch it along one axis, those that lie in the node `step` (-1, 0 or 1) further on.
///
/// low      the bricks at 0 on the axis
/// stride   from one to the next
NodeMask spill(NodeMask set, int step, NodeMask low, int stride) {
  const NodeMask high = low << 3 * stride;
  if (step < 0) return (set & low) << 3 * stride;
  if (step > 0) return (set & high) >> 3 * stride;
  return set | (set & ~high) << stride | (set & ~low) >> stride;
}

}  // namespace

BrickSurroundings::BrickSurroundings(const Node& node, const Nodes& nodes, std::int16_t band) : nodes_(around(node, nodes)) {
  outside_.fill(band);
  inside_.fill(static_cast<std::int16_t>(-band));
}

encoding::Surroundings BrickSurroundings::of(std::size_t brick) const {
  const Eigen::Vector3i cell(static_cast<int>(brick & 3), static_cast<int>(brick >> 2 & 3), static_cast<int>(brick >> 4));
  std::array<const encoding::Coefficients*, 27> bricks;
  for (int n = 0; n < 27; ++n) {
    const Eigen::Vector3i other = (cell.array() + Eigen::Array3i(n % 3, n / 3 % 3, n / 9) - 1 + 4).matrix();  // from the node before on
    const Node* node = nodes_[static_cast<std::size_t>((other.z() >> 2) * 9 + (other.y() >> 2) * 3 + (other.x() >> 2))];
    const auto at = static_cast<std::size_t>((other.x() & 3) | (other.y() & 3) << 2 | (other.z() & 3) << 4);
    bricks[static_cast<std::size_t>(n)] = node == nullptr                           ? &outside_
                                          : (node->stored >> at & NodeMask{1}) != 0 ? &node->values(at)
                                          : (node->inside >> at & NodeMask{1}) != 0 ? &inside_
                                                                                    : &outside_;
  }
  encoding::Surroundings all;
  float* out = all.data();
  const auto copy = [&out](const encoding::Coefficients& from, std::size_t at, std::size_t count) {
    for (std::size_t n = 0; n < count; ++n) *out++ = static_cast<float>(from[at + n]) / (1 << Distance::kFractionBits);
  };
  for (int z = -2; z < 6; ++z) {
    for (int y = -2; y < 6; ++y) {
      const auto* row = &bricks[static_cast<std::size_t>(((z + 4) / 4 * 3 + (y + 4) / 4) * 3)];
      const std::size_t at = encoding::sample_number(0, y & 3, z & 3);
      copy(*row[0], at + 2, 2);
      copy(*row[1], at, 4);
      copy(*row[2], at, 2);
    }
  }
  return all;
}

encoding::Apron apron_of(const encoding::Surroundings& surroundings) { return without_rings<encoding::Apron, 1>(surroundings); }

encoding::Samples samples_of(const encoding::Surroundings& surroundings) { return without_rings<encoding::Samples, 2>(surroundings); }

void mark_around(const Node& node, NodeMask changed, const Nodes& nodes) {
  const Eigen::Vector3i own = node.cell / 4;
  for (int z = -1; z <= 1; ++z) {
    for (int y = -1; y <= 1; ++y) {
      for (int x = -1; x <= 1; ++x) {
        Node* other = nodes.find(own.x() + x, own.y() + y, own.z() + z);
        if (other == nullptr) continue;
        other->stale |= spill(spill(spill(changed, x, 0x1111111111111111U, 1), y, 0x000F000F000F000FU, 4), z, 0xFFFFU, 16);
      }
    }
  }
}

}  // namespace isotouch::live
