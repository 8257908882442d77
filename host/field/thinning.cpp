#include "host/field/thinning.h"

#include <Eigen/Core>
#include <algorithm>
#include <cstddef>
#include <vector>

#include "host/field/parallel.h"

namespace isotouch::field {

namespace {

using Eigen::Vector3d;

constexpr double kAlike = 0.7;          // cosine: normals within 45 degrees belong together
constexpr std::uint32_t kMinority = 3;  // times larger is the group that a stray one opposes
constexpr std::uint32_t kLone = 2;      // points at an edge; the kept one of so few lies where it bends, and noise decides which way

/// Points of one cell whose normals agree with the first one's.
struct Group {
  Vector3d normal;
  Vector3d sum = Vector3d::Zero();
  double stiffness = 0.0;
  std::uint32_t size = 0;
  std::uint32_t chosen = 0;
  double off_mean = std::numeric_limits<double>::infinity();  ///< of the chosen one, squared
};

/// The groups of one cell, and which of them each of its points belongs to.
class Grouping {
 public:
  void of(const cloud::OrientedPoints& points, const CellOrder& order, const Cell& cell, std::span<std::uint32_t> group_of) {
    groups_.clear();
    for (std::uint32_t n = cell.first; n < cell.last; ++n) {
      const std::uint32_t point = order[n];
      const Vector3d& normal = points.normals[point];
      auto group = std::find_if(groups_.begin(), groups_.end(), [&](const Group& g) { return g.normal.dot(normal) > kAlike; });
      if (group == groups_.end()) group = groups_.insert(groups_.end(), Group{normal});
      group->sum += points.positions[point];
      if (!points.stiffness.empty()) group->stiffness += points.stiffness[point];
      ++group->size;
      group_of[n] = static_cast<std::uint32_t>(group - groups_.begin());
    }
    for (std::uint32_t n = cell.first; n < cell.last; ++n) {
      Group& group = groups_[group_of[n]];
      const double off = (points.positions[order[n]] - group.sum / group.size).squaredNorm();
      if (off < group.off_mean) group.off_mean = off, group.chosen = order[n];
    }
  }

  const std::vector<Group>& groups() const { return groups_; }

  bool stray(const Group& group) const {
    return std::any_of(groups_.begin(), groups_.end(), [&](const Group& other) {
      return other.normal.dot(group.normal) < -kAlike && other.size >= kMinority * group.size;
    });
  }

  /// Which group stands for the points of one: itself, or for a lone one the largest other that does not oppose it.
  std::size_t standing_for(std::size_t group) const {
    const Group& own = groups_[group];
    if (own.size > kLone) return group;
    std::size_t best = group;
    for (std::size_t n = 0; n < groups_.size(); ++n) {
      if (groups_[n].normal.dot(own.normal) < -kAlike) continue;
      if (groups_[n].size > groups_[best].size || (groups_[n].size == groups_[best].size && n < best)) best = n;
    }
    return best == group ? group : standing_for(best);
  }

 private:
  std::vector<Group> groups_;
};

}  // namespace

Thinned thinned(const cloud::OrientedPoints& points, const CellOrder& order, std::span<const Cell> cells) {
  constexpr std::size_t kGrain = 256;  // cells a range
  struct Range {
    cloud::OrientedPoints samples;
    std::vector<std::uint32_t> point;
    std::uint32_t before = 0;  ///< samples of the ranges before
  };
  std::vector<Range> ranges((cells.size() + kGrain - 1) / kGrain);
  Thinned result{{}, {}, std::vector<std::uint32_t>(order.size(), Thinned::kStray)};
  in_parallel(cells.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    Grouping grouping;
    std::vector<std::uint32_t> number;  // of each group's sample in its range
    auto& [kept, point, before] = ranges[begin / kGrain];
    for (const Cell& cell : cells.subspan(begin, end - begin)) {
      grouping.of(points, order, cell, result.sample_of);
      number.clear();
      for (std::size_t g = 0; g < grouping.groups().size(); ++g) {
        const Group& group = grouping.groups()[g];
        if (grouping.stray(group) || grouping.standing_for(g) != g) {
          number.push_back(Thinned::kStray);
          continue;
        }
        number.push_back(static_cast<std::uint32_t>(kept.size()));
        point.push_back(group.chosen);
        kept.positions.push_back(points.positions[group.chosen]);
        kept.normals.push_back(points.normals[group.chosen]);
        if (!points.stiffness.empty()) kept.stiffness.push_back(group.stiffness / group.size);
      }
      for (std::uint32_t n = cell.first; n < cell.last; ++n) result.sample_of[n] = number[grouping.standing_for(result.sample_of[n])];
    }
  });
  for (std::size_t r = 1; r < ranges.size(); ++r)
    ranges[r].before = ranges[r - 1].before + static_cast<std::uint32_t>(ranges[r - 1].samples.size());
  in_parallel(cells.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = cells[begin].first; n < cells[end - 1].last; ++n) {
      if (result.sample_of[n] != Thinned::kStray) result.sample_of[n] += ranges[begin / kGrain].before;
    }
  });
  const auto append = [](auto& all, const auto& part) { all.insert(all.end(), part.begin(), part.end()); };
  for (const Range& range : ranges) {
    append(result.point, range.point);
    append(result.samples.positions, range.samples.positions);
    append(result.samples.normals, range.samples.normals);
    append(result.samples.stiffness, range.samples.stiffness);
  }
  return result;
}

}  // namespace isotouch::field
