#include "host/live/nodes.h"

namespace isotouch::live {

Nodes::Nodes(const Eigen::Vector3i& size, float influence)
    : size_((size.array() + 15) / 16),
      bricks_((size.array() + 3) / 4),
      influence_(influence),
      nodes_(static_cast<std::size_t>(size_.x()) * static_cast<std::size_t>(size_.y()) * static_cast<std::size_t>(size_.z())) {}

Node* Nodes::find(int x, int y, int z) const {
  if (x < 0 || y < 0 || z < 0 || x >= size_.x() || y >= size_.y() || z >= size_.z()) return nullptr;
  return nodes_[number(x, y, z)].get();
}

Node& Nodes::make(int x, int y, int z) {
  auto& node = nodes_[number(x, y, z)];
  if (!node) {
    node = std::make_unique<Node>();
    node->cell = 4 * Eigen::Vector3i(x, y, z);
    node->influence.fill(influence_);
    node->largest_influence = influence_;
    all_.push_back(node.get());
  }
  return *node;
}

}  // namespace isotouch::live
