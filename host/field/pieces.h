/// Splitting a neighbourhood where its normals jump.
#pragma once

#include <span>
#include <vector>

#include "host/field/patch_fit.h"

namespace isotouch::field {

/// The tree of the smallest jumps that join all samples (minimum spanning tree). Two samples on one circular arc have no jump beyond the
/// turn of their normals; an edge between them adds the asymmetry of their tangent planes.
class JumpTree {
 public:
  explicit JumpTree(std::span<const WeightedSample> samples);

  /// The piece of every sample, numbered by first appearance, when the `count - 1` largest jumps are cut.
  ///
  /// count     1 to the number of samples
  void split(std::size_t count, std::vector<std::size_t>& piece_of) const;

  /// The size of the `rank`-th largest jump, rank from 0; 0 = no jump, 2 = the normals are opposed.
  double jump(std::size_t rank) const { return edges_[edges_.size() - 1 - rank].size; }

 private:
  struct Edge {
    double size;
    std::size_t a, b;
    bool operator<(const Edge& o) const { return size != o.size ? size < o.size : a != o.a ? a < o.a : b < o.b; }
  };
  std::size_t samples_;
  std::vector<Edge> edges_;  ///< ascending, one less than samples
};

}  // namespace isotouch::field
