/// The felt samples near the bricks of one node, gathered once for all of them, and those that matter for each brick.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "host/field/blend_brick.h"
#include "host/live/live_model.h"
#include "host/live/nodes.h"

namespace isotouch::live {

/// Squared distance of a sample from a brick's middle, of their difference. Positions are whole 1/128 voxels, so the difference is exact in floats, and
/// whoever asks gets the same bits.
inline float squared(float x, float y, float z) { return (x * x + y * y) + z * z; }

class NearSamples {
 public:
  /// One of the samples nearest to a brick's middle.
  struct Nearest {
    float squared_distance;
    std::uint32_t sample;
    const LiveModel* live;
  };

  /// Gathers what may matter for some bricks of a node. Reuse keeps the memory.
  void gather(const Node& node, NodeMask bricks, const Nodes& nodes, const Reach& reach);

  /// Chooses for a brick.
  ///
  /// bound     a guess of the influence, squared: it changes the time and not the result
  void choose(std::size_t brick, float bound);
  /// Among them are the nine nearest of every place, as far as they are within `reach.blend` of it. Always in the same order, whatever came first.
  /// Looked for when asked.
  std::span<const field::BlendCandidate> candidates();
  /// The nine nearest to the middle, ascending; fewer where there are not as many.
  std::span<const Nearest> nearest() const { return nearest_; }
  /// Squared, from the middle: a sample beyond that would not change them.
  float influence() const { return ninth_; }

 private:
  struct Away {
    float square;
    std::uint32_t sample;
  };

  bool is_nearest(std::uint32_t sample) const;
  void find(float bound);
  void choose_nearest();
  Reach reach_{1.0};
  std::vector<float> x_, y_, z_;  ///< from the node's first place
  std::vector<const LiveModel*> live_;
  std::vector<Away> away_;
  std::span<const Away> found_;
  std::vector<Nearest> nearest_;
  std::vector<field::BlendCandidate> candidates_;
  float middle_x_ = 0.0F, middle_y_ = 0.0F, middle_z_ = 0.0F;
  float farthest_ = 0.0F, bound_ = 0.0F;  ///< squared; of what was found
  float ninth_ = 0.0F, within_ = 0.0F;    ///< the candidates
};

}  // namespace isotouch::live
