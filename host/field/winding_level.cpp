#include "host/field/winding_level.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "host/field/parallel.h"

namespace isotouch::field {

namespace {

// Lengths are in spacings of the samples, the root of their areas. By trial of 2026-11 on noisy, stray, turned and thinned scans of five objects.
constexpr double kSlack = 0.15;  // where all are doubtful: at 0.2 a hydrant with turned normals has 15 % more error from surface to truth
constexpr double kSlackNoise = 0.12;   // of the median distance to the sixth neighbour: up to here the slack is whole
constexpr double kNoSlackNoise = 0.3;  // and from here on there is none
constexpr double kFree = 1.0;          // more where none is
constexpr double kAllOf = 0.5;         // so large a share of doubtful samples counts as all
constexpr double kSteepest = 1e-4;
constexpr std::size_t kAsked = 512;  // samples for the median, about

double squared(double x) { return x * x; }

}  // namespace

WindingLevel::WindingLevel(const Scan& scan, std::vector<std::uint8_t> doubtful, const WindingSign& winding)
    : doubtful_(std::move(doubtful)), winding_(winding), slack_(kSlack) {
  if (winding.noise() > 0.0)
    slack_ *= std::clamp((kNoSlackNoise - winding.noise() / scan.median_spacing()) / (kNoSlackNoise - kSlackNoise), 0.0, 1.0);
  if (std::find(doubtful_.begin(), doubtful_.end(), 1) == doubtful_.end()) return;
  const std::size_t step = std::max<std::size_t>(1, scan.size() / kAsked);
  std::vector<double> levels((scan.size() + step - 1) / step);
  in_parallel(levels.size(), 64, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n) levels[n] = level(scan.positions()[n * step], winding_.area(n * step));
  });
  const auto middle = levels.begin() + static_cast<std::ptrdiff_t>(levels.size() / 2);
  std::nth_element(levels.begin(), middle, levels.end());
  offset_ = *middle;
}

double WindingLevel::level(const Eigen::Vector3d& place, double area) const {
  const double side = 1.0 - 2.0 * winding_(place);
  return side * std::sqrt(winding_.softening(area) / std::max(1.0 - side * side, kSteepest));
}

double WindingLevel::hold(double distance, const Eigen::Vector3d& place, std::span<const Neighbour> nearest) const {
  const double border = nearest.back().squared_distance;
  double in_doubt = 0.0, areas = 0.0, weights = 0.0;
  for (const Neighbour& n : nearest) {
    const double weight = border > 0.0 ? squared(squared(1.0 - n.squared_distance / border)) : 0.0;
    in_doubt += is_doubtful(n.index) ? weight : 0.0;
    areas += weight * winding_.area(n.index);
    weights += weight;
  }
  if (!(in_doubt > 0.0)) return distance;
  const double spacing = std::sqrt(areas / weights);
  const double slack = spacing * (slack_ + kFree * (1.0 - std::min(1.0, in_doubt / (kAllOf * weights))));
  const double most = std::max(std::sqrt(nearest.front().squared_distance), 2.0 * kSlack * spacing);
  if (slack >= most) return distance;
  const double height = level(place, spacing * spacing) - offset_;
  if (height > slack) return std::max(distance, std::min(height, most) - slack);
  if (height < -slack) return std::min(distance, std::max(height, -most) + slack);
  return distance;
}

}  // namespace isotouch::field
