#include "host/trace/place_sample.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "host/to_double.h"
#include "tests/support/field_image.h"
#include "tests/support/random.h"

namespace isotouch::trace {
namespace {

using Eigen::Vector3d;

const Vector3d kCentre(30.2, 29.7, 30.4);  // index coordinates
constexpr double kRadius = 14;             // voxels

test::FieldImage ball(const test::FieldOptions& options) {
  return {{61, 61, 61}, [](const test::Point& p) { return (Vector3d(p[0], p[1], p[2]) - kCentre).norm() - kRadius; }, options};
}

TEST(PlaceSample, InTheBandDistanceAndGradientAreThoseOfTheBall) {
  for (const test::FieldOptions& options : {test::FieldOptions{.band = 4}, test::FieldOptions{.band = 1.5}, test::trilinear_options()}) {
    const test::FieldImage image = ball(options);
    const Vector3d origin = to_double(image.view().origin);
    const double edge = to_double(image.view().edge);
    test::Random random(1);
    int in_band = 0;
    double known_to = 0, error = 0, angle = 0;
    for (int i = 0; i < 20'000; ++i) {
      const test::Point drawn = random.direction();
      const Vector3d outward(drawn[0], drawn[1], drawn[2]);
      const double distance = random.uniform(-options.band - 1, options.band + 3);
      const PlaceSample sample = sample_place(image.view(), origin + edge * (kCentre + (kRadius + distance) * outward));
      if (!sample.in_band) continue;
      ++in_band;
      known_to = std::max(known_to, std::abs(distance));
      error = std::max(error, std::abs(sample.distance_mm / edge - distance));
      const double radians = std::atan2(sample.gradient.cross(outward).norm(), sample.gradient.dot(outward));
      angle = std::max(angle, radians * 180 / std::numbers::pi);
    }
    EXPECT_GT(in_band, 1000) << options.band;
    EXPECT_NEAR(known_to, options.band - 1, 0.02) << options.band;
    EXPECT_LT(error, 0.03) << options.band;
    EXPECT_LT(angle, 3) << options.band;
  }
}

TEST(PlaceSample, OutsideTheGridAndFarInsideNothingIsKnown) {
  for (const test::FieldOptions& options : {test::FieldOptions{}, test::trilinear_options()}) {
    const test::FieldImage image = ball(options);
    for (const double far : {-1e9, -30.0, 1e9}) {
      EXPECT_FALSE(sample_place(image.view(), Vector3d(0, 0, far)).in_band) << far;
    }
    EXPECT_FALSE(sample_place(image.view(), to_double(image.view().origin) + to_double(image.view().edge) * kCentre).in_band);
  }
}

}  // namespace
}  // namespace isotouch::trace
