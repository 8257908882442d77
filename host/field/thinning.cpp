#include "host/field/thinning.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <vector>

namespace isotouch::field {

namespace {

using Eigen::Vector3d;

constexpr double kAlike = 0.7;        // cosine: normals within 45 degrees belong together
constexpr std::size_t kMinority = 3;  // times larger is the group that a stray one opposes

/// A point's cell as one number, and which point.
struct Placed {
  std::uint64_t cell;
  std::uint32_t point;

  bool operator<(const Placed& o) const { return cell < o.cell || (cell == o.cell && point < o.point); }
};

/// Points of one cell whose normals agree with the first one's.
struct Group {
  Vector3d normal;
  Vector3d sum = Vector3d::Zero();
  std::vector<std::uint32_t> members;
};

std::uint64_t cell_number(const Vector3d& position, double cell) {
  constexpr double kMiddle = 1 << 20;
  std::uint64_t number = 0;
  for (int axis = 2; axis >= 0; --axis) {
    const double along = std::clamp(std::floor(position[axis] / cell) + kMiddle, 0.0, 2 * kMiddle - 1);
    number = number << 21 | static_cast<std::uint64_t>(along);
  }
  return number;
}

class Cell {
 public:
  void add(const cloud::OrientedPoints& points, std::uint32_t point) {
    const Vector3d& normal = points.normals[point];
    auto group = std::find_if(groups_.begin(), groups_.end(), [&](const Group& g) { return g.normal.dot(normal) > kAlike; });
    if (group == groups_.end()) group = groups_.insert(groups_.end(), Group{normal, Vector3d::Zero(), {}});
    group->sum += points.positions[point];
    group->members.push_back(point);
  }

  /// Appends what stays, and empties the cell.
  void give(const cloud::OrientedPoints& points, cloud::OrientedPoints& kept) {
    for (const Group& group : groups_) {
      const auto outvotes = [&](const Group& o) {
        return o.normal.dot(group.normal) < -kAlike && o.members.size() >= kMinority * group.members.size();
      };
      if (std::any_of(groups_.begin(), groups_.end(), outvotes)) continue;
      const Vector3d mean = group.sum / static_cast<double>(group.members.size());
      const auto farther = [&](std::uint32_t a, std::uint32_t b) {
        return (points.positions[a] - mean).squaredNorm() < (points.positions[b] - mean).squaredNorm();
      };
      const std::uint32_t chosen = *std::min_element(group.members.begin(), group.members.end(), farther);
      kept.positions.push_back(points.positions[chosen]);
      kept.normals.push_back(points.normals[chosen]);
      if (!points.stiffness.empty()) {
        const auto add = [&](double sum_so_far, std::uint32_t member) { return sum_so_far + points.stiffness[member]; };
        kept.stiffness.push_back(std::accumulate(group.members.begin(), group.members.end(), 0.0, add) /
                                 static_cast<double>(group.members.size()));
      }
    }
    groups_.clear();
  }

 private:
  std::vector<Group> groups_;
};

}  // namespace

cloud::OrientedPoints thinned(const cloud::OrientedPoints& points, double cell) {
  std::vector<Placed> placed(points.size());
  for (std::uint32_t i = 0; i < placed.size(); ++i) placed[i] = {cell_number(points.positions[i], cell), i};
  std::sort(placed.begin(), placed.end());
  cloud::OrientedPoints kept;
  Cell current;
  for (std::size_t n = 0; n < placed.size(); ++n) {
    current.add(points, placed[n].point);
    if (n + 1 == placed.size() || placed[n + 1].cell != placed[n].cell) current.give(points, kept);
  }
  return kept;
}

}  // namespace isotouch::field
