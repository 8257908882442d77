#include "host/stream/classes.h"

#include <gtest/gtest.h>

namespace isotouch::stream {
namespace {

TEST(Classes, QuantilesAreThoseOfTheValuesToTheWidthOfAClass) {
  Classes classes(10);
  std::vector<double> values;
  for (int n = 0; n < 5000; ++n) values.push_back(0.013 * ((n * 2711) % 5000));
  for (const double value : values) classes.add(value);
  const Quantiles exact = quantiles(values), found = classes.quantiles();
  EXPECT_EQ(found.count, 5000U);
  for (const auto of : {&Quantiles::median, &Quantiles::p95, &Quantiles::p99}) {
    EXPECT_GE(found.*of, exact.*of);
    EXPECT_LE(found.*of, exact.*of + 0.1001);
  }
  EXPECT_EQ(found.max, exact.max);
}

TEST(Classes, WhatIsBeyondTheLastClassStaysTheLargest) {
  Classes classes(10);
  EXPECT_EQ(classes.quantiles().count, 0U);
  classes.add(1);
  classes.add(1e9);
  EXPECT_EQ(classes.quantiles().max, 1e9);
  EXPECT_EQ(classes.quantiles().p99, 1e9);
  EXPECT_NEAR(classes.quantiles().median, 1, 0.101);
}

}  // namespace
}  // namespace isotouch::stream
