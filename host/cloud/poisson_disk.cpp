#include "host/cloud/poisson_disk.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <queue>
#include <utility>

namespace isotouch::cloud {
namespace {

using Eigen::Vector3d;
using Cell = std::array<std::int64_t, 3>;  // z, y, x: the order of the sort below

/// Points sorted into cubic cells, so that all within one cell's edge of a point are found in 27 cells, always in the same order.
class Cells {
 public:
  Cells(const std::vector<Vector3d>& positions, double edge) : positions_(positions), edge_(edge) {
    entries_.reserve(positions.size());
    for (std::size_t i = 0; i < positions.size(); ++i) entries_.emplace_back(cell(positions[i]), i);
    std::sort(entries_.begin(), entries_.end());
  }

  /// Calls `visit(j, squared distance)` for every point j within the edge of point i, except i itself.
  template <class Visit>
  void each_near(std::size_t i, const Visit& visit) const {
    const Cell middle = cell(positions_[i]);
    for (std::int64_t z = middle[0] - 1; z <= middle[0] + 1; ++z) {
      for (std::int64_t y = middle[1] - 1; y <= middle[1] + 1; ++y) {
        auto at = std::lower_bound(entries_.begin(), entries_.end(), std::pair(Cell{z, y, middle[2] - 1}, std::size_t{0}));
        for (; at != entries_.end() && at->first <= Cell{z, y, middle[2] + 1}; ++at) {
          const double squared = (positions_[at->second] - positions_[i]).squaredNorm();
          if (at->second != i && squared < edge_ * edge_) visit(at->second, squared);
        }
      }
    }
  }

 private:
  Cell cell(const Vector3d& p) const {
    const auto index = [&](double v) { return static_cast<std::int64_t>(std::floor(v / edge_)); };
    return {index(p.z()), index(p.y()), index(p.x())};
  }

  const std::vector<Vector3d>& positions_;
  double edge_;
  std::vector<std::pair<Cell, std::size_t>> entries_;
};

double eighth_power(double v) {
  const double squared = v * v;
  const double fourth = squared * squared;
  return fourth * fourth;
}

}  // namespace

std::vector<std::size_t> spread_out(const OrientedPoints& candidates, double area, std::size_t count) {
  std::vector<std::size_t> kept(candidates.size());
  std::iota(kept.begin(), kept.end(), std::size_t{0});
  if (candidates.size() <= count) return kept;

  const double share = static_cast<double>(count) / static_cast<double>(candidates.size());
  const double widest = std::sqrt(area / (2.0 * std::sqrt(3.0) * static_cast<double>(count)));  // half the spacing of the densest packing
  const double closest = 2.0 * widest * (1.0 - share * std::sqrt(share)) * 0.65;                // nearer pairs are all equally bad
  const Cells cells(candidates.positions, 2.0 * widest);
  const auto each_rival = [&](std::size_t i, const auto& visit) {
    cells.each_near(i, [&](std::size_t j, double squared) {
      if (candidates.normals[i].dot(candidates.normals[j]) < 0.0) return;
      visit(j, eighth_power(1.0 - std::max(std::sqrt(squared), closest) / (2.0 * widest)));
    });
  };

  std::vector<double> crowding(candidates.size(), 0.0);
  std::vector<std::pair<double, std::size_t>> entries;
  entries.reserve(candidates.size());
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    each_rival(i, [&](std::size_t, double weight) { crowding[i] += weight; });
    entries.emplace_back(crowding[i], i);
  }
  // Crowding only falls, so an entry of the queue that is out of date lies too high, and is found out when it comes up.
  std::priority_queue<std::pair<double, std::size_t>> queue({}, std::move(entries));
  std::vector<bool> removed(candidates.size(), false);
  for (std::size_t left = candidates.size(); left > count;) {
    const auto [weight, i] = queue.top();
    queue.pop();
    if (weight != crowding[i]) {
      queue.emplace(crowding[i], i);
      continue;
    }
    removed[i] = true;
    --left;
    each_rival(i, [&](std::size_t j, double rivalry) { crowding[j] -= rivalry; });
  }
  kept.erase(std::remove_if(kept.begin(), kept.end(), [&](std::size_t i) { return removed[i]; }), kept.end());
  return kept;
}

}  // namespace isotouch::cloud
