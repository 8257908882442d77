#include "host/field/hole_samples.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "host/field/fair_skin.h"
#include "host/field/quadric_fit.h"

namespace isotouch::field {

namespace {

using Eigen::Vector3d;

// Lengths are in spacings of the samples round the hole, by trial of 2026-11 on three scans of a bunny.
constexpr double kLopsided = 0.15;  // of the neighbours' reach: how far their middle lies beside a sample at a rim; on a straight rim 0.4
constexpr double kStep = 0.7;       // between samples of a skin
constexpr double kApart = 0.5;      // at least, from every other sample
constexpr double kSearch = 1.2;     // how far a skin bends from one sample to the next
constexpr int kSearchSteps = 4;     // a side
constexpr int kHalvings = 10;
constexpr double kDisagree = 0.25;       // of the way to the nearest sample: the models see the surface farther behind the skin than that
constexpr double kBeside = 1.0;          // so near to the rim, where its curvature alone leads to no such error
constexpr std::size_t kDisagreeing = 8;  // one in so many samples of a skin beside its rim
constexpr std::size_t kDrawing = 8;      // neighbours of a sample that draw it into their plane
constexpr int kPasses = 30;
constexpr double kHole = 1.0;             // a hole is that far from its rim at one place: over less the models bridge
constexpr std::size_t kMaxSamples = 200;  // a larger hole is left to the models
constexpr double kWide = 2.0;             // and one that is that far from its rim at one place is wide
constexpr double kLooks = 0.2;            // length of the mean normal of its rim: round the end of a tube it is nearly 0, in a face 1
constexpr std::size_t kMaxWide = 1000;    // samples over a wide hole
constexpr double kWithin = 1.0;           // of the points' unit, in a build voxels: the closing box is at least that far beyond a skin
constexpr std::size_t kMaxTaken = 5000;   // of all holes together: more is a scan full of holes, which nothing mends

/// The samples of a skin that lie beside its rim, and what the scan says there.
struct Rim {
  std::size_t samples = 0, disagreeing = 0;
  Vector3d normals = Vector3d::Zero();  ///< their sum

  bool disagrees() const { return kDisagreeing * disagreeing >= samples; }
  bool looks_one_way() const { return normals.norm() > kLooks * static_cast<double>(samples); }
};

/// A place from which a skin goes on.
struct Front {
  Vector3d place, normal;
};

class Skins {
 public:
  Skins(const Scan& scan, const Surface& surface) : scan_(scan), surface_(surface) {}

  cloud::OrientedPoints all() {
    for (std::size_t i = 0; i < scan_.size() && taken_.size() < kMaxTaken; ++i) {
      if (const auto seed = beyond_rim(i)) span(*seed, scan_.spacing(i));
    }
    if (result_.size() > 0) flatten();
    result_.append(wide_);
    return std::move(result_);
  }

 private:
  /// Beside a sample whose neighbours all lie on its other side.
  std::optional<Front> beyond_rim(std::size_t i) const {
    const Vector3d &own = scan_.positions()[i], &normal = scan_.normals()[i];
    const auto around = scan_.around(i);
    Vector3d middle = Vector3d::Zero();
    for (const Neighbour& n : around) middle += scan_.positions()[n.index] - own;
    middle /= static_cast<double>(around.size());
    middle -= normal.dot(middle) * normal;
    const double off = middle.norm();
    if (!(off * off > kLopsided * kLopsided * around.back().squared_distance)) return std::nullopt;
    return Front{own - kStep * scan_.spacing(i) / off * middle, normal};
  }

  double outside(const Vector3d& x) const { return 0.5 - surface_.enclosure()(x); }

  static bool beside(const std::vector<Vector3d>& places, const Vector3d& x, double apart) {
    return std::any_of(places.begin(), places.end(), [&](const Vector3d& p) { return (p - x).squaredNorm() < apart * apart; });
  }

  bool is_free(const Vector3d& x, double spacing) const {
    const double apart = kApart * spacing;
    scan_.tree().nearest(x, 1, found_);
    return found_[0].squared_distance >= apart * apart && !beside(taken_, x, apart);
  }

  /// The place of the skin nearest to another one along its normal.
  std::optional<Front> on_skin(const Front& from, double spacing) const {
    const double step = kSearch * spacing / kSearchSteps;
    const auto at = [&](double t) { return Vector3d(from.place + t * from.normal); };
    const bool begin = outside(from.place) > 0.0;
    double low = 0.0, high = 0.0;  // inside, outside
    bool met = false;
    for (int k = 1; k <= kSearchSteps && !met; ++k) {
      const double t = begin ? -k * step : k * step;
      met = (outside(at(t)) > 0.0) != begin;
      (met == begin ? low : high) = t;
    }
    if (!met) return std::nullopt;
    for (int k = 0; k < kHalvings; ++k) {
      const double middle = 0.5 * (low + high);
      (outside(at(middle)) > 0.0 ? high : low) = middle;
    }
    Front result{at(0.5 * (low + high)), {}};
    for (int axis = 0; axis < 3; ++axis) {
      const Vector3d along = 0.25 * spacing * Vector3d::Unit(axis);
      result.normal[axis] = outside(result.place + along) - outside(result.place - along);
    }
    const double length = result.normal.norm();
    if (!(length > 0.0)) return std::nullopt;
    result.normal /= length;
    return result;
  }

  /// Covers the hole at a place.
  void span(const Front& seed, double spacing) {
    std::vector<Front> waiting(1, seed);
    cloud::OrientedPoints skin;
    Rim rim;
    double farthest = 0.0;  // from the samples of the scan
    bool too_large = false;
    while (!waiting.empty() && !too_large) {
      const Front from = waiting.back();
      waiting.pop_back();
      if (!is_free(from.place, spacing)) continue;
      const std::optional<Front> here = on_skin(from, spacing);
      if (!here || !is_free(here->place, spacing)) continue;
      scan_.tree().nearest(here->place, 1, found_);
      const double way = std::sqrt(found_[0].squared_distance);
      farthest = std::max(farthest, way);
      if (way < kBeside * spacing) {
        ++rim.samples;
        rim.normals += scan_.normals()[found_[0].index];
        rim.disagreeing += surface_.distance(here->place) > kDisagree * way ? 1U : 0U;
      }
      taken_.push_back(here->place);
      skin.positions.push_back(here->place);
      skin.normals.push_back(here->normal);
      if (!scan_.stiffness().empty()) skin.stiffness.push_back(scan_.stiffness()[found_[0].index]);
      const Vector3d u = here->normal.unitOrthogonal(), v = here->normal.cross(u);
      const double half = 0.5 * kStep * spacing, high = std::sqrt(3.0) * half;
      for (const Vector3d& step : {Vector3d(2 * half * u), Vector3d(half * u + high * v), Vector3d(-half * u + high * v),
                                   Vector3d(-2 * half * u), Vector3d(-half * u - high * v), Vector3d(half * u - high * v)})
        waiting.push_back({here->place + step, here->normal});
      too_large = skin.size() >= kMaxWide || beside(given_up_, here->place, 2.0 * kStep * spacing);
    }
    if (too_large) {
      given_up_.insert(given_up_.end(), skin.positions.begin(), skin.positions.end());
      return;
    }
    if (farthest >= kWide * spacing && rim.looks_one_way()) {
      cloud::OrientedPoints bent = skin;
      fair_skin(scan_, bent);
      if (std::all_of(bent.positions.begin(), bent.positions.end(),
                      [&](const Vector3d& p) { return surface_.closing().distance(p) < -kWithin; })) {
        wide_.append(bent);
        return;
      }
    }
    if (skin.size() < kMaxSamples && farthest >= kHole * spacing && rim.disagrees()) result_.append(skin);
  }

  /// Draws the skins tight between the samples of the scan, which stay.
  void flatten() {
    std::vector<Vector3d> positions = scan_.positions();
    positions.insert(positions.end(), result_.positions.begin(), result_.positions.end());
    const Nearest tree(positions);
    std::vector<std::vector<Neighbour>> around(result_.size());
    for (std::size_t i = 0; i < around.size(); ++i) tree.nearest(result_.positions[i], kDrawing + 1, around[i]);
    const std::size_t first = scan_.size();
    for (int pass = 0; pass < kPasses; ++pass) {
      for (std::size_t i = 0; i < around.size(); ++i) {
        double sum = 0.0;
        for (const Neighbour& n : around[i]) sum += result_.normals[i].dot(positions[n.index] - positions[first + i]);
        result_.positions[i] = positions[first + i] + sum / static_cast<double>(around[i].size() - 1) * result_.normals[i];
      }
      std::copy(result_.positions.begin(), result_.positions.end(), positions.begin() + static_cast<std::ptrdiff_t>(first));
    }
    for (std::size_t i = 0; i < around.size(); ++i) {
      const Vector3d normal = fit_quadric(positions, around[i]).normal;
      result_.normals[i] = normal.dot(result_.normals[i]) < 0.0 ? Vector3d(-normal) : normal;
    }
  }

  const Scan& scan_;
  const Surface& surface_;
  std::vector<Vector3d> taken_;     ///< all places of skins, also of those that were left out
  std::vector<Vector3d> given_up_;  ///< places of skins that are too large
  cloud::OrientedPoints result_;    ///< drawn tight
  cloud::OrientedPoints wide_;      ///< bent as the surface round them
  mutable std::vector<Neighbour> found_;
};

}  // namespace

cloud::OrientedPoints hole_samples(const Scan& scan, const Surface& surface) { return Skins(scan, surface).all(); }

}  // namespace isotouch::field
