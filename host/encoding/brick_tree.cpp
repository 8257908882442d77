#include "host/encoding/brick_tree.h"

#include <algorithm>
#include <array>

#include "shared/field_view.h"

namespace isotouch::encoding {

namespace {

using image_layout::kBricksPerNode;
using image_layout::kInside;
using image_layout::kOutside;

/// One layer of nodes: a number for every cell in it, 4 cells high, padded to whole nodes along x and y.
struct Slab {
  Eigen::Vector3i nodes;  ///< of the whole grid
  std::vector<std::uint32_t> cells;

  std::uint32_t* row(int y, int z) {
    return &cells[static_cast<std::size_t>(z * 4 * nodes.y() + y) * static_cast<std::size_t>(4 * nodes.x())];
  }
};

/// Whether the cells after `brick` in its row are inside: the sign of most of the 16 samples that face them.
bool faces_inside(const field::Brick& brick) {
  int inside = 0;
  for (std::size_t n = 3; n < 64; n += 4) inside += brick.distance[n] < 0.0F ? 1 : -1;
  return inside > 0;
}

/// Numbers the cells of one row; a stored brick is 2 + its place in the field's list.
void fill_row(std::uint32_t* cells, const BrickRows& rows, int y, int z, const std::vector<BrickKind>& kinds) {
  int next = 0;
  std::uint32_t gap = kOutside;
  for (const field::Brick& brick : rows.row(y, z)) {
    std::fill(cells + next, cells + brick.cell.x(), gap);
    const std::size_t place = rows.place(brick);
    const bool stored = kinds[place] == BrickKind::kStored;
    cells[brick.cell.x()] = static_cast<std::uint32_t>(kinds[place]) + (stored ? static_cast<std::uint32_t>(place) : 0);
    gap = faces_inside(brick) ? kInside : kOutside;
    next = brick.cell.x() + 1;
  }
  std::fill(cells + next, cells + rows.size().x(), gap);
}

std::array<std::uint32_t, kBricksPerNode> cut_node(Slab& slab, int node_x, int node_y) {
  std::array<std::uint32_t, kBricksPerNode> node{};
  for (int z = 0; z < 4; ++z) {
    for (int y = 0; y < 4; ++y) std::copy_n(slab.row(4 * node_y + y, z) + 4 * node_x, 4, &node[static_cast<std::size_t>(16 * z + 4 * y)]);
  }
  return node;
}

}  // namespace

BrickTree brick_tree(const BrickRows& rows, const std::vector<BrickKind>& kinds) {
  BrickTree tree;
  tree.nodes.assign(kBricksPerNode, kOutside);
  tree.nodes.insert(tree.nodes.end(), kBricksPerNode, kInside);

  Slab slab{(rows.size().array() + 3) / 4, {}};
  slab.cells.resize(static_cast<std::size_t>(slab.nodes.x() * slab.nodes.y()) * kBricksPerNode);
  for (int node_z = 0; node_z < slab.nodes.z(); ++node_z) {
    std::fill(slab.cells.begin(), slab.cells.end(), kOutside);
    for (int z = 0; z < std::min(4, rows.size().z() - 4 * node_z); ++z) {
      for (int y = 0; y < rows.size().y(); ++y) fill_row(slab.row(y, z), rows, y, 4 * node_z + z, kinds);
    }
    for (int node_y = 0; node_y < slab.nodes.y(); ++node_y) {
      for (int node_x = 0; node_x < slab.nodes.x(); ++node_x) {
        auto node = cut_node(slab, node_x, node_y);
        if (node[0] <= kInside && std::all_of(node.begin(), node.end(), [&](std::uint32_t cell) { return cell == node[0]; })) {
          tree.root.push_back(node[0]);
          continue;
        }
        for (std::uint32_t& cell : node) {
          if (cell <= kInside) continue;
          tree.stored.push_back(cell - 2);
          cell = static_cast<std::uint32_t>(tree.stored.size() + 1);
        }
        tree.root.push_back(static_cast<std::uint32_t>(tree.nodes.size() / kBricksPerNode));
        tree.nodes.insert(tree.nodes.end(), node.begin(), node.end());
      }
    }
  }
  return tree;
}

}  // namespace isotouch::encoding
