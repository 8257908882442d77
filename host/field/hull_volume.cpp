#include "host/field/hull_volume.h"

#include <algorithm>
#include <cstddef>
#include <numeric>

#include "host/field/orientation.h"
#include "host/field/parallel.h"

namespace isotouch::field {

namespace {

using Eigen::Vector3d;

constexpr int kCells = 40;

/// Between two parallel planes that touch the points.
struct Slab {
  Vector3d direction;
  double low, high;

  bool holds(const Vector3d& p) const {
    const double along = direction.dot(p);
    return along >= low && along <= high;
  }
};

Slab slab_round(const std::vector<Vector3d>& points, const Vector3d& direction) {
  Slab slab{direction, direction.dot(points[0]), direction.dot(points[0])};
  for (const Vector3d& p : points) {
    const double along = direction.dot(p);
    slab.low = std::min(slab.low, along);
    slab.high = std::max(slab.high, along);
  }
  return slab;
}

}  // namespace

double hull_volume(const std::vector<Vector3d>& points) {
  const std::vector<Vector3d> directions = half_directions();
  std::vector<Slab> slabs(directions.size());
  in_parallel(slabs.size(), 16, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n) slabs[n] = slab_round(points, directions[n]);
  });
  Vector3d low = points[0], high = points[0];
  for (const Vector3d& p : points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const Vector3d cell = (high - low) / kCells;
  std::vector<int> held(kCells, 0);  // of each layer
  in_parallel(kCells, 4, [&](std::size_t begin, std::size_t end) {
    for (std::size_t z = begin; z < end; ++z) {
      for (int y = 0; y < kCells; ++y) {
        const auto middle = [&](int x) {
          return Vector3d(low + cell.cwiseProduct(Vector3d(x + 0.5, y + 0.5, static_cast<double>(z) + 0.5)));
        };
        // A slab holds a run of the row, so only the ends of what is left are asked.
        int first = 0, last = kCells;
        for (const Slab& slab : slabs) {
          while (first < last && !slab.holds(middle(first))) ++first;
          while (first < last && !slab.holds(middle(last - 1))) --last;
        }
        held[z] += last - first;
      }
    }
  });
  return static_cast<double>(std::accumulate(held.begin(), held.end(), 0)) * cell.prod();
}

}  // namespace isotouch::field
