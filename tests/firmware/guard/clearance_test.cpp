#include "firmware/guard/clearance.h"

#include <gtest/gtest.h>

#include "firmware/guard/to_double.h"
#include "tests/support/device_bench.h"
#include "tests/support/random.h"

namespace isotouch::guard {
namespace {

/// A ball of 8 mm in a field whose numbers grow by so much a millimetre.
test::FieldImage ball_of_slope(double slope, test::FieldOptions options) {
  options.edge_mm = 0.4;
  options.origin_mm = {-12, -12, -12};
  options.largest_slope = slope;
  return {{64, 64, 64},
          [slope](const test::Point& p) {
            return slope * (test::length(p * 0.4 - test::Point{12, 12, 12} - test::kCentre) - 8) / 0.4;
          },
          options};
}

TEST(Clearance, IsNeverMoreThanTheDistanceAndHardlyLess) {
  const double kCorner = 0.4 * 2.7;  // a corner of the numbers around is that far
  const struct {
    const char* what;
    double slope, corner;
    test::FieldOptions options;
  } rows[] = {{"a spline", 1, kCorner, {}},
              {"trilinear", 1, 0.4 * 1.8, {.prefilter = false, .interpolation = Interpolation::kTrilinear}},
              {"steep", 2, kCorner, {}}};
  for (const auto& row : rows) {
    const test::FieldImage image = ball_of_slope(row.slope, row.options);
    const FieldView& field = image.view();
    const double band = to_double(field.band) * to_double(field.edge) / row.slope;
    test::Random random(3);
    int outside = 0;
    for (int i = 0; i < 20'000; ++i) {
      const Point at = {random.uniform(-14, 14), random.uniform(-14, 14), random.uniform(-14, 14)};
      const double distance = length(at - Point{test::kCentre.x, test::kCentre.y, test::kCentre.z}) - 8;
      const double clear = clearance(field, at);
      EXPECT_LE(clear, std::max(std::min(distance, band), -band) + 0.01) << row.what;
      EXPECT_GE(clear, std::min(distance > 0 ? distance : row.slope * distance, band) - row.slope * row.corner) << row.what;
      outside += clear > 0.5 ? 1 : 0;
    }
    EXPECT_GT(outside, 5000) << row.what;
  }
}

}  // namespace
}  // namespace isotouch::guard
