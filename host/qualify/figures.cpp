#include "host/qualify/figures.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace isotouch::qualify {

link::Histogram between(const link::Histogram& before, const link::Histogram& after) {
  link::Histogram grown{after.count - std::min(after.count, before.count), {}};
  auto old = before.bins.begin();
  for (const protocol::Bin& bin : after.bins) {
    // The last class is told with the largest value instead of its bound, so an old bound may lie below the new one's.
    std::uint64_t known = 0;
    for (; old != before.bins.end() && old->upper <= bin.upper; ++old) known += old->count;
    if (bin.count > known) grown.bins.push_back({bin.upper, bin.count - known});
  }
  return grown;
}

link::Histogram sum(const link::Histogram& one, const link::Histogram& other) {
  std::map<std::uint32_t, std::uint64_t> counts;
  for (const link::Histogram* part : {&one, &other}) {
    for (const protocol::Bin& bin : part->bins) counts[bin.upper] += bin.count;
  }
  link::Histogram both{one.count + other.count, {}};
  for (const auto& [upper, count] : counts) both.bins.push_back({upper, count});
  return both;
}

std::optional<std::uint32_t> quantile_ns(const link::Histogram& histogram, double share) {
  std::uint64_t all = 0, below = 0;
  for (const protocol::Bin& bin : histogram.bins) all += bin.count;
  const auto wanted = static_cast<std::uint64_t>(std::ceil(share * static_cast<double>(all)));
  for (const protocol::Bin& bin : histogram.bins) {
    below += bin.count;
    if (below >= wanted && bin.count > 0) return bin.upper;
  }
  return std::nullopt;
}

std::optional<double> hottest(const std::vector<Moment>& moments) {
  std::optional<double> most;
  for (const Moment& moment : moments) {
    if (moment.celsius && (!most || *moment.celsius > *most)) most = moment.celsius;
  }
  return most;
}

}  // namespace isotouch::qualify
