#include "host/live/verdict.h"

#include <cmath>

namespace isotouch::live {

namespace {

constexpr double kMostLonely = 0.1;
constexpr double kMostUnexplained = 0.25;  ///< an owl of 40 voxels has 0.12, a cow with three in ten normals turned 0.59

std::string percent(double share) { return std::to_string(std::lround(100.0 * share)) + " %"; }

}  // namespace

std::vector<std::string> Verdict::reasons() const {
  std::vector<std::string> found;
  if (samples == lonely) found.emplace_back("no part of it has enough points to be felt; choose a larger --voxel or a smaller --grid");
  if (samples > lonely && lonely_share() > kMostLonely)
    found.push_back(percent(lonely_share()) +
                    " of the samples have too few neighbours to be felt; choose a larger --voxel or a smaller --grid");
  if (unexplained_share() > kMostUnexplained)
    found.push_back(percent(unexplained_share()) + " of the samples contradict their neighbours; check the normals");
  return found;
}

}  // namespace isotouch::live
