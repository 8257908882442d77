/// The memory of a live field, by place: nodes of 4×4×4 bricks, as in an image, with the samples and the values of every brick.
#pragma once

#include <Eigen/Core>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "host/encoding/spline.h"
#include "host/live/bucket.h"
#include "host/live/live_model.h"

namespace isotouch::live {

/// A set of a node's bricks, x fastest.
using NodeMask = std::uint64_t;

/// A sample as its neighbours see it.
struct Entry {
  Mean mean;
  std::uint64_t key = 0;            ///< of its bucket
  std::uint32_t slot = 0;           ///< where the rest of it is
  bool felt = false;                ///< it has a model,
  bool dirty = false;               ///< which is to be fitted
  const LiveModel* live = nullptr;  ///< the model; it stays where it is
  double influence = 0.0;           ///< squared: a sample beyond that does not change its model
};

struct Node {
  Eigen::Vector3i cell;                        ///< of its first brick
  NodeMask occupied = 0;                       ///< by samples
  NodeMask dirty = 0;                          ///< values are to be computed
  NodeMask stale = 0;                          ///< slope and wall are to be computed
  NodeMask stored = 0, inside = 0;             ///< kinds; the other bricks are outside
  std::array<float, 64> influence{};           ///< squared, from the brick's middle: a sample beyond that does not change its values
  float largest_influence = 0.0F;              ///< of them
  std::array<double, 64> model_influence{};    ///< squared: a sample farther away from the brick changes the model of none of its samples
  std::array<float, 64> slope{}, wall{};       ///< squared, voxels a voxel; voxels
  std::array<std::vector<Entry>, 64> samples;  ///< those that lie in each brick, by key
  std::vector<encoding::Coefficients> bricks;  ///< the values of the stored ones, one after the other

  /// Of a stored brick.
  const encoding::Coefficients& values(std::size_t brick) const {
    return bricks[static_cast<std::size_t>(std::popcount(stored & ((NodeMask{1} << brick) - 1)))];
  }
};

class Nodes {
 public:
  /// size        of the grid, samples along each axis
  /// influence   of a brick that was never computed, squared
  Nodes(const Eigen::Vector3i& size, float influence);

  /// Nodes along each axis.
  const Eigen::Vector3i& size() const { return size_; }
  /// Bricks along each axis.
  const Eigen::Vector3i& bricks() const { return bricks_; }
  /// Nothing where no sample was ever near, and outside the grid.
  Node* find(int x, int y, int z) const;
  Node& make(int x, int y, int z);
  /// All there are.
  const std::vector<Node*>& all() const { return all_; }
  /// One for each place, x fastest.
  const std::vector<std::unique_ptr<Node>>& by_place() const { return nodes_; }

  /// Calls visit(node, brick number) for bricks of existing nodes, among them all that hold samples and meet the ball; always in the same order.
  template <class Visit>
  void occupied_in_ball(const Eigen::Vector3d& middle, double radius, const Visit& visit) const {
    occupied_in_box(middle.array() - radius, middle.array() + radius, visit);
  }
  template <class Visit>
  void occupied_in_box(const Eigen::Array3d& lowest, const Eigen::Array3d& highest, const Visit& visit) const {
    const Eigen::Vector3i low = bricks_at(lowest).cwiseMax(0);
    const Eigen::Vector3i high = bricks_at(highest).cwiseMin(bricks_ - Eigen::Vector3i::Ones());
    for (int z = low.z() >> 2; z <= high.z() >> 2; ++z) {
      for (int y = low.y() >> 2; y <= high.y() >> 2; ++y) {
        for (int x = low.x() >> 2; x <= high.x() >> 2; ++x) {
          Node* node = find(x, y, z);
          if (node == nullptr) continue;
          const NodeMask box = range(low.x() - 4 * x, high.x() - 4 * x, 0x1111111111111111U, 1) &
                               range(low.y() - 4 * y, high.y() - 4 * y, 0x000F000F000F000FU, 4) &
                               range(low.z() - 4 * z, high.z() - 4 * z, 0xFFFFU, 16);
          for (NodeMask left = node->occupied & box; left != 0; left &= left - 1)
            visit(*node, static_cast<std::size_t>(std::countr_zero(left)));
        }
      }
    }
  }

 private:
  static Eigen::Vector3i bricks_at(const Eigen::Array3d& index) { return (index / 4.0).floor().cast<int>().matrix(); }

  /// The bricks from low to high on one axis; `layer` are those at 0, `step` apart.
  static NodeMask range(int low, int high, NodeMask layer, int step) {
    NodeMask mask = 0;
    for (int at = low < 0 ? 0 : low; at <= (high > 3 ? 3 : high); ++at) mask |= layer << (step * at);
    return mask;
  }

  std::size_t number(int x, int y, int z) const {
    return (static_cast<std::size_t>(z) * static_cast<std::size_t>(size_.y()) + static_cast<std::size_t>(y)) *
               static_cast<std::size_t>(size_.x()) +
           static_cast<std::size_t>(x);
  }

  Eigen::Vector3i size_, bricks_;
  float influence_;
  std::vector<std::unique_ptr<Node>> nodes_;
  std::vector<Node*> all_;
};

/// The first place of a brick, index coordinates.
inline Eigen::Vector3i first_place(const Node& node, std::size_t brick) {
  return 4 * (node.cell + Eigen::Vector3i(static_cast<int>(brick & 3), static_cast<int>(brick >> 2 & 3), static_cast<int>(brick >> 4)));
}

/// Its middle.
inline Eigen::Vector3d middle_of(const Node& node, std::size_t brick) {
  return first_place(node, brick).cast<double>() + Eigen::Vector3d::Constant(1.5);
}

}  // namespace isotouch::live
