/// Values of a stream that may go on for days, counted in classes of one width: memory does not grow.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "host/quantiles.h"

namespace isotouch::stream {

class Classes {
 public:
  /// in_unit   classes in one unit of the values; values from kClasses classes on are in one
  explicit Classes(double in_unit) : in_unit_(in_unit) {}

  /// value     not negative
  void add(double value) {
    const double at = std::min(std::floor(value * in_unit_), static_cast<double>(kClasses - 1));
    ++counts_[static_cast<std::size_t>(at)];
    ++count_;
    max_ = std::max(max_, value);
  }

  /// By the nearest rank: the upper end of its class, and the largest value as it was.
  Quantiles quantiles() const {
    if (count_ == 0) return {};
    return {count_, rank(0.5), rank(0.95), rank(0.99), max_};
  }

 private:
  static constexpr std::size_t kClasses = 20'000;

  double rank(double share) const {
    const auto wanted = static_cast<std::uint64_t>(std::max(1.0, std::ceil(share * static_cast<double>(count_))));
    std::uint64_t below = 0;
    for (std::size_t at = 0; at + 1 < kClasses; ++at) {
      below += counts_[at];
      if (below >= wanted) return std::min(static_cast<double>(at + 1) / in_unit_, max_);
    }
    return max_;
  }

  double in_unit_;
  std::vector<std::uint64_t> counts_ = std::vector<std::uint64_t>(kClasses);
  std::size_t count_ = 0;
  double max_ = 0;
};

}  // namespace isotouch::stream
