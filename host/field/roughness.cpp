#include "host/field/roughness.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "host/field/parallel.h"
#include "host/field/quadric_fit.h"

namespace isotouch::field {

namespace {

using Eigen::Vector3d;

constexpr std::size_t kAsked = 4096;  // samples for the noise, about
constexpr double kUsual = 0.6;        // of the samples deviate less than what counts as the noise: edges deviate more
constexpr double kNoisy = 0.65;
constexpr double kPairsOfTilt =
    0.5;  // spacings of `of_pairs` for each unit of tilt: tilts of 5, 15 and 30 degrees gave 0.51, 0.50 and 0.47
constexpr double kNormalUsual = 0.8416;  // standard deviations: 60 % of a normal distribution lie within them
constexpr double kOneFace = 0.7;         // cosine between normals on one face
constexpr double kMaxTurn = 2.0;         // squared, between normals: a right angle
constexpr double kMedianTurn = 1.3863;   // of two normal distributions' squared length, in variances of one: twice the logarithm of two
constexpr std::size_t kNear = 7;         // a sample and its six neighbours

/// The value that a share of all do not exceed.
double quantile(std::vector<double> values, double share) {
  const auto place = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), place, values.end());
  return *place;
}

/// Heights of samples over the circles that their normals and those of others describe.
struct PairHeights {
  std::vector<double> heights;
  double squared_steps = 0;

  void add(const Scan& scan, std::size_t i, const Neighbour& n) {
    // Half the sum of the heights of two samples, each over the other's tangent plane, is zero on every circle.
    const Vector3d way = scan.positions()[n.index] - scan.positions()[i];
    heights.push_back(std::abs(0.5 * (scan.normals()[i] + scan.normals()[n.index]).dot(way)));
    squared_steps += n.squared_distance;
  }
  /// Of one sample: two have each their own.
  double deviation() const { return heights.empty() ? 0.0 : quantile(heights, kUsual) / (kNormalUsual * std::sqrt(2.0)); }
  double mean_squared_step() const { return heights.empty() ? 0.0 : squared_steps / static_cast<double>(heights.size()); }
};

/// How far apart the normals of pairs are.
struct PairTurns {
  std::vector<double> squares;
  double squared_steps = 0;

  void add(const Scan& scan, std::size_t i, const Neighbour& n) {
    const double square = (scan.normals()[i] - scan.normals()[n.index]).squaredNorm();
    if (square > kMaxTurn) return;
    squares.push_back(square);
    squared_steps += n.squared_distance;
  }
  /// Of one normal in two directions: of a pair's difference in one.
  double variance() const { return squares.empty() ? 0.0 : quantile(squares, 0.5) / kMedianTurn; }
  double mean_squared_step() const { return squares.empty() ? 0.0 : squared_steps / static_cast<double>(squares.size()); }
};

/// Curvature turns normals in proportion to the step. Steps of two lengths tell what is left at none.
double without_step(const PairTurns& near, const PairTurns& far) {
  const double near_step = near.mean_squared_step(), far_step = far.mean_squared_step();
  if (!(far_step > near_step)) return 0.0;
  return std::sqrt(std::max(0.0, (near.variance() * far_step - far.variance() * near_step) / (far_step - near_step)));
}

/// A tilted normal adds heights in proportion to the step. Steps of two lengths tell what is left at none.
double without_step(const PairHeights& near, const PairHeights& far) {
  const double near_step = near.mean_squared_step(), far_step = far.mean_squared_step();
  if (!(far_step > near_step)) return 0.0;
  const double low = near.deviation(), high = far.deviation();
  return std::sqrt(std::max(0.0, (low * low * far_step - high * high * near_step) / (far_step - near_step)));
}

}  // namespace

double Roughness::of_pairs_untilted() const {
  const double added = kPairsOfTilt * std::sqrt(std::max(0.0, tilt * tilt - of_positions * of_positions / (spacing * spacing))) * spacing;
  return std::sqrt(std::max(0.0, of_pairs * of_pairs - added * added));
}

double Roughness::noise() const { return std::min(of_positions, of_pairs_untilted()); }

bool Roughness::is_noise() const { return of_pairs_untilted() > kNoisy * of_positions || of_no_step > kNoisy * of_pairs; }

Roughness roughness(const Scan& scan, double spacing) {
  const std::size_t step = std::max<std::size_t>(1, scan.size() / kAsked);
  const std::size_t asked = (scan.size() + step - 1) / step;
  std::vector<double> deviations(asked), tilts(asked);
  in_parallel(asked, 32, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n) {
      const QuadricFit fit = fit_quadric(scan.positions(), scan.around(n * step));
      deviations[n] = fit.deviation;
      tilts[n] = fit.normal.cross(scan.normals()[n * step]).norm();
    }
  });
  PairHeights nearest, near, far;
  PairTurns near_turns, far_turns;
  for (std::size_t i = 0; i < scan.size(); i += step) {
    const auto around = scan.around(i);
    for (std::size_t k = 0; k < around.size(); ++k) {
      const Neighbour& n = around[k];
      if (n.index == i) continue;
      if (k < kNear) nearest.add(scan, i, n);
      (k < kNear ? near_turns : far_turns).add(scan, i, n);
      if (scan.normals()[i].dot(scan.normals()[n.index]) > kOneFace) (k < kNear ? near : far).add(scan, i, n);
    }
  }
  Roughness result;
  result.spacing = spacing;
  result.of_positions = quantile(std::move(deviations), kUsual);
  result.of_pairs = nearest.deviation();
  result.of_no_step = without_step(near, far);
  result.of_normals = without_step(near_turns, far_turns);
  result.tilt = quantile(std::move(tilts), 0.5);
  return result;
}

}  // namespace isotouch::field
