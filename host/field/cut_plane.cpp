#include "host/field/cut_plane.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <numbers>
#include <vector>

#include "host/field/parallel.h"

namespace isotouch::field {

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kPlane = 0.003;     // of a rim's length: a hand cut at the wrist has 0.0007, holes of other kinds 0.005 and more
constexpr double kOfSpacing = 0.35;  // the last samples before a cut are evenly 0 to 1 spacing away, 0.29 rms
constexpr double kMostOfRim = 0.9;
constexpr double kNear = 3.0;   // rms distances: that near to the plane a sample is on it
constexpr double kClear = 0.5;  // of the distance to the sixth neighbour: that far from the plane a sample is on one side
constexpr double kBehindCut = 0.002;
constexpr double kOutermost = 0.95;  // of the rim's samples: the plane is that far out
constexpr double kApart = 0.75;      // of the distance to the sixth neighbour
constexpr double kFromRim = 0.5;     // spacings of the cap

/// A place of a rim in the plane.
struct Edge {
  Vector2d place, outward;  // unit
  double length, stiffness;
};

/// How often the rims go round a place of the plane: 1 within, 0 without.
double turns(const std::vector<Edge>& edges, const Vector2d& place) {
  double sum = 0.0;
  for (const Edge& edge : edges) {
    const Vector2d step = edge.place - place;
    sum += edge.length * edge.outward.dot(step) / std::max(step.squaredNorm(), 0.25 * edge.length * edge.length);
  }
  return sum / (2.0 * std::numbers::pi);
}

}  // namespace

std::optional<CutPlane> cut_plane(const Scan& scan, const OpenRim& rim) {
  if (rim.samples == 0) return std::nullopt;
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  double longest = 0.0;
  for (const RimPlace& place : rim.along) {
    if (!place.on_longest) continue;
    const Vector3d off = scan.positions()[place.sample] - rim.place;
    spread += off * off.transpose();
    longest += 1.0;
  }
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(spread / longest);
  CutPlane plane{.place = rim.place, .axis = solver.eigenvectors().col(0)};
  const double bent = std::sqrt(std::max(0.0, solver.eigenvalues()[0]));
  plane.is_clean = bent < kPlane * rim.longest;
  if (!plane.is_clean && bent > kOfSpacing * scan.median_spacing()) return std::nullopt;

  const auto height = [&](const Vector3d& place) { return plane.axis.dot(place - plane.place); };
  const double clear = std::max(2.0 * bent, kClear * scan.median_spacing());
  std::size_t above = 0, below = 0;
  for (const Vector3d& p : scan.positions()) {
    above += height(p) > clear ? 1U : 0U;
    below += height(p) < -clear ? 1U : 0U;
  }
  if (static_cast<double>(std::min(above, below)) > kBehindCut * static_cast<double>(scan.size())) return std::nullopt;
  if (above > below) plane.axis = -plane.axis;

  double length = 0.0, within = 0.0, along_axis = 0.0;
  std::vector<double> heights;
  std::map<std::uint32_t, int> balance;  // of each rim: how many more of its samples lie on the plane than off it
  for (const RimPlace& place : rim.along) {
    const double off = height(scan.positions()[place.sample]);
    length += place.length;
    --balance[place.rim];
    if (std::abs(off) > std::max(kNear * bent, scan.median_spacing())) continue;
    balance[place.rim] += 2;
    within += place.length;
    along_axis += place.length * scan.normals()[place.sample].dot(plane.axis);
    heights.push_back(off);
  }
  std::uint32_t least = 0;
  for (const RimPlace& place : rim.along) {
    if (balance[place.rim] > 0) {
      plane.on_plane.push_back(place);
    } else if (place.surrounded < plane.least_surrounded) {
      plane.least_surrounded = place.surrounded;
      least = place.rim;
    }
  }
  std::size_t on_least = 0;
  for (const RimPlace& place : rim.along) {
    if (plane.least_surrounded < 1 && place.rim == least)
      plane.least_place += (scan.positions()[place.sample] - plane.least_place) / static_cast<double>(++on_least);
  }
  plane.is_only_end = within >= kMostOfRim * length;
  plane.along_axis = along_axis / within;
  const auto outermost = heights.begin() + static_cast<std::ptrdiff_t>(kOutermost * static_cast<double>(heights.size() - 1));
  std::nth_element(heights.begin(), outermost, heights.end());
  plane.place += *outermost * plane.axis;
  return plane;
}

cloud::OrientedPoints plane_cap(const Scan& scan, const CutPlane& plane) {
  int least = 0;
  plane.axis.cwiseAbs().minCoeff(&least);
  const Vector3d u = plane.axis.cross(Vector3d::Unit(least)).normalized();
  const Vector3d v = plane.axis.cross(u);
  const auto flat = [&](const Vector3d& step) { return Vector2d(step.dot(u), step.dot(v)); };
  std::vector<Edge> edges;
  Eigen::AlignedBox2d box;
  for (const RimPlace& place : plane.on_plane) {
    const Vector2d outward = flat(scan.normals()[place.sample]);
    if (!(outward.norm() > 0.0)) continue;
    edges.push_back({flat(scan.positions()[place.sample] - plane.place), outward.normalized(), place.length,
                     scan.stiffness().empty() ? 0.0 : scan.stiffness()[place.sample]});
    box.extend(edges.back().place);
  }
  if (edges.empty()) return {};
  // Rows of a lattice of equal triangles; no more points than the scan has.
  const double step = std::max(kApart * scan.median_spacing(), std::sqrt(box.volume() / static_cast<double>(scan.size())));
  const double rise = step * std::sqrt(0.75);
  const auto rows = static_cast<std::size_t>(box.sizes().y() / rise) + 1;
  std::vector<cloud::OrientedPoints> parts(rows);
  in_parallel(rows, 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t row = begin; row < end; ++row) {
      for (double x = row % 2 == 0 ? 0.0 : 0.5 * step; x <= box.sizes().x(); x += step) {
        const Vector2d place = box.min() + Vector2d(x, static_cast<double>(row) * rise);
        const auto nearest = std::min_element(edges.begin(), edges.end(), [&](const Edge& a, const Edge& b) {
          return (a.place - place).squaredNorm() < (b.place - place).squaredNorm();
        });
        if ((nearest->place - place).norm() < kFromRim * step || turns(edges, place) < 0.5) continue;
        parts[row].positions.push_back(plane.place + place.x() * u + place.y() * v);
        parts[row].normals.push_back(plane.axis);
        if (!scan.stiffness().empty()) parts[row].stiffness.push_back(nearest->stiffness);
      }
    }
  });
  cloud::OrientedPoints cap;
  for (const cloud::OrientedPoints& part : parts) cap.append(part);
  return cap;
}

}  // namespace isotouch::field
