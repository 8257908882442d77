#include "host/cloud/check.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <nanoflann.hpp>
#include <numeric>
#include <utility>

#include "host/error.h"

namespace isotouch::cloud {
namespace {

using Eigen::Vector3d;

constexpr std::size_t kFewestPoints = 8;
constexpr double kFarthest = 1e12;
constexpr double kShortestNormal = 0.5;
constexpr double kLongestNormal = 2.0;
constexpr double kUnitTolerance = 0.01;
constexpr double kShortestMean = 0.5;
constexpr double kDoubtful = 0.3;

OrientedPoints with_unit_normals(const std::string& name, const Model& model, CloudReport& report) {
  OrientedPoints points{model.positions, {}};
  points.normals.reserve(model.normals.size());
  for (std::size_t i = 0; i < model.normals.size(); ++i) {
    if (model.positions[i].cwiseAbs().maxCoeff() > kFarthest) {
      throw InputError(name + ": " + model.place(i) + ": a coordinate is larger than 1e12; the file is damaged or its units are unusable");
    }
    const double length = model.normals[i].norm();
    if (length < 1e-6)
      throw InputError(name + ": " + model.place(i) + ": the normal is zero; estimate the normals again or remove the point");
    if (!(length >= kShortestNormal && length <= kLongestNormal)) {
      throw InputError(name + ": " + model.place(i) + ": the normal has length " + std::to_string(length) +
                       " instead of 1; normalise the normals");
    }
    if (std::abs(length - 1.0) > kUnitTolerance) ++report.renormalised;
    points.normals.emplace_back(model.normals[i] / length);
  }
  return points;
}

OrientedPoints merge_duplicates(const OrientedPoints& points, CloudReport& report) {
  const auto before = [&](std::size_t a, std::size_t b) {
    const Vector3d& p = points.positions[a];
    const Vector3d& q = points.positions[b];
    if (p.x() != q.x()) return p.x() < q.x();
    if (p.y() != q.y()) return p.y() < q.y();
    if (p.z() != q.z()) return p.z() < q.z();
    return a < b;
  };
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), before);

  std::vector<std::pair<std::size_t, Vector3d>> kept;  // the first point of each place, and its normal
  for (std::size_t begin = 0, end = 0; begin < order.size(); begin = end) {
    Vector3d sum = Vector3d::Zero();
    for (end = begin; end < order.size() && points.positions[order[end]] == points.positions[order[begin]]; ++end)
      sum += points.normals[order[end]];
    const std::size_t together = end - begin;
    if (together == 1) {
      kept.emplace_back(order[begin], points.normals[order[begin]]);
    } else if (sum.norm() < kShortestMean * static_cast<double>(together)) {
      report.contradictory += together;
    } else {
      report.merged += together - 1;
      kept.emplace_back(order[begin], sum.normalized());
    }
  }
  std::sort(kept.begin(), kept.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  OrientedPoints merged;
  for (const auto& [index, normal] : kept) {
    merged.positions.push_back(points.positions[index]);
    merged.normals.push_back(normal);
  }
  return merged;
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

/// The directions of the lattice points in [-2, 2]^3 that see the origin.
std::vector<Vector3d> directions() {
  std::vector<Vector3d> all;
  for (int x = -2; x <= 2; ++x) {
    for (int y = -2; y <= 2; ++y) {
      for (int z = -2; z <= 2; ++z) {
        if (std::gcd(std::gcd(x, y), z) == 1) all.push_back(Vector3d(x, y, z).normalized());
      }
    }
  }
  return all;
}

std::string times(std::size_t count, const char* one, const char* many) { return std::to_string(count) + ' ' + (count == 1 ? one : many); }

}  // namespace

double outwardness(const OrientedPoints& points) {
  double agreement = 0.0;
  double most = 0.0;
  for (const Vector3d& direction : directions()) {
    std::size_t outermost = 0;
    double farthest = points.positions[0].dot(direction);
    for (std::size_t i = 1; i < points.size(); ++i) {
      const double reach = points.positions[i].dot(direction);
      if (reach > farthest) {
        farthest = reach;
        outermost = i;
      }
    }
    const double answer =
        points.normals[outermost].dot(direction);  // near 1 or -1; near 0 at the rim of an open scan, which so counts little
    agreement += answer;
    most += std::abs(answer);
  }
  return most > 0.0 ? agreement / most : 0.0;
}

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

OrientedPoints check(const std::string& name, const Model& model, CloudReport& report) {
  report.format = model.format;
  report.points_read = model.positions.size();
  if (model.positions.empty()) throw InputError(name + ": there are no points in it");
  if (model.normals.empty()) {
    throw InputError(name + ": its " + std::to_string(model.positions.size()) +
                     " points have no normals; estimate outward normals in a point-cloud program and save them with the points");
  }
  OrientedPoints points = merge_duplicates(with_unit_normals(name, model, report), report);
  if (points.size() < kFewestPoints) {
    throw InputError(name + ": only " + times(points.size(), "usable point", "usable points") +
                     " at different places; a body needs 8 or more");
  }
  report.points = points.size();
  report.outward = outwardness(points);
  report.flipped = report.outward < 0.0;
  if (report.flipped) {
    for (Vector3d& normal : points.normals) normal = -normal;
  }
  report.median_spacing = median_spacing(points.positions);
  report.low = report.high = points.positions[0];
  for (const Vector3d& p : points.positions) {
    report.low = report.low.cwiseMin(p);
    report.high = report.high.cwiseMax(p);
  }
  return points;
}

std::vector<std::string> CloudReport::warnings() const {
  std::vector<std::string> list;
  if (renormalised > 0) list.push_back(times(renormalised, "normal was", "normals were") + " not of unit length and brought to it");
  if (merged > 0) list.push_back(times(merged, "point was", "points were") + " merged with others at the same place");
  if (contradictory > 0) {
    list.push_back(times(contradictory, "point was", "points were") + " left out: the normals at one place contradict each other");
  }
  if (flipped) list.push_back("the normals pointed inward and were all turned round");
  if (std::abs(outward) < kDoubtful) list.push_back("the normals do not agree where outside is; the field may be inside out");
  return list;
}

}  // namespace isotouch::cloud
