#include "host/cloud/check.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <nanoflann.hpp>
#include <utility>

#include "host/error.h"

namespace isotouch::cloud {
namespace {

using Eigen::Vector3d;

constexpr std::size_t kFewestPoints = 8;
constexpr double kFarthest = 1e12;
constexpr double kShortestNormal = 0.5;
constexpr double kMaxNormal = 2.0;
constexpr double kUnitTolerance = 0.01;
constexpr double kShortestMean = 0.5;
constexpr std::size_t kOneIn = 10;  // places that contradict themselves are no mistake any more
constexpr double kOnePlace =
    1e-6;  // of the size of the object: in a dense real scan of 120,000 points the nearest two are 105 times as far apart
constexpr double kStiffest = 100.0;  // N/mm, what a field holds

/// Brings the normals to unit length in their places.
void make_unit_normals(const std::string& name, Model& model, CloudReport& report) {
  for (std::size_t i = 0; i < model.normals.size(); ++i) {
    if (model.positions[i].cwiseAbs().maxCoeff() > kFarthest) {
      throw InputError(name + ": " + model.place(i) + ": a coordinate is larger than 1e12; the file is damaged or its units are unusable");
    }
    const double length = model.normals[i].norm();
    if (report.has_normals && length < 1e-6) {
      throw InputError(name + ": " + model.place(i) + ": the normal is zero; choose --normals estimate or remove the point");
    }
    if (report.has_normals && !(length >= kShortestNormal && length <= kMaxNormal)) {
      throw InputError(name + ": " + model.place(i) + ": the normal has length " + std::to_string(length) +
                       " instead of 1; normalise the normals");
    }
    if (!model.stiffness.empty() && !(model.stiffness[i] > 0.0 && model.stiffness[i] <= kStiffest)) {
      throw InputError(name + ": " + model.place(i) + ": the stiffness is " + std::to_string(model.stiffness[i]) +
                       " N/mm; it must be above 0 and at most 100");
    }
    if (!report.has_normals) continue;
    if (std::abs(length - 1.0) > kUnitTolerance) ++report.renormalised;
    model.normals[i] /= length;
  }
}

/// The edge of a cell whose points count as one: less than a scanner resolves, and more than rounding moves a point, as when one scan was saved in two
/// frames. Points that a border of cells parts stay two. The middle half of the points says how large the object is, whatever strays there are.
double one_place(const std::vector<Vector3d>& positions) {
  double longest = 0.0;
  std::vector<double> along(positions.size());
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    std::transform(positions.begin(), positions.end(), along.begin(), [axis](const Vector3d& p) { return p[axis]; });
    const auto quantile = [&](std::size_t fourths) {
      const auto at = along.begin() + static_cast<std::ptrdiff_t>(fourths * (along.size() - 1) / 4);
      std::nth_element(along.begin(), at, along.end());
      return *at;
    };
    longest = std::max(longest, quantile(3) - quantile(1));
  }
  return kOnePlace * longest;
}

/// The cells, as large as one place, that the points lie in; the points themselves where all are at one.
std::vector<Vector3d> places_of(const std::vector<Vector3d>& positions) {
  std::vector<Vector3d> places = positions;
  const double size = one_place(positions);
  if (!(size > 0.0)) return places;
  for (Vector3d& p : places) p = (p / size).array().floor();
  return places;
}

/// Points in an order that brings those at one place together, in their order.
std::vector<std::uint32_t> by_place(const std::vector<Vector3d>& positions) {
  struct Along {
    double x;
    std::uint32_t point;
  };
  std::vector<Along> sorted(positions.size());
  for (std::uint32_t i = 0; i < sorted.size(); ++i) sorted[i] = {positions[i].x(), i};
  std::sort(sorted.begin(), sorted.end(), [&](const Along& a, const Along& b) {
    if (a.x != b.x) return a.x < b.x;
    const Vector3d& p = positions[a.point];
    const Vector3d& q = positions[b.point];
    if (p.y() != q.y()) return p.y() < q.y();
    if (p.z() != q.z()) return p.z() < q.z();
    return a.point < b.point;
  });
  std::vector<std::uint32_t> order(sorted.size());
  std::transform(sorted.begin(), sorted.end(), order.begin(), [](const Along& along) { return along.point; });
  return order;
}

void merge_duplicates(OrientedPoints& points, CloudReport& report) {
  const std::vector<Vector3d> places = places_of(points.positions);
  const std::vector<std::uint32_t> order = by_place(places);
  std::vector<std::uint8_t> stays(points.size(), 1);
  std::vector<std::uint32_t> contradictory;  // the first point of each place
  const bool has_stiffness = !points.stiffness.empty();
  for (std::size_t begin = 0, end = 0; begin < order.size(); begin = end) {
    Vector3d sum = Vector3d::Zero();
    double stiffness = 0.0;
    for (end = begin; end < order.size() && places[order[end]] == places[order[begin]]; ++end) {
      sum += points.normals[order[end]];
      if (has_stiffness) stiffness += points.stiffness[order[end]];
    }
    const std::size_t together = end - begin;
    if (together == 1) continue;
    for (std::size_t i = begin; i < end; ++i) stays[order[i]] = 0;
    if (report.has_normals && sum.norm() < kShortestMean * static_cast<double>(together)) {
      report.contradictory += together;
      contradictory.push_back(order[begin]);
    } else {
      report.merged += together - 1;
      stays[order[begin]] = 1;  // the first point of each place, with the means
      if (report.has_normals) points.normals[order[begin]] = sum.normalized();
      if (has_stiffness) points.stiffness[order[begin]] = stiffness / static_cast<double>(together);
    }
  }
  const auto left = static_cast<std::size_t>(std::count(stays.begin(), stays.end(), 1));
  report.two_faced = kOneIn * contradictory.size() > left + contradictory.size();
  if (report.two_faced) {  // not a few mistakes: the points were saved twice, once for each side
    for (const std::uint32_t i : contradictory) stays[i] = 1;
  }
  std::size_t kept = 0;
  for (std::size_t i = 0; i < stays.size(); ++i) {
    if (stays[i] == 0) continue;
    points.positions[kept] = points.positions[i];
    if (has_stiffness) points.stiffness[kept] = points.stiffness[i];
    points.normals[kept++] = points.normals[i];
  }
  points.positions.resize(kept);
  points.normals.resize(kept);
  if (has_stiffness) points.stiffness.resize(kept);
}

/// What nanoflann wants to know about the points.
struct PointsView {
  const std::vector<Vector3d>& positions;

  std::size_t kdtree_get_point_count() const { return positions.size(); }
  double kdtree_get_pt(std::size_t index, std::size_t axis) const { return positions[index][static_cast<Eigen::Index>(axis)]; }
  template <class Box>
  bool kdtree_get_bbox(Box&) const {
    return false;
  }
};

std::string times(std::size_t count, const char* one, const char* many) { return std::to_string(count) + ' ' + (count == 1 ? one : many); }

}  // namespace

double median_spacing(const std::vector<Vector3d>& positions) {
  using Tree = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, PointsView>, PointsView, 3, std::size_t>;
  const PointsView view{positions};
  const Tree tree(3, view, nanoflann::KDTreeSingleIndexAdaptorParams(10));
  std::vector<double> squared;
  const std::size_t step = std::max<std::size_t>(1, positions.size() / 4096);
  for (std::size_t i = 0; i < positions.size(); i += step) {
    const Vector3d& p = positions[i];
    std::array<std::size_t, 2> indices{};
    std::array<double, 2> distances{};
    tree.knnSearch(p.data(), 2, indices.data(), distances.data());
    squared.push_back(distances[1]);  // the nearest is the point itself: no two share a place any more
  }
  const auto middle = squared.begin() + static_cast<std::ptrdiff_t>(squared.size() / 2);
  std::nth_element(squared.begin(), middle, squared.end());
  return std::sqrt(*middle);
}

OrientedPoints check(const std::string& name, Model model, CloudReport& report) {
  report.format = model.format;
  report.points_read = model.positions.size();
  report.edges = model.edges;
  report.viewpoint = model.viewpoint;
  report.incomplete = model.incomplete;
  if (model.positions.empty()) throw InputError(name + ": there are no points in it");
  report.has_normals = !model.normals.empty();
  if (!report.has_normals) model.normals.assign(model.positions.size(), Vector3d::Zero());
  make_unit_normals(name, model, report);
  OrientedPoints points{std::move(model.positions), std::move(model.normals), std::move(model.stiffness)};
  merge_duplicates(points, report);
  if (points.size() < kFewestPoints) {
    throw InputError(name + ": only " + times(points.size(), "usable point", "usable points") +
                     " at different places; a body needs 8 or more");
  }
  report.points = points.size();
  report.low = report.high = points.positions[0];
  for (const Vector3d& p : points.positions) {
    report.low = report.low.cwiseMin(p);
    report.high = report.high.cwiseMax(p);
  }
  return points;
}

std::vector<std::string> CloudReport::warnings() const {
  std::vector<std::string> list;
  if (incomplete > 0)
    list.push_back(times(incomplete, "point was", "points were") + " left out: a coordinate or the normal is not a finite number");
  if (edges) {
    list.emplace_back("the normals were taken from the scan's grid and face its sensor");
    if (*edges > 0) list.push_back(times(*edges, "point was", "points were") + " left out: at edges of the grid and at jumps in depth");
  }
  if (renormalised > 0) list.push_back(times(renormalised, "normal was", "normals were") + " not of unit length and brought to it");
  if (merged > 0) list.push_back(times(merged, "point was", "points were") + " merged with others at the same place");
  if (two_faced) {
    list.push_back(times(contradictory, "point was", "points were") + " there with opposite normals; one was kept for each place");
  } else if (contradictory > 0) {
    list.push_back(times(contradictory, "point was", "points were") + " left out: the normals at one place contradict each other");
  }
  return list;
}

}  // namespace isotouch::cloud
