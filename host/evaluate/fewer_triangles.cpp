#include "host/evaluate/fewer_triangles.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "firmware/core/field_sampler.h"
#include "host/to_double.h"

namespace isotouch::evaluate {

namespace {

using Eigen::Vector3d;
using Face = std::array<std::uint32_t, 3>;

constexpr double kFirstSide =
    0.125;                     // voxels: the longest side in the first round, which clears what lies round a lattice point, slivers or not
constexpr double kGrowth = 2;  // of it from round to round
constexpr double kLongestSide = 8;
constexpr double kTurn = 0.75;        // cosine between a face's normal and the field's gradient
constexpr double kSliver = 0.1;       // twice the area over the longest side's square; a triangle of equal sides has 0.87
constexpr double kFewerShare = 0.02;  // a round that takes out fewer of the corners is the last one

class Thinner {
 public:
  Thinner(const FieldView& field, cloud::TriangleMesh mesh)
      : field_(field),
        origin_(to_double(field.origin)),
        edge_(to_double(field.edge)),
        mesh_(std::move(mesh)),
        star_(mesh_.vertices.size()),
        changed_(mesh_.vertices.size(), 0) {
    for (std::uint32_t f = 0; f < mesh_.faces.size(); ++f) {
      for (const std::uint32_t v : mesh_.faces[f]) star_[v].push_back(f);
    }
  }

  cloud::TriangleMesh run() {
    std::size_t left = mesh_.vertices.size();
    double asked = 0;  // the longest side of the round before
    for (double side = kFirstSide;; side = std::min(kLongestSide, side * kGrowth)) {
      ++round_;
      const std::size_t gone = round(side * edge_, asked * edge_);
      asked = side;
      left -= gone;
      if (side >= kLongestSide && static_cast<double>(gone) < kFewerShare * static_cast<double>(left)) return rest();
    }
  }

 private:
  struct Side {
    double squared;
    std::uint32_t a, b;
    bool operator<(const Side& o) const {
      if (squared != o.squared) return squared < o.squared;
      return a != o.a ? a < o.a : b < o.b;
    }
  };

  const Vector3d& at(std::uint32_t v) const { return mesh_.vertices[v]; }
  bool is_gone(const Face& face) const { return face[0] == face[1]; }

  /// Draws sides up to a length together; how many corners went. Sides that were asked in the round before are asked again where something changed.
  std::size_t round(double longest, double asked) {
    std::vector<Side> sides;
    for (const Face& face : mesh_.faces) {
      if (is_gone(face)) continue;
      for (std::size_t i = 0; i < 3; ++i) {
        const std::uint32_t a = face[i], b = face[(i + 1) % 3];
        const double squared = (at(a) - at(b)).squaredNorm();
        if (a > b || squared > longest * longest) continue;  // the face beyond runs it the other way
        if (squared > asked * asked || std::max(changed_[a], changed_[b]) + 1U >= round_) sides.push_back({squared, a, b});
      }
    }
    std::sort(sides.begin(), sides.end());
    std::size_t gone = 0;
    for (const Side& side : sides) {
      if (draw_together(side.a, side.b) || draw_together(side.b, side.a)) ++gone;
    }
    return gone;
  }

  /// Takes `goes` out, whose faces then end at `stays`; false, and nothing is changed, where that may not be.
  bool draw_together(std::uint32_t stays, std::uint32_t goes) {
    if (!is_free(stays, goes)) return false;
    for (const std::uint32_t f : star_[goes]) {
      const Face& before = mesh_.faces[f];
      if (std::find(before.begin(), before.end(), stays) == before.end() && !fits(before, replaced(before, goes, stays), stays))
        return false;
    }
    for (const std::uint32_t f : star_[goes]) {
      Face& face = mesh_.faces[f];
      for (const std::uint32_t v : face) changed_[v] = round_;
      if (std::find(face.begin(), face.end(), stays) == face.end()) {
        face = replaced(face, goes, stays);
        star_[stays].push_back(f);
        continue;
      }
      for (const std::uint32_t v : face) {
        if (v != goes) std::erase(star_[v], f);
      }
      face = {0, 0, 0};
    }
    star_[goes].clear();
    return true;
  }

  /// Are the two neighbours, and the only corners beside both of them those of their two common faces?
  bool is_free(std::uint32_t stays, std::uint32_t goes) {
    std::size_t common_faces = 0;
    beside(goes, beside_goes_);
    for (const std::uint32_t f : star_[goes]) {
      const Face& face = mesh_.faces[f];
      common_faces += std::find(face.begin(), face.end(), stays) != face.end() ? 1U : 0U;
    }
    if (common_faces != 2) return false;
    beside(stays, beside_stays_);
    std::size_t common = 0;
    for (auto a = beside_goes_.begin(), b = beside_stays_.begin(); a != beside_goes_.end() && b != beside_stays_.end();) {
      if (*a == *b) {
        if (star_[*a].size() <= 3) return false;  // two faces would be left of it, one on the other
        ++common;
      }
      *a <= *b ? ++a : ++b;
    }
    return common == 2;
  }

  void beside(std::uint32_t corner, std::vector<std::uint32_t>& found) const {
    found.clear();
    for (const std::uint32_t f : star_[corner]) {
      for (const std::uint32_t v : mesh_.faces[f]) {
        if (v != corner) found.push_back(v);
      }
    }
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
  }

  static Face replaced(Face face, std::uint32_t from, std::uint32_t to) {
    std::replace(face.begin(), face.end(), from, to);
    return face;
  }

  Vector3d across(const Face& face) const { return (at(face[1]) - at(face[0])).cross(at(face[2]) - at(face[0])); }

  /// How far a triangle is from a sliver: twice its area over its longest side's square.
  double shape(const Face& face) const {
    const auto& [a, b, c] = face;
    const double longest = std::max({(at(b) - at(a)).squaredNorm(), (at(c) - at(b)).squaredNorm(), (at(a) - at(c)).squaredNorm()});
    return longest > kLongestSide * kLongestSide * edge_ * edge_ ? 0 : across(face).norm() / longest;
  }

  /// May a face become another one that has one new corner?
  bool fits(const Face& before, const Face& after, std::uint32_t corner) const {
    const double is = shape(after);
    if (!(is > 0) || (round_ > 1 && is < kSliver && is < shape(before))) return false;
    const auto& [a, b, c] = after;
    const core::FieldSample middle = sample((at(a) + at(b) + at(c)) / 3);
    if (!is_near(middle)) return false;
    const Vector3d gradient = to_double(middle.gradient);
    const double turned = cosine(across(after), gradient);
    if (!(turned > 0) || (turned < kTurn && turned < cosine(across(before), gradient))) return false;
    // Of the new sides the one that leads on: the other is that of the face beyond it.
    const std::uint32_t next = corner == a ? b : corner == b ? c : a;
    return is_near(sample((at(corner) + at(next)) / 2));
  }

  static double cosine(const Vector3d& a, const Vector3d& b) { return a.dot(b) / std::sqrt(a.squaredNorm() * b.squaredNorm()); }

  core::FieldSample sample(const Vector3d& place) const {
    return core::sample_field(field_, to_fixed<Voxel>(Vector3d((place - origin_) / edge_)));
  }
  static bool is_near(const core::FieldSample& sample) { return std::abs(to_double(sample.distance)) <= kSurfaceTolerance; }

  /// What is left, with new numbers.
  cloud::TriangleMesh rest() const {
    std::vector<std::uint32_t> number(mesh_.vertices.size());
    cloud::TriangleMesh result;
    for (std::uint32_t v = 0; v < mesh_.vertices.size(); ++v) {
      number[v] = static_cast<std::uint32_t>(result.vertices.size());
      if (!star_[v].empty()) result.vertices.push_back(mesh_.vertices[v]);
    }
    for (const Face& face : mesh_.faces) {
      if (!is_gone(face)) result.faces.push_back({number[face[0]], number[face[1]], number[face[2]]});
    }
    return result;
  }

  const FieldView& field_;
  Vector3d origin_;
  double edge_;
  cloud::TriangleMesh mesh_;
  std::vector<std::vector<std::uint32_t>> star_;  // faces at each corner; none: it has gone
  std::vector<std::uint16_t> changed_;            // the last round in which a face at the corner changed
  std::uint16_t round_ = 0;
  std::vector<std::uint32_t> beside_goes_, beside_stays_;
};

}  // namespace

cloud::TriangleMesh fewer_triangles(const FieldView& field, cloud::TriangleMesh mesh) { return Thinner(field, std::move(mesh)).run(); }

}  // namespace isotouch::evaluate
