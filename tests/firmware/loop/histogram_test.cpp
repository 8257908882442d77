#include "firmware/loop/histogram.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "tests/support/random.h"

namespace isotouch::loop {
namespace {

TEST(Histogram, BucketsLieSideBySideAndAreNarrow) {
  using namespace histogram_layout;
  EXPECT_EQ(bucket(0), 0U);
  EXPECT_EQ(bucket(UINT32_MAX), kBuckets - 1);
  EXPECT_EQ(upper_ns(kBuckets - 1), UINT32_MAX);
  for (std::size_t i = 0; i < kBuckets; ++i) {
    EXPECT_EQ(bucket(upper_ns(i)), i);
    if (i + 1 < kBuckets) {
      EXPECT_EQ(bucket(upper_ns(i) + 1), i + 1);
      EXPECT_LE(double(upper_ns(i + 1) - upper_ns(i)), 1 + double(upper_ns(i)) / 16) << i;
    }
  }
}

TEST(Histogram, QuantilesAreThoseOfTheSortedValuesToASixteenth) {
  Histogram histogram;
  test::Random random(7);
  std::vector<std::uint32_t> values;
  for (int i = 0; i < 20'000; ++i) {
    values.push_back(static_cast<std::uint32_t>(random.bits() >> (random.bits() % 28)));
    histogram.add(values.back());
  }
  std::sort(values.begin(), values.end());
  const Distribution now = histogram.read();
  EXPECT_EQ(now.total, values.size());
  EXPECT_EQ(now.largest_ns, values.back());
  for (const std::uint32_t share : {1U, 10'000U, 500'000U, 990'000U, 999'000U, 1'000'000U}) {
    const auto rank = std::max<std::uint64_t>((std::uint64_t{values.size()} * share + 999'999) / 1'000'000, 1);
    const double exact = values[static_cast<std::size_t>(rank - 1)];
    EXPECT_GE(now.quantile_ns(share), exact) << share;
    EXPECT_LE(now.quantile_ns(share), exact * 17 / 16 + 1) << share;
  }
}

TEST(Histogram, TakesAnyNumber) {
  Histogram histogram;
  EXPECT_EQ(histogram.read().quantile_ns(500'000), 0U);
  histogram.add(-5);
  EXPECT_EQ(histogram.read().quantile_ns(1'000'000), 0U);
  histogram.add(INT64_MAX);
  EXPECT_EQ(histogram.read().total, 2U);
  EXPECT_EQ(histogram.read().largest_ns, UINT32_MAX);
}

}  // namespace
}  // namespace isotouch::loop
