#include "host/cloud/check.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <nanoflann.hpp>
#include <utility>

#include "host/cloud/same_place.h"
#include "host/error.h"

namespace isotouch::cloud {
namespace {

using Eigen::Vector3d;

constexpr std::size_t kFewestPoints = 8;
constexpr double kFarthest = 1e12;
constexpr double kZeroNormal = 1e-6;
constexpr double kShortestNormal = 0.5;
constexpr double kMaxNormal = 2.0;
constexpr double kUnitTolerance = 0.01;
constexpr double kShortestMean = 0.5;
constexpr std::size_t kOneIn = 10;   // places that contradict themselves are no mistake any more
constexpr double kStiffest = 100.0;  // N/mm, what a field holds

/// Do nearly all normals have length 1 when they are decoded, and most of them not before?
///
/// one     what stands for a component of 1; that of 0 is half of it
bool are_coded(const std::vector<Vector3d>& normals, double one) {
  constexpr double kOff = 0.05;  // of a length: more than 8 bits leave
  std::size_t decoded = 0, as_they_are = 0;
  for (const Vector3d& n : normals) {
    if (n.minCoeff() < 0.0) return false;
    decoded += std::abs((2.0 / one * n - Vector3d::Ones()).norm() - 1.0) < kOff ? 1U : 0U;
    as_they_are += std::abs(n.norm() - 1.0) < kOff ? 1U : 0U;
  }
  return 10 * decoded > 9 * normals.size() && 2 * as_they_are < normals.size();
}

/// otherwise  what else to do than to decode them; may be empty
void refuse_coded(const std::string& name, const Model& model, const char* otherwise) {
  for (const auto& [one, how] : {std::pair(1.0, "(n + 1) / 2"), {255.0, "(n + 1) / 2 from 0 to 255"}}) {
    if (are_coded(model.normals, one))
      throw InputError(name + ": the normals are never negative, but coded as " + how + "; decode them" + otherwise);
  }
}

/// Leaves out the points whose normal is zero, as long as they are few.
void drop_zero_normals(const std::string& name, Model& model) {
  const auto is_oriented = [&](std::size_t i) { return model.normals[i].norm() >= kZeroNormal; };
  std::size_t zero = 0, first = 0;
  for (std::size_t i = model.normals.size(); i-- > 0;) {
    if (is_oriented(i)) continue;
    ++zero;
    first = i;
  }
  if (zero == 0) return;
  if (zero == model.normals.size()) throw InputError(name + ": all normals are zero or not finite numbers; choose --normals estimate");
  if (kOneIn * zero > model.normals.size()) {  // a whole part of a body may be gone with so many
    throw InputError(name + ": " + model.place(first) + ": the normal is zero or not a finite number, as at " + std::to_string(zero) +
                     " of " + std::to_string(model.normals.size()) + " points; remove these points, or choose --normals estimate");
  }
  model.incomplete += keep_points(model, is_oriented);
}

bool is_nearly_unit(double length) { return length >= kShortestNormal && length <= kMaxNormal; }

/// first   the first point whose normal is far from unit length
InputError not_unit(const std::string& name, const Model& model, std::size_t first) {
  const auto off = std::count_if(model.normals.begin(), model.normals.end(),
                                 [](const Vector3d& n) { return n.norm() >= kZeroNormal && !is_nearly_unit(n.norm()); });
  return InputError(name + ": " + model.place(first) + ": the normal has length " + std::to_string(model.normals[first].norm()) +
                    " instead of 1, and " + std::to_string(off) + " of " + std::to_string(model.normals.size()) +
                    " normals are that far off; normalise them, " +
                    (model.format == "text" ? "choose --normals estimate, or remove columns 4 to 6 if they hold something else"
                                            : "or choose --normals estimate"));
}

/// Brings the normals but for zeros to unit length in their places.
void make_unit_normals(const std::string& name, Model& model, CloudReport& report) {
  for (std::size_t i = 0; i < model.normals.size(); ++i) {
    if (model.positions[i].cwiseAbs().maxCoeff() > kFarthest) {
      throw InputError(name + ": " + model.place(i) + ": a coordinate is larger than 1e12; the file is damaged or its units are unusable");
    }
    const double length = model.normals[i].norm();
    const bool has_normal = report.has_normals && length >= kZeroNormal;
    if (has_normal && !is_nearly_unit(length)) throw not_unit(name, model, i);
    if (!model.stiffness.empty() && !(model.stiffness[i] > 0.0 && model.stiffness[i] <= kStiffest)) {
      throw InputError(name + ": " + model.place(i) + ": the stiffness is " + std::to_string(model.stiffness[i]) +
                       " N/mm; it must be above 0 and at most 100");
    }
    if (!has_normal) continue;
    if (std::abs(length - 1.0) > kUnitTolerance) ++report.renormalised;
    model.normals[i] /= length;
  }
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

using Tree = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, PointsView>, PointsView, 3, std::size_t>;
constexpr std::size_t kOfLeaf = 10;

/// Of some points, spread over the list: the median of the distances to the nth nearest of the others.
///
/// tree      of the positions, more than n, no two at one place
/// asked     points, about
double median_distance(const Tree& tree, const std::vector<Vector3d>& positions, std::size_t nth, std::size_t asked) {
  std::vector<double> squared;
  std::vector<std::size_t> indices(nth + 1);
  std::vector<double> distances(nth + 1);  // the first is the point itself
  const std::size_t step = std::max<std::size_t>(1, positions.size() / asked);
  for (std::size_t i = 0; i < positions.size(); i += step) {
    tree.knnSearch(positions[i].data(), nth + 1, indices.data(), distances.data());
    squared.push_back(distances[nth]);
  }
  const auto middle = squared.begin() + static_cast<std::ptrdiff_t>(squared.size() / 2);
  std::nth_element(squared.begin(), middle, squared.end());
  return std::sqrt(*middle);
}

/// A scan that was saved several times, and moved a little each time, lies in clumps: the nearest neighbour of most points is many times nearer than the
/// next places are.
///
/// returns   the largest distance of two points of a clump; 0: there are none
double clump_size(const std::vector<Vector3d>& positions) {
  constexpr std::size_t kFar = 16, kAsked = 512;
  constexpr double kClumped = 0.06;  // random points have 0.21, lines of points 0.125, points on a grid 0.4
  constexpr double kOfFar = 0.2;     // of a scan that was saved five times, the sixteenth neighbour is one place away
  if (positions.size() <= kFar) return 0.0;
  const PointsView view{positions};
  const Tree tree(3, view, {kOfLeaf});
  const double far = median_distance(tree, positions, kFar, kAsked);
  return median_distance(tree, positions, 1, kAsked) < kClumped * far ? kOfFar * far : 0.0;
}

/// first     of each point, the first one at its place
void merge_places(OrientedPoints& points, const std::vector<std::uint32_t>& first, CloudReport& report) {
  struct Place {
    Vector3d normals = Vector3d::Zero();  ///< their sum
    double stiffness = 0;                 ///< also
    std::size_t points = 0;
  };
  std::vector<Place> places(points.size());  // each where its first point is
  const bool has_stiffness = !points.stiffness.empty();
  for (std::size_t i = 0; i < points.size(); ++i) {
    Place& place = places[first[i]];
    place.normals += points.normals[i];
    if (has_stiffness) place.stiffness += points.stiffness[i];
    ++place.points;
  }
  std::vector<std::uint8_t> stays(points.size(), 0);
  std::vector<std::size_t> contradictory;  // the first point of each place
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Place& place = places[i];
    const auto together = static_cast<double>(place.points);
    if (place.points == 0) continue;
    if (place.points > 1 && report.has_normals && place.normals.norm() < kShortestMean * together) {
      report.contradictory += place.points;
      contradictory.push_back(i);
      continue;
    }
    stays[i] = 1;
    if (place.points == 1) continue;
    report.merged += place.points - 1;
    if (report.has_normals) points.normals[i] = place.normals.normalized();  // the first point of each place gets the means
    if (has_stiffness) points.stiffness[i] = place.stiffness / together;
  }
  const auto left = static_cast<std::size_t>(std::count(stays.begin(), stays.end(), 1));
  report.two_faced = kOneIn * contradictory.size() > left + contradictory.size();
  if (report.two_faced) {  // not a few mistakes: the points were saved twice, once for each side
    for (const std::size_t i : contradictory) stays[i] = 1;
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

void merge_duplicates(OrientedPoints& points, CloudReport& report) {
  merge_places(points, first_at_place(points.positions), report);
  const double size = clump_size(points.positions);
  if (size == 0.0) return;
  OrientedPoints merged = points;
  CloudReport told = report;
  merge_places(merged, first_at_place(merged.positions, size), told);
  if (told.two_faced) return;  // the clumps are the two sides of a wall
  told.two_faced = report.two_faced;
  points = std::move(merged);
  report = std::move(told);
}

std::string times(std::size_t count, const char* one, const char* many) { return std::to_string(count) + ' ' + (count == 1 ? one : many); }

}  // namespace

double median_spacing(const std::vector<Vector3d>& positions) {
  const PointsView view{positions};
  return median_distance(Tree(3, view, {kOfLeaf}), positions, 1, 4096);
}

void check_frame(const std::string& name, Model& model) {
  refuse_coded(name, model, "");
  for (Vector3d& normal : model.normals) {
    if (!is_nearly_unit(normal.norm())) normal.setZero();
  }
}

OrientedPoints check(const std::string& name, Model model, CloudReport& report) {
  report.format = model.format;
  report.points_read = model.positions.size();
  report.edges = model.edges;
  report.sensor = model.sensor;
  report.unused_faces = model.unused_faces;
  if (model.positions.empty()) throw InputError(name + ": there are no points in it");
  report.has_normals = !model.normals.empty();
  if (report.has_normals) refuse_coded(name, model, ", or choose --normals estimate");
  if (!report.has_normals) model.normals.assign(model.positions.size(), Vector3d::Zero());
  make_unit_normals(name, model, report);
  if (report.has_normals) drop_zero_normals(name, model);  // behind what names points by their numbers
  report.incomplete = model.incomplete;
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

std::string in_brackets(const Vector3d& place) {
  std::array<char, 96> text{};
  std::snprintf(text.data(), text.size(), "(%.6g, %.6g, %.6g)", place.x(), place.y(), place.z());
  return text.data();
}

std::string CloudReport::sensor_doubt() const {
  if (edges) return {};
  if (sensor.refuted_place) {
    return "the image was not seen from the file's own place of the sensor, " + in_brackets(*sensor.refuted_place) +
           ", and its grid was not used; if it was, give this place with --viewpoint";
  }
  if (!sensor.is_elsewhere || sensor.place) return {};
  return "the image does not look as if its sensor had stood in the origin, and its grid was not used; if it did, give --viewpoint 0 0 0";
}

std::vector<std::string> CloudReport::warnings(bool are_normals_used) const {
  std::vector<std::string> list;
  if (sensor.looks_past) {
    list.emplace_back(
        "the principal point CX,CY lies outside the image: check that --intrinsics is FX,FY,CX,CY, unless the image is a part of a larger "
        "one");
  }
  if (!edges && sensor.refuted_place) list.push_back(sensor_doubt());
  if (unused_faces > 0) list.push_back("its " + times(unused_faces, "face was", "faces were") + " not used; --as mesh takes them");
  if (incomplete > 0)
    list.push_back(times(incomplete, "point was", "points were") +
                   " left out: the normal is zero, or it or a coordinate is not a finite number");
  if (edges) {
    if (are_normals_used) list.emplace_back("the normals were taken from the scan's grid and face its sensor");
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
