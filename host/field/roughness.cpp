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
constexpr double kPerLean =
    3.5;  // radians of `of_normals` for each that pairs lean off their circles: tilts gave 2.8 to 3.0, of 30 degrees 3.4
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

/// Mean size over root mean square.
double evenness(const std::vector<double>& values) {
  double sizes = 0.0, squares = 0.0;
  for (const double value : values) sizes += std::abs(value), squares += value * value;
  return squares > 0.0 ? sizes / std::sqrt(squares * static_cast<double>(values.size())) : 0.0;
}

/// By how much the samples of pairs differ, and how long the steps between them are.
class Pairs {
 public:
  void add(double difference, const Neighbour& n) {
    differences_.push_back(difference);
    squared_steps_ += n.squared_distance;
  }
  double usual(double share) const { return differences_.empty() ? 0.0 : quantile(differences_, share); }
  double mean_squared_step() const { return differences_.empty() ? 0.0 : squared_steps_ / static_cast<double>(differences_.size()); }

 private:
  std::vector<double> differences_;
  double squared_steps_ = 0;
};

/// The size of half the sum of the heights of two samples, each over the other's tangent plane: zero on every circle.
double height_over_circle(const Scan& scan, std::size_t i, const Neighbour& n) {
  const Vector3d way = scan.positions()[n.index] - scan.positions()[i];
  return std::abs(0.5 * (scan.normals()[i] + scan.normals()[n.index]).dot(way));
}

/// Of one sample's height: two have each their own.
double deviation(const Pairs& heights) { return heights.usual(kUsual) / (kNormalUsual * std::sqrt(2.0)); }

double height_variance(const Pairs& heights) {
  const double own = deviation(heights);
  return own * own;
}

/// Of one normal in two directions: of a pair's difference in one.
double turn_variance(const Pairs& squared_turns) { return squared_turns.usual(0.5) / kMedianTurn; }

/// A tilted normal adds heights, and curvature turns normals, in proportion to the step. Steps of two lengths tell what deviation is left at none.
double without_step(const Pairs& near, const Pairs& far, double (*variance)(const Pairs&)) {
  const double near_step = near.mean_squared_step(), far_step = far.mean_squared_step();
  if (!(far_step > near_step)) return 0.0;
  return std::sqrt(std::max(0.0, (variance(near) * far_step - variance(far) * near_step) / (far_step - near_step)));
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
  std::vector<double> deviations(asked), heights(asked), tilts(asked);
  in_parallel(asked, 32, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n) {
      const QuadricFit fit = fit_quadric(scan.positions(), scan.around(n * step));
      deviations[n] = fit.deviation;
      heights[n] = fit.deviation > 0.0 ? fit.height / fit.deviation : 0.0;
      tilts[n] = fit.normal.cross(scan.normals()[n * step]).norm();
    }
  });
  Pairs nearest, leans, near, far, near_turns, far_turns;
  for (std::size_t i = 0; i < scan.size(); i += step) {
    const auto around = scan.around(i);
    for (std::size_t k = 0; k < around.size(); ++k) {
      const Neighbour& n = around[k];
      if (n.index == i) continue;
      const Vector3d &own = scan.normals()[i], &other = scan.normals()[n.index];
      const double height = height_over_circle(scan, i, n), squared_turn = (own - other).squaredNorm();
      if (k < kNear) nearest.add(height, n);
      if (k < kNear && n.squared_distance > 0.0) leans.add(height / std::sqrt(n.squared_distance), n);
      if (squared_turn <= kMaxTurn) (k < kNear ? near_turns : far_turns).add(squared_turn, n);
      if (own.dot(other) > kOneFace) (k < kNear ? near : far).add(height, n);
    }
  }
  Roughness result;
  result.spacing = spacing;
  result.of_positions = quantile(std::move(deviations), kUsual);
  result.of_pairs = deviation(nearest);
  result.of_no_step = without_step(near, far, height_variance);
  // Round a thin rod far pairs within a right angle turn no more than near ones do, whatever the noise.
  result.of_normals = std::min(without_step(near_turns, far_turns, turn_variance), kPerLean * deviation(leans));
  result.tilt = quantile(std::move(tilts), 0.5);
  result.layered = evenness(heights);
  return result;
}

}  // namespace isotouch::field
