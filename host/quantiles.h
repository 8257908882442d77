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

/// source    nearest rank
inline Quantiles quantiles(std::vector<double> values) {
  if (values.empty()) return {};
  std::sort(values.begin(), values.end());
  const auto rank = [&](double share) {
    const auto place = static_cast<std::size_t>(std::ceil(share * static_cast<double>(values.size())));
    return values[std::max<std::size_t>(place, 1) - 1];
  };
  return {values.size(), rank(0.5), rank(0.95), rank(0.99), values.back()};
}

}  // namespace isotouch
