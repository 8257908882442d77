#include "host/field/behind_occlusions.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <vector>

#include "host/field/parallel.h"

namespace isotouch::field {

namespace {

using Eigen::Vector2d;
using Eigen::Vector2i;
using Eigen::Vector3d;

// Lengths in spacings.
constexpr double kBeside = 2.2;    // samples this near across the line of sight are neighbours in the picture
constexpr double kStep = 4.0;      // two heights that are so far apart, with no sample between them, are of two surfaces
constexpr double kEdge = 0.5;      // a sample of an edge has none of its own surface so far beyond it
constexpr double kAbreast = 1.0;   // and so far to the left or right at most
constexpr double kInFront = 0.5;   // what hides a surface lies in front of its tangent plane
constexpr double kApart = 0.5;     // the middles of the two surfaces, across the line of sight, at least
constexpr double kFlattest = 0.1;  // cosine; surface seen at a smaller angle counts as seen at this one
constexpr double kBelow = 0.7;     // of the way to what hides it

/// The samples of each cell of a picture.
class Cells {
 public:
  Cells(const Scan& scan, const FrontView& view) : view_(view), first_(view.index({0, view.size().y()}) + 1, 0), samples_(scan.size()) {
    for (const Vector3d& p : scan.positions()) ++first_[view.index(view.cell_of(p)) + 1];
    for (std::size_t c = 1; c < first_.size(); ++c) first_[c] += first_[c - 1];
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    for (std::uint32_t i = 0; i < scan.size(); ++i) samples_[next[view.index(view.cell_of(scan.positions()[i]))]++] = i;
  }

  /// Those of the cells up to `rings` away.
  template <typename Visit>
  void around(const Vector2i& cell, int rings, const Visit& visit) const {
    for (int y = std::max(0, cell.y() - rings); y <= std::min(view_.size().y() - 1, cell.y() + rings); ++y) {
      for (int x = std::max(0, cell.x() - rings); x <= std::min(view_.size().x() - 1, cell.x() + rings); ++x) {
        const std::size_t c = view_.index({x, y});
        for (std::uint32_t n = first_[c]; n < first_[c + 1]; ++n) visit(samples_[n]);
      }
    }
  }

 private:
  const FrontView& view_;
  std::vector<std::uint32_t> first_, samples_;
};

/// A sample near another one in the picture.
struct Beside {
  Vector2d step;
  double height;

  bool operator<(const Beside& other) const {
    return std::tuple(height, step.x(), step.y()) < std::tuple(other.height, other.step.x(), other.step.y());
  }
};

/// What hides the surface beside a sample.
struct Occlusion {
  Vector2d way = Vector2d::Zero();  ///< unit, to what lies in front; zero: nothing does
  double room = 0;                  ///< height of what lies in front over the sample
};

/// Of a sample at that height, whose normal is (`across`, `along`) in the picture; itself is in `near`, too. Sorts `near`.
Occlusion occlusion(std::vector<Beside>& near, double height, const Vector2d& across, double along, double spacing) {
  std::sort(near.begin(), near.end());
  std::size_t own = 0;  // so many are of the sample's own surface
  for (double last = height; own < near.size(); ++own) {
    if (near[own].height < height) continue;
    if (near[own].height - last > kStep * spacing) break;
    last = near[own].height;
  }
  if (own == near.size()) return {};
  Vector2d behind = Vector2d::Zero(), before = Vector2d::Zero();
  double top = 0.0;
  for (std::size_t n = 0; n < near.size(); ++n) {
    (n < own ? behind : before) += near[n].step;
    if (n >= own) top += near[n].height;
  }
  behind /= static_cast<double>(own);
  before /= static_cast<double>(near.size() - own);
  top /= static_cast<double>(near.size() - own);
  if (across.dot(before) + along * (top - height) < kInFront * spacing) return {};  // the same surface, which is steep there
  const Vector2d apart = before - behind;
  if (!(apart.norm() > kApart * spacing)) return {};
  const Occlusion found{apart.normalized(), near[own].height - height};
  for (std::size_t n = 0; n < own; ++n) {
    const Vector2d& step = near[n].step;
    const double aside = found.way.x() * step.y() - found.way.y() * step.x();
    if (std::abs(aside) <= kAbreast * spacing && found.way.dot(step) > kEdge * spacing) return {};
  }
  return found;
}

}  // namespace

cloud::OrientedPoints behind_occlusions(const Scan& scan, const FrontView& view, double spacing, double opening) {
  const Cells cells(scan, view);
  const double reach = kBeside * spacing;
  const int rings = static_cast<int>(std::ceil(reach / view.cell()));
  std::vector<Occlusion> occlusions(scan.size());
  in_parallel(scan.size(), 256, [&](std::size_t begin, std::size_t end) {
    std::vector<Beside> near;
    for (const std::uint32_t i : scan.together(begin, end)) {
      const Vector3d& p = scan.positions()[i];
      const Vector2d at = view.flat(p);
      near.clear();
      cells.around(view.cell_of(p), rings, [&](std::uint32_t other) {
        const Vector3d& q = scan.positions()[other];
        const Vector2d step = view.flat(q) - at;
        if (step.squaredNorm() <= reach * reach) near.push_back({step, view.height(q)});
      });
      occlusions[i] = occlusion(near, view.height(p), view.flat(scan.normals()[i]), view.height(scan.normals()[i]), spacing);
    }
  });

  cloud::OrientedPoints floor;
  for (std::size_t i = 0; i < scan.size(); ++i) {
    const Occlusion& hidden = occlusions[i];
    if (hidden.way.isZero()) continue;
    const Vector3d& normal = scan.normals()[i];
    const double cosine = std::clamp(view.height(normal), kFlattest, 1.0);
    const Vector3d across = view.solid(hidden.way, 0.0);
    const Vector3d on = view.solid(hidden.way, -normal.dot(across) / cosine).normalized();  // along the surface
    double way = opening * std::sqrt(1.0 - cosine * cosine) / cosine;
    if (const double rise = view.height(on); rise > 0.0) way = std::min(way, kBelow * hidden.room / rise);
    for (double far = spacing; far <= way; far += spacing) {
      floor.positions.push_back(scan.positions()[i] + far * on);
      floor.normals.push_back(normal);
    }
  }
  return floor;
}

}  // namespace isotouch::field
