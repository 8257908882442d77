#include "host/cloud/polygon.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "host/error.h"

namespace isotouch::cloud {

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using Triangle = std::array<std::uint32_t, 3>;

constexpr double kTurned = 1e-6;          // of the polygon's area: so little may a fan cover twice
constexpr double kFlat = 1e-12;           // of the polygon's area: a triangle of less has no side
constexpr std::size_t kTestsEach = 5000;  // of corners in triangles, for each corner of the polygon

double twice_area(const Vector2d& a, const Vector2d& b, const Vector2d& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

/// Twice the polygon's area, along its normal.
Vector3d area_vector(const std::vector<Vector3d>& positions, std::span<const Triangle> fan) {
  Vector3d sum = Vector3d::Zero();
  for (const auto& [a, b, c] : fan) sum += (positions[b] - positions[a]).cross(positions[c] - positions[a]);
  return sum;
}

/// A polygon in the plane, counter-clockwise, which gets smaller ear by ear.
class Shrinking {
 public:
  explicit Shrinking(std::vector<Vector2d> corners) : at_(std::move(corners)), before_(at_.size()), behind_(at_.size()), left_(at_.size()) {
    for (std::size_t i = 0; i < at_.size(); ++i) {
      behind_[i] = (i + 1) % at_.size();
      before_[behind_[i]] = i;
      area_ += twice_area(at_[0], at_[i], at_[(i + 1) % at_.size()]);
    }
    tests_ = kTestsEach * at_.size();
  }

  /// What a triangle may be whose corner is cut off.
  enum class Ear { kClear, kTouched, kEmpty };  // no other corner in it or on its rim; none in it; without area

  /// The corner that is an ear, the first from `from` on; the number of corners if there is none, or after too many tests.
  std::size_t ear(std::size_t from, Ear kind) {
    std::size_t corner = from;
    for (std::size_t n = 0; n < left_; ++n, corner = behind_[corner]) {
      if (is_ear(corner, kind)) return corner;
    }
    return at_.size();
  }
  bool is_tired() const { return tests_ == 0; }

  std::array<std::size_t, 3> triangle(std::size_t corner) const { return {before_[corner], corner, behind_[corner]}; }
  double area_at(std::size_t corner) const { return twice_area(at_[before_[corner]], at_[corner], at_[behind_[corner]]); }
  std::size_t left() const { return left_; }
  void cut(std::size_t corner) {
    behind_[before_[corner]] = behind_[corner];
    before_[behind_[corner]] = before_[corner];
    --left_;
  }

 private:
  bool is_ear(std::size_t corner, Ear kind) {
    const double area = area_at(corner), flat = kFlat * area_;
    if (kind == Ear::kEmpty ? std::abs(area) > flat : area <= flat) return false;
    const auto [a, b, c] = triangle(corner);
    for (std::size_t other = behind_[c]; other != a && kind != Ear::kEmpty; other = behind_[other]) {
      if (tests_ == 0) return false;
      --tests_;
      const Vector2d& p = at_[other];
      if (area_at(other) > 0 || p == at_[a] || p == at_[b] || p == at_[c]) continue;  // it is a corner inward that is met first
      const double least = std::min({twice_area(at_[a], at_[b], p), twice_area(at_[b], at_[c], p), twice_area(at_[c], at_[a], p)});
      if (kind == Ear::kClear ? least >= -flat : least > flat) return false;
    }
    return true;
  }

  std::vector<Vector2d> at_;
  std::vector<std::size_t> before_, behind_;
  std::size_t left_, tests_ = 0;
  double area_ = 0;
};

/// Does the fan cover its polygon already, or has this no area?
bool is_covered(const std::vector<Vector3d>& positions, std::span<const Triangle> fan, const Vector3d& normal) {
  double extent = 0;  // squared
  for (const Triangle& face : fan) extent = std::max(extent, (positions[face[1]] - positions[face[0]]).squaredNorm());
  const double least = -kTurned * normal.squaredNorm();
  return normal.norm() <= kFlat * extent || std::all_of(fan.begin(), fan.end(), [&](const Triangle& face) {
           return area_vector(positions, {&face, 1}).dot(normal) >= least;
         });
}

/// Returns what is wrong with a polygon, or nullptr.
const char* cut_polygon(const std::vector<Vector3d>& positions, std::span<Triangle> fan) {
  const Vector3d normal = area_vector(positions, fan);
  if (is_covered(positions, fan, normal)) return nullptr;
  std::vector<std::uint32_t> corners = {fan[0][0], fan[0][1]};
  for (const Triangle& face : fan) corners.push_back(face[2]);
  Eigen::Index axis = 0;
  normal.cwiseAbs().maxCoeff(&axis);
  const Vector3d along = normal / normal.norm();  // seen along it, the polygon is largest, and no warp moves a corner aside
  const Vector3d x = (Vector3d::Unit((axis + 1) % 3) - along[(axis + 1) % 3] * along).normalized(), y = along.cross(x);
  std::vector<Vector2d> seen;
  for (const std::uint32_t corner : corners) {
    const Vector3d from = positions[corner] - positions[corners[0]];
    seen.emplace_back(x.dot(from), y.dot(from));
  }

  Shrinking polygon(std::move(seen));
  std::vector<Triangle> cut;
  std::size_t from = 0;
  while (cut.size() < fan.size()) {
    std::size_t ear = corners.size();
    for (const auto kind : {Shrinking::Ear::kClear, Shrinking::Ear::kTouched, Shrinking::Ear::kEmpty}) {
      if (ear == corners.size()) ear = polygon.ear(from, kind);
    }
    if (polygon.is_tired()) return "is not convex and takes too long to be cut into triangles";
    if (ear == corners.size()) return "crosses itself or cannot be cut into triangles";
    const auto [a, b, c] = polygon.triangle(ear);
    cut.push_back({corners[a], corners[b], corners[c]});
    polygon.cut(ear);
    from = c;
  }
  std::copy(cut.begin(), cut.end(), fan.begin());
  return nullptr;
}

}  // namespace

void add_polygon(Model& model, std::span<const std::uint32_t> corners, std::size_t line, std::size_t number) {
  if (corners.size() > 3) model.polygons.push_back({model.faces.size(), corners.size() - 2, line, number});
  for (std::size_t i = 2; i < corners.size(); ++i) model.faces.push_back({corners[0], corners[i - 1], corners[i]});
}

void cut_polygons(Model& model, const std::string& name) {
  for (const Model::Polygon& polygon : model.polygons) {
    const char* wrong = cut_polygon(model.positions, std::span(model.faces).subspan(polygon.first, polygon.count));
    if (wrong == nullptr) continue;
    const std::string place = polygon.line > 0 ? "line " + std::to_string(polygon.line) : "face " + std::to_string(polygon.number);
    throw InputError(name + ": " + place + ": a polygon of " + std::to_string(polygon.count + 2) + " corners " + wrong +
                     "; triangulate the faces in a mesh program");
  }
}

}  // namespace isotouch::cloud
