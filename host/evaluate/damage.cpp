#include "host/evaluate/damage.h"

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

#include "host/cloud/check.h"
#include "host/cloud/random.h"

namespace isotouch::evaluate {

namespace {

using cloud::Random;
using Eigen::Vector3d;

Vector3d any_direction(Random& random) {
  for (;;) {
    const Vector3d way = Vector3d::NullaryExpr([&](Eigen::Index) { return random.uniform(-1, 1); });
    const double length = way.norm();
    if (length > 0.1 && length <= 1) return way / length;
  }
}

std::size_t share_of(std::size_t count, double share) { return static_cast<std::size_t>(std::lround(share * static_cast<double>(count))); }

}  // namespace

cloud::OrientedPoints damaged(const cloud::OrientedPoints& points, const Damage& damage, std::uint64_t seed) {
  cloud::OrientedPoints result = points;
  if (damage.noise > 0) {
    Random random(seed);
    const double deviation = damage.noise * cloud::median_spacing(points.positions);
    for (Vector3d& position : result.positions) {
      for (double& coordinate : position) coordinate += deviation * random.gaussian();
    }
  }
  if (damage.turned > 0) {
    Random random(seed + 1);
    std::vector<std::size_t> order(points.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    for (std::size_t i = 0; i < share_of(points.size(), damage.turned); ++i) {
      std::swap(order[i], order[i + random.bits() % (order.size() - i)]);
      result.normals[order[i]] = -result.normals[order[i]];
    }
  }
  if (damage.strays > 0) {
    Random random(seed + 2);
    Eigen::AlignedBox3d box;
    for (const Vector3d& position : points.positions) box.extend(position);
    const double margin = kStrayMargin * box.sizes().maxCoeff();
    for (std::size_t i = 0; i < share_of(points.size(), damage.strays); ++i) {
      Vector3d place;
      for (int axis = 0; axis < 3; ++axis) place[axis] = random.uniform(box.min()[axis] - margin, box.max()[axis] + margin);
      result.positions.push_back(place);
      result.normals.push_back(any_direction(random));
    }
  }
  return result;
}

}  // namespace isotouch::evaluate
