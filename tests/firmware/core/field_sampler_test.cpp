#include "firmware/core/field_sampler.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/accuracy.h"
#include "tests/support/field_image.h"
#include "tests/support/reference.h"

namespace isotouch::core {
namespace {

using test::FieldImage;
using test::Point;
using test::Random;

class FieldSampler : public testing::TestWithParam<Interpolation> {
 protected:
  bool is_spline() const { return GetParam() == Interpolation::kSpline; }

  FieldImage sphere_field() const {
    return FieldImage({40, 36, 44},
                      [](const Point& p) {
                        return test::length(p - Point{19.3, 17.8, 21.6}) - 10.0;
                      },
                      {.prefilter = is_spline(), .interpolation = GetParam()});
  }

  /// The worst that a checked field can hold: every coefficient anywhere in ±7.9 voxels.
  FieldImage wild_field() const {
    Random random(5);
    return FieldImage({32, 32, 32}, [&random](const Point&) { return random.uniform(-7.9, 7.9); },
                      {.band = 7.9, .prefilter = false, .interpolation = GetParam()});
  }
};

INSTANTIATE_TEST_SUITE_P(Both, FieldSampler, testing::Values(Interpolation::kSpline, Interpolation::kTrilinear),
                         [](const auto& of) { return of.param == Interpolation::kSpline ? "Spline" : "Trilinear"; });

struct Worst {
  double distance = 0, gradient = 0, second = 0;
};

Worst compare_with_twin(const FieldView& field, int points, std::uint64_t seed) {
  Random random(seed);
  Worst worst;
  for (int i = 0; i < points; ++i) {
    Point p;
    for (std::size_t axis = 0; axis < 3; ++axis) p[axis] = random.uniform(1.0, field.size[axis] - 2.001);
    if (i % 4 == 0) p[0] = std::floor(p[0]) + 0.5;  // where the nearest sample changes
    if (i % 4 == 1) p[1] = std::floor(p[1]);        // where the cell between samples changes
    const FieldSample sample = sample_field(field, test::to_voxel(p));
    const test::ReferenceSample twin = test::reference_sample(field, test::to_point(test::to_voxel(p)));
    worst.distance = std::max(worst.distance, std::abs(test::to_double(sample.distance) - twin.distance));
    const std::array<std::int32_t, 9> got = {sample.gradient.x.raw(), sample.gradient.y.raw(), sample.gradient.z.raw(),
                                             sample.second.x.raw(),   sample.second.y.raw(),   sample.second.z.raw(),
                                             sample.mixed.x.raw(),    sample.mixed.y.raw(),    sample.mixed.z.raw()};
    for (std::size_t c = 0; c < 3; ++c) {
      worst.gradient = std::max(worst.gradient, std::abs(got[c] / 65536.0 - twin.gradient[c]));
      worst.second = std::max(worst.second, std::abs(got[c + 3] / 65536.0 - twin.second[c]));
      worst.second = std::max(worst.second, std::abs(got[c + 6] / 65536.0 - twin.mixed[c]));
    }
  }
  return worst;
}

TEST_P(FieldSampler, AgreesWithItsTwinOnASphere) {
  const FieldImage image = sphere_field();
  const Worst worst = compare_with_twin(image.view(), 20000, 1);
  EXPECT_THAT(worst.distance, test::IsAccuracyOf(1.0 / (1 << 16)));
  EXPECT_THAT(worst.gradient, test::IsAccuracyOf(1.0 / (1 << 16)));
  EXPECT_THAT(worst.second, test::IsAccuracyOf(1.0 / (1 << 16)));
}

TEST_P(FieldSampler, AgreesWithItsTwinOnTheWildestCoefficients) {
  const FieldImage image = wild_field();
  const Worst worst = compare_with_twin(image.view(), 20000, 2);
  EXPECT_THAT(worst.distance, test::IsAccuracyOf(1.0 / (1 << 16)));
  EXPECT_THAT(worst.gradient, test::IsAccuracyOf(1.0 / (1 << 16)));
  EXPECT_THAT(worst.second, test::IsAccuracyOf(1.0 / (1 << 16)));
}

TEST_P(FieldSampler, ValueAndGradientAreContinuousAcrossCells) {
  const FieldImage image = wild_field();
  Random random(3);
  for (int i = 0; i < 5000; ++i) {
    Point p = random.in_box(13.0) + Point{15.5, 15.5, 15.5};
    p[1] = std::floor(p[1]) + (is_spline() ? 0.5 : 0.0);  // the border of a cell
    Vec3<Voxel> before = test::to_voxel(p), after = before;
    before.y = Voxel::from_raw(before.y.raw() - 1);
    const FieldSample a = sample_field(image.view(), before), b = sample_field(image.view(), after);
    // one step of 2^-16 voxel, slopes to 16, curvatures to 32: 2^-11 at most, plus the sampler's own error
    EXPECT_NEAR(test::to_double(a.distance), test::to_double(b.distance), 16.0 / 65536 + 1.0 / (1 << 13));
    EXPECT_NEAR(a.gradient.x.raw() / 65536.0, b.gradient.x.raw() / 65536.0, 32.0 / 65536 + 1.0 / (1 << 12));
    EXPECT_NEAR(a.gradient.y.raw() / 65536.0, b.gradient.y.raw() / 65536.0, 32.0 / 65536 + 1.0 / (1 << 12));
  }
}

TEST_P(FieldSampler, OutsideTheGridItIsTheBorderAndSaysSo) {
  const FieldImage image = sphere_field();
  for (const Point& p : {Point{-50, 10, 10}, Point{10, 8000, 10}, Point{10, 10, -8000}, Point{0.5, 10, 10}, Point{38.5, 10, 10}}) {
    const FieldSample sample = sample_field(image.view(), test::to_voxel(p));
    EXPECT_TRUE(sample.outside_grid);
    EXPECT_EQ(sample.distance, Voxel::of(4.0));
    EXPECT_EQ(sample.gradient, Vec3<Slope>{});
  }
  EXPECT_FALSE(sample_field(image.view(), test::to_voxel({1.0, 1.0, 1.0})).outside_grid);
  EXPECT_FALSE(sample_field(image.view(), test::to_voxel({38.0, 34.0, 42.0})).outside_grid);
}

TEST_P(FieldSampler, BeyondTheBandThereIsNoGradient) {
  const FieldImage image = sphere_field();
  const FieldSample inside = sample_field(image.view(), test::to_voxel({19.3, 17.8, 21.6}));
  EXPECT_EQ(inside.distance, Voxel::of(-4.0));
  EXPECT_EQ(inside.gradient, Vec3<Slope>{});
}

}  // namespace
}  // namespace isotouch::core
