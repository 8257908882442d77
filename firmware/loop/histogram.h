/// Counts of durations in fixed log-linear steps: 16 to an octave, so that any value is known to within 6.25 %. One writer, any number of readers,
/// no lock: a reader that comes in the middle of a tick sees that tick half, and nothing worse.
#pragma once

#include <array>
#include <atomic>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace isotouch::loop {

namespace histogram_layout {
inline constexpr int kStepShift = 4;  ///< 16 steps to an octave
inline constexpr std::uint32_t kSteps = 1U << kStepShift;
inline constexpr std::size_t kBuckets = (32 - kStepShift + 1) * kSteps;  ///< up to 2^32 ns; longer ones count in the last

/// The bucket of a duration.
constexpr std::size_t bucket(std::uint32_t ns) {
  if (ns < kSteps) return ns;
  const int shift = 31 - std::countl_zero(ns) - kStepShift;
  return static_cast<std::size_t>(shift) * kSteps + (ns >> shift);
}

/// The largest duration of a bucket.
constexpr std::uint32_t upper_ns(std::size_t bucket) {
  if (bucket < kSteps) return static_cast<std::uint32_t>(bucket);
  const std::size_t shift = bucket / kSteps - 1;
  return static_cast<std::uint32_t>(((std::uint64_t{bucket % kSteps + kSteps} + 1) << shift) - 1);
}
}  // namespace histogram_layout

/// What a histogram held at one moment.
struct Distribution {
  std::array<std::uint64_t, histogram_layout::kBuckets> counts{};
  std::uint64_t total = 0;
  std::uint32_t largest_ns = 0;  ///< exact

  /// The duration that `share` of all are not longer than, for a share of 0.5 the median: the upper end of its bucket, at most `largest_ns`.
  ///
  /// per_million   500,000 is the median, 999,000 is p999
  /// returns       0 when nothing was counted
  std::uint32_t quantile_ns(std::uint32_t per_million) const {
    const std::uint64_t wanted = (total / 1'000'000 * per_million) + (total % 1'000'000 * per_million + 999'999) / 1'000'000;
    std::uint64_t below = 0;
    for (std::size_t i = 0; i < counts.size() && total > 0; ++i) {
      below += counts[i];
      if (below >= wanted && below > 0) return histogram_layout::upper_ns(i) < largest_ns ? histogram_layout::upper_ns(i) : largest_ns;
    }
    return largest_ns;
  }
};

class Histogram {
  static_assert(std::atomic<std::uint64_t>::is_always_lock_free);

 public:
  /// ns        negative ones count as 0
  /// tick      yes
  void add(std::int64_t ns) {
    const auto value = static_cast<std::uint32_t>(ns < 0 ? 0 : ns > std::int64_t{UINT32_MAX} ? std::int64_t{UINT32_MAX} : ns);
    auto& count = counts_[histogram_layout::bucket(value)];
    count.store(count.load(std::memory_order_relaxed) + 1, std::memory_order_relaxed);
    if (value > largest_.load(std::memory_order_relaxed)) largest_.store(value, std::memory_order_relaxed);
  }

  /// Any thread; never waits.
  Distribution read() const {
    Distribution now;
    for (std::size_t i = 0; i < counts_.size(); ++i) now.total += now.counts[i] = counts_[i].load(std::memory_order_relaxed);
    now.largest_ns = largest_.load(std::memory_order_relaxed);
    return now;
  }

 private:
  std::array<std::atomic<std::uint64_t>, histogram_layout::kBuckets> counts_{};
  std::atomic<std::uint32_t> largest_{0};
};

}  // namespace isotouch::loop
