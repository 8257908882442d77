/// Median, high quantiles and the largest of a set of values.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace isotouch {

/// Of a set of values; all zero when it is empty.
struct Quantiles {
  std::size_t count = 0;
  double median = 0, p95 = 0, p99 = 0, max = 0;
};

/// The place in `count` sorted values, at least one, of the least that a share of them do not exceed.
///
/// source    nearest rank
inline std::size_t quantile_place(double share, std::size_t count) {
  const auto rank = static_cast<std::size_t>(std::ceil(share * static_cast<double>(count)));
  return std::max<std::size_t>(rank, 1) - 1;
}

inline Quantiles quantiles(std::vector<double> values) {
  if (values.empty()) return {};
  std::sort(values.begin(), values.end());
  const auto rank = [&](double share) { return values[quantile_place(share, values.size())]; };
  return {values.size(), rank(0.5), rank(0.95), rank(0.99), values.back()};
}

}  // namespace isotouch
