#include "host/cloud/check.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <nanoflann.hpp>
#include <numeric>
#include <tuple>
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
constexpr double kDoubtful = 0.3;
constexpr double kStiffest = 100.0;  // N/mm, what a field holds

/// Brings the normals to unit length in their places.
void make_unit_normals(const std::string& name, Model& model, CloudReport& report) {
  for (std::size_t i = 0; i < model.normals.size(); ++i) {
    if (model.positions[i].cwiseAbs().maxCoeff() > kFarthest) {
      throw InputError(name + ": " + model.place(i) + ": a coordinate is larger than 1e12; the file is damaged or its units are unusable");
    }
    const double length = model.normals[i].norm();
    if (length < 1e-6)
      throw InputError(name + ": " + model.place(i) + ": the normal is zero; estimate the normals again or remove the point");
    if (!(length >= kShortestNormal && length <= kMaxNormal)) {
      throw InputError(name + ": " + model.place(i) + ": the normal has length " + std::to_string(length) +
                       " instead of 1; normalise the normals");
    }
    if (!model.stiffness.empty() && !(model.stiffness[i] > 0.0 && model.stiffness[i] <= kStiffest)) {
      throw InputError(name + ": " + model.place(i) + ": the stiffness is " + std::to_string(model.stiffness[i]) +
                       " N/mm; it must be above 0 and at most 100");
    }
    if (std::abs(length - 1.0) > kUnitTolerance) ++report.renormalised;
    model.normals[i] /= length;
  }
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
  const std::vector<std::uint32_t> order = by_place(points.positions);
  std::vector<std::uint8_t> stays(points.size(), 1);
  const bool has_stiffness = !points.stiffness.empty();
  for (std::size_t begin = 0, end = 0; begin < order.size(); begin = end) {
    Vector3d sum = Vector3d::Zero();
    double stiffness = 0.0;
    for (end = begin; end < order.size() && points.positions[order[end]] == points.positions[order[begin]]; ++end) {
      sum += points.normals[order[end]];
      if (has_stiffness) stiffness += points.stiffness[order[end]];
    }
    const std::size_t together = end - begin;
    if (together == 1) continue;
    for (std::size_t i = begin; i < end; ++i) stays[order[i]] = 0;
    if (sum.norm() < kShortestMean * static_cast<double>(together)) {
      report.contradictory += together;
    } else {
      report.merged += together - 1;
      stays[order[begin]] = 1;  // the first point of each place, with the means
      points.normals[order[begin]] = sum.normalized();
      if (has_stiffness) points.stiffness[order[begin]] = stiffness / static_cast<double>(together);
    }
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

/// The directions of the lattice points in [-2, 2]^3 that see the origin, one of each two opposite ones.
std::vector<Vector3d> directions() {
  std::vector<Vector3d> all;
  for (int x = -2; x <= 2; ++x) {
    for (int y = -2; y <= 2; ++y) {
      for (int z = -2; z <= 2; ++z) {
        if (std::gcd(std::gcd(x, y), z) == 1 && std::tuple(x, y, z) > std::tuple(0, 0, 0)) all.push_back(Vector3d(x, y, z).normalized());
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
  // A normal's answer is near 1 or -1, and near 0 at the rim of an open scan, which so counts little.
  const auto ask = [&](double answer) {
    agreement += answer;
    most += std::abs(answer);
  };
  for (const Vector3d& direction : directions()) {
    std::size_t first = 0, last = 0;
    double least = points.positions[0].dot(direction);
    double greatest = least;
    for (std::size_t i = 1; i < points.size(); ++i) {
      const double reach = points.positions[i].dot(direction);
      if (reach > greatest) {
        greatest = reach;
        last = i;
      } else if (reach < least) {
        least = reach;
        first = i;
      }
    }
    ask(points.normals[last].dot(direction));
    ask(-points.normals[first].dot(direction));
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

OrientedPoints check(const std::string& name, Model model, CloudReport& report) {
  report.format = model.format;
  report.points_read = model.positions.size();
  if (model.positions.empty()) throw InputError(name + ": there are no points in it");
  if (model.normals.empty()) {
    throw InputError(name + ": its " + std::to_string(model.positions.size()) +
                     " points have no normals; estimate outward normals in a point-cloud program and save them with the points");
  }
  make_unit_normals(name, model, report);
  OrientedPoints points{std::move(model.positions), std::move(model.normals), std::move(model.stiffness)};
  merge_duplicates(points, report);
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
