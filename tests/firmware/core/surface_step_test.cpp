#include "firmware/core/surface_step.h"

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

/// Every curvature a real object has: a torus (saddle and bowl) beside a box (edges, corners).
FieldImage torus_and_box() {
  return FieldImage({72, 64, 40}, [](const Point& p) {
    const double ring = std::hypot(p[0] - 22.3, p[1] - 31.7) - 13.0;
    const double torus = std::hypot(ring, p[2] - 19.6) - 5.0;
    Point q = p - Point{54.2, 31.4, 19.8};
    for (std::size_t axis = 0; axis < 3; ++axis) q[axis] = std::abs(q[axis]) - 7.0;
    const double box =
        std::min(std::max({q[0], q[1], q[2]}), 0.0) + std::hypot(std::max(q[0], 0.0), std::max(q[1], 0.0), std::max(q[2], 0.0));
    return std::min(torus, box);
  });
}

Point step_from(const Vec3<Voxel>& point, const Vec3<Voxel>& hip, const FieldSample& sample, StepMemory& memory) {
  Vec3<Voxel> moved = point;
  step_towards(hip, sample, Ratio::of(1), memory, moved);
  return test::to_point(moved) - test::to_point(point);
}

TEST(SurfaceStep, AgreesWithItsTwinNearTheSurface) {
  const FieldImage image = torus_and_box();
  Random random(21);
  int compared = 0, behind = 0, long_steps = 0;
  double worst = 0, worst_foothold = 0;
  while (compared < 20000) {
    const Vec3<Voxel> point = test::to_voxel({random.uniform(4, 67), random.uniform(4, 59), random.uniform(4, 35)});
    const FieldSample sample = sample_field(image.view(), point);
    if (sample.distance > Voxel::of(1.5) || sample.distance < Voxel::of(-0.8)) continue;
    const Vec3<Voxel> hip = point + test::to_voxel(random.in_ball(8.0));
    const test::ReferenceSample exact = {
        test::to_double(sample.distance),
        {sample.gradient.x.raw() / 65536.0, sample.gradient.y.raw() / 65536.0, sample.gradient.z.raw() / 65536.0},
        {sample.second.x.raw() / 65536.0, sample.second.y.raw() / 65536.0, sample.second.z.raw() / 65536.0},
        {sample.mixed.x.raw() / 65536.0, sample.mixed.y.raw() / 65536.0, sample.mixed.z.raw() / 65536.0}};
    if (test::length(exact.gradient) < 0.2) continue;  // the twin has no tangent plane there
    const Point pull = test::to_point(hip) - test::to_point(point);
    if (std::abs(exact.distance + test::dot(exact.gradient, pull)) < 0.001) continue;  // on the border between free and held
    StepMemory fresh;
    const Point step = step_from(point, hip, sample, fresh);
    const Point twin = test::reference_step(pull, exact);
    worst = std::max(worst, test::length(step - twin));
    SurfaceProjection projection;
    project_on_surface(hip, point, sample, projection);
    const double twin_square = std::max(test::dot(exact.gradient, exact.gradient), 1.0 / 64);
    worst_foothold =
        std::max(worst_foothold, test::length(test::to_point(projection.step) + exact.gradient * (exact.distance / twin_square)));
    EXPECT_EQ(projection.hip_behind, exact.distance + test::dot(exact.gradient, pull) < 0);
    behind += projection.hip_behind ? 1 : 0;
    long_steps += test::length(twin) > 1.0 ? 1 : 0;
    ++compared;
  }
  // 16 fraction bits, curvature times a depth of up to 40 voxels: a few thousandths of a voxel at worst
  EXPECT_THAT(worst, test::IsAccuracyOf(0.004));
  EXPECT_THAT(worst_foothold, test::IsAccuracyOf(0.00006));
  EXPECT_GT(behind, 5000);
  EXPECT_GT(long_steps, 5000);
}

TEST(SurfaceStep, InFreeSpaceReachesTheHipExactly) {
  const FieldImage image = torus_and_box();
  const Vec3<Voxel> point = test::to_voxel({5.0, 5.0, 5.0}), hip = test::to_voxel({6.123, 4.517, 5.902});
  StepMemory memory;
  Vec3<Voxel> moved = point;
  step_towards(hip, sample_field(image.view(), point), Ratio::of(1), memory, moved);
  EXPECT_EQ(moved, hip);
}

TEST(SurfaceStep, IsNeverLongerThanTheDistanceAndTheSlide) {
  const FieldImage image = torus_and_box();
  Random random(22);
  for (int i = 0; i < 20000; ++i) {
    const Vec3<Voxel> point = test::to_voxel({random.uniform(2, 69), random.uniform(2, 61), random.uniform(2, 37)});
    const FieldSample sample = sample_field(image.view(), point);
    if (sample.distance < Voxel{}) continue;
    const Vec3<Voxel> hip = point + test::to_voxel(random.in_ball(300.0));
    StepMemory memory;
    EXPECT_LT(test::length(step_from(point, hip, sample, memory)), test::to_double(sample.distance) + 1.2501);
  }
}

TEST(SurfaceStep, WhereTheFieldIsSteepItCoversNoMoreThanIsSurelyFree) {
  const FieldImage image({72, 64, 40},
                         [](const Point& p) {
                           return 2 * (test::length(p - Point{36, 32, 20}) - 9.0);
                         },
                         {.largest_slope = 2.5});
  ASSERT_NEAR(image.view().inverse_slope.raw(), (1 << 30) / 2.5, 2000.0);
  Random random(24);
  double longest = 0;
  for (int i = 0; i < 20000; ++i) {
    const Vec3<Voxel> point = test::to_voxel({random.uniform(2, 69), random.uniform(2, 61), random.uniform(2, 37)});
    const FieldSample sample = sample_field(image.view(), point);
    if (sample.distance < Voxel{}) continue;
    StepMemory memory;
    Vec3<Voxel> moved = point;
    step_towards(point + test::to_voxel(random.in_ball(300.0)), sample, image.view().inverse_slope, memory, moved);
    const double beyond = test::length(test::to_point(moved) - test::to_point(point)) - test::to_double(sample.distance) / 2.5;
    EXPECT_LT(beyond, 1.2501);
    longest = std::max(longest, beyond);
  }
  EXPECT_GT(longest, 1.24);
}

TEST(SurfaceStep, SurvivesTheWildestField) {
  Random random(23);
  const FieldImage image({32, 32, 32}, [&random](const Point&) { return random.uniform(-7.9, 7.9); }, {.band = 7.9, .prefilter = false});
  for (int i = 0; i < 50000; ++i) {  // the undefined-behaviour sanitizer judges the arithmetic
    const Vec3<Voxel> point = test::to_voxel({random.uniform(1, 30), random.uniform(1, 30), random.uniform(1, 30)});
    const Vec3<Voxel> hip = test::to_voxel(random.in_box(i % 2 == 0 ? 8191.0 : 30.0));
    StepMemory memory;
    const Point step = step_from(point, hip, sample_field(image.view(), point), memory);
    EXPECT_LT(test::length(step), 20.0);
  }
}

}  // namespace
}  // namespace isotouch::core
