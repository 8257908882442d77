#include "firmware/guard/clearance.h"

#include <gtest/gtest.h>

#include "firmware/guard/to_double.h"
#include "tests/support/device_bench.h"
#include "tests/support/random.h"

namespace isotouch::guard {
namespace {

TEST(Clearance, IsNeverMoreThanTheDistanceAndHardlyLess) {
  test::Random random(3);
  const FieldView& field = test::ball().view();
  const double band = to_double(field.band) * to_double(field.edge);
  int outside = 0;
  for (int i = 0; i < 20'000; ++i) {
    const Point at = {random.uniform(-14, 14), random.uniform(-14, 14), random.uniform(-14, 14)};
    const double distance = length(at - Point{test::kCentre.x, test::kCentre.y, test::kCentre.z}) - 8;
    const double clear = clearance(field, at);
    EXPECT_LE(clear, std::max(std::min(distance, band), -band) + 0.01);
    EXPECT_GE(clear, std::min(distance, band) - 0.4 * 2.7) << "a corner of the numbers around is that far";
    outside += clear > 0.5 ? 1 : 0;
  }
  EXPECT_GT(outside, 5000);
}

}  // namespace
}  // namespace isotouch::guard
