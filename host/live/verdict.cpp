#include "host/live/verdict.h"

#include <algorithm>
#include <cmath>

namespace isotouch::live {

namespace {

constexpr double kMostLonely = 0.1;
constexpr double kOneSided = 0.4;          ///< length of the mean normal; a half sphere has 0.5, a closed body 0
constexpr double kInwards = 0.3;           ///< of the samples' spread; a sphere that is inside out has 1
constexpr double kMostUnexplained = 0.25;  ///< an owl of 40 voxels has 0.12, a cow with three in ten normals turned 0.59

std::string percent(double share) { return std::to_string(std::lround(100.0 * share)) + " %"; }

}  // namespace

void Facing::add(const Eigen::Vector3d& position, const Eigen::Vector3d& normal, bool present) {
  const auto whole = [](double value) { return static_cast<std::int64_t>(std::llround(value)); };
  const Eigen::Matrix<std::int64_t, 3, 1> at = (64.0 * position).unaryExpr(whole), outwards = (512.0 * normal).unaryExpr(whole);
  const std::int64_t sign = present ? 1 : -1;
  places += sign * at;
  normals += sign * outwards;
  across += sign * at.dot(outwards);
  squares += sign * at.squaredNorm();
}

bool Facing::inwards(std::size_t samples) const {
  if (samples == 0) return false;
  const auto n = static_cast<double>(samples);
  const Eigen::Vector3d middle = places.cast<double>() / n, mean = normals.cast<double>() / n;
  if (mean.norm() > kOneSided * 512.0) return false;
  const double spread = std::sqrt(std::max(0.0, static_cast<double>(squares) / n - middle.squaredNorm()));
  return static_cast<double>(across) / n - mean.dot(middle) < -kInwards * 512.0 * spread;
}

std::vector<std::string> Verdict::reasons() const {
  std::vector<std::string> found;
  if (samples == 0) found.emplace_back("none of its points is left; choose a longer --keep");
  if (samples > 0 && samples == lonely)
    found.emplace_back("no part of it has enough points to be felt; choose a larger --voxel or a smaller --grid");
  if (samples > lonely && lonely_share() > kMostLonely)
    found.push_back(percent(lonely_share()) +
                    " of the samples have too few neighbours to be felt; choose a larger --voxel or a smaller --grid");
  if (unexplained_share() > kMostUnexplained)
    found.push_back(percent(unexplained_share()) + " of the samples contradict their neighbours; check the normals");
  if (facing.inwards(samples)) found.emplace_back("its normals look towards its middle, so it is inside out; turn the normals of the file");
  return found;
}

}  // namespace isotouch::live
