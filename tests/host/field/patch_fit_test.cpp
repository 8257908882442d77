#include "host/field/patch_fit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "host/cloud/random.h"

namespace isotouch::field {
namespace {

using Eigen::Vector3d;

constexpr double kReach = 6.0;

/// Twelve samples round the outermost point of a torus; with equal radii it is a sphere.
std::vector<WeightedSample> torus_samples(double ring, double tube, double noise = 0.0) {
  cloud::Random random(5);
  std::vector<WeightedSample> samples;
  for (int i = 0; i <= 12; ++i) {
    const double a = i == 0 ? 0 : random.uniform(-4, 4) / (ring + tube), b = i == 0 ? 0 : random.uniform(-4, 4) / tube;
    const Vector3d n(std::sin(a) * std::cos(b), std::sin(b), std::cos(a) * std::cos(b));
    const Vector3d p = ring * Vector3d(std::sin(a), 0, std::cos(a)) + tube * n - Vector3d(0, 0, ring + tube);
    const Vector3d shake(random.uniform(-noise, noise), random.uniform(-noise, noise), random.uniform(-noise, noise));
    samples.push_back({p, (n + shake).normalized(), i == 0 ? 1.0 : 0.6});
  }
  return samples;
}

TEST(FitPatch, OfOneSampleIsItsTangentPlane) {
  const WeightedSample only[] = {{{1, 2, 3}, {0, 0, 1}, 1.0}};
  EXPECT_DOUBLE_EQ(fit_patch(only, 1.0).distance({5, -4, 3.5}), 0.5);
}

TEST(FitPatch, FindsASphere) {
  const auto patch = fit_patch(torus_samples(0, 20), kReach);
  EXPECT_NEAR(patch.gentle, 0.05, 5e-5);
  EXPECT_NEAR(patch.tight, 0.05, 5e-5);
  EXPECT_NEAR(patch.point.norm(), 0, 1e-4);
}

TEST(FitPatch, FindsATorusToThirdOrder) {
  const auto patch = fit_patch(torus_samples(70, 25), kReach);
  EXPECT_NEAR(patch.gentle, 1.0 / 95, 5e-4);
  EXPECT_NEAR(patch.tight, 1.0 / 25, 5e-4);
  EXPECT_NEAR(std::abs(patch.along.y()), 1, 1e-3);
}

TEST(FitPatch, TakesTheNoiseOfItsOwnNormalBack) {
  auto samples = torus_samples(0, 30);
  const double tilt = 0.1;
  samples[0].normal = Vector3d(std::sin(tilt), 0, std::cos(tilt));
  const auto patch = fit_patch(samples, kReach);
  EXPECT_LT(std::acos(patch.normal.z()), 0.7 * tilt);
}

TEST(FitPatch, FrameStaysOrthonormal) {
  const auto patch = fit_patch(torus_samples(10, 8, 0.2), kReach);
  EXPECT_NEAR(patch.normal.norm(), 1, 1e-12);
  EXPECT_NEAR(patch.across.norm(), 1, 1e-12);
  EXPECT_NEAR(patch.along.norm(), 1, 1e-12);
  EXPECT_NEAR(patch.normal.dot(patch.across), 0, 1e-12);
  EXPECT_NEAR(patch.normal.dot(patch.along), 0, 1e-12);
  EXPECT_NEAR(patch.across.dot(patch.along), 0, 1e-12);
  EXPECT_LE(std::abs(patch.gentle), std::abs(patch.tight));
}

}  // namespace
}  // namespace isotouch::field
