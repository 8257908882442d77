#include "host/qualify/figures.h"

#include <gtest/gtest.h>

#include <vector>

namespace isotouch::qualify {
namespace {

bool operator==(const protocol::Bin& a, const protocol::Bin& b) { return a.upper == b.upper && a.count == b.count; }

TEST(Figures, WhatCameBetweenIsTheDifferenceOfEveryClass) {
  const link::Histogram before{6, {{10, 5}, {20, 1}}}, after{13, {{10, 7}, {15, 2}, {20, 1}, {40, 3}}};
  const link::Histogram grown = between(before, after);
  EXPECT_EQ(grown.count, 7U);
  ASSERT_EQ(grown.bins.size(), 3U);
  EXPECT_TRUE((grown.bins[0] == protocol::Bin{10, 2}));
  EXPECT_TRUE((grown.bins[1] == protocol::Bin{15, 2}));
  EXPECT_TRUE((grown.bins[2] == protocol::Bin{40, 3}));
}

TEST(Figures, TheLastClassMayHaveBeenToldWithTheLargestValue) {
  // 33 was the largest value then, in the class up to 35.
  const link::Histogram grown = between({3, {{10, 1}, {33, 2}}}, {7, {{10, 2}, {35, 4}, {36, 1}}});
  ASSERT_EQ(grown.bins.size(), 3U);
  EXPECT_TRUE((grown.bins[1] == protocol::Bin{35, 2}));
  std::uint64_t all = 0;
  for (const protocol::Bin& bin : grown.bins) all += bin.count;
  EXPECT_EQ(all, grown.count);
}

TEST(Figures, AQuantileIsTheBoundOfItsClass) {
  const link::Histogram histogram{1000, {{10, 500}, {20, 499}, {90, 1}}};
  EXPECT_EQ(quantile_ns(histogram, 0.5), 10U);
  EXPECT_EQ(quantile_ns(histogram, 0.501), 20U);
  EXPECT_EQ(quantile_ns(histogram, 0.999), 20U);
  EXPECT_EQ(quantile_ns(histogram, 1), 90U);
  EXPECT_EQ(quantile_ns({}, 0.5), std::nullopt);
}

TEST(Figures, ABoardWithoutSensorsHasNoTemperature) {
  Moment cold, hot;
  cold.celsius = 40, hot.celsius = 61.5;
  EXPECT_EQ(hottest({cold, hot, Moment{}, cold}), 61.5);
  EXPECT_EQ(hottest({Moment{}, Moment{}}), std::nullopt);
}

TEST(Figures, TwoHistogramsAreOneByRisingBounds) {
  const link::Histogram all = sum({3, {{5'000, 2}, {9'000, 1}}}, {4, {{4'000, 1}, {9'000, 3}}});
  EXPECT_EQ(all.count, 7U);
  ASSERT_EQ(all.bins.size(), 3U);
  EXPECT_EQ(all.bins[0].upper, 4'000U);
  EXPECT_EQ(all.bins[2].count, 4U);
  EXPECT_EQ(sum({}, all).bins.size(), 3U);
}

}  // namespace
}  // namespace isotouch::qualify
