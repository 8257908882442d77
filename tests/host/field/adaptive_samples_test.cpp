#include "host/field/adaptive_samples.h"

#include <gtest/gtest.h>

#include <cmath>

#include "host/cloud/random.h"
#include "host/cloud/shapes.h"
#include "host/field/surface.h"
#include "tests/support/accuracy.h"
#include "tests/support/sanitized.h"

namespace isotouch::field {
namespace {

using Eigen::Vector3d;

cloud::OrientedPoints scatter(const char* name, std::size_t count) { return cloud::scatter_on_shape(cloud::shape(name), count, 3); }

/// Root mean square distance of fresh points from the surface.
double rms_off(const AdaptiveSamples& samples, const char* name) {
  const Surface surface(*samples.scan, samples.models, kEverywhere);
  double sum = 0.0;
  const auto fresh = cloud::scatter_on_shape(cloud::shape(name), 2000, 4);
  for (const Vector3d& p : fresh.positions) sum += std::pow(surface.distance(p), 2);
  return std::sqrt(sum / static_cast<double>(fresh.size()));
}

TEST(AdaptiveSamples, TakesASmallCloudAsItIs) {
  const auto points = scatter("torus", 3000);
  const AdaptiveSamples samples = adaptive_samples(points);
  EXPECT_EQ(samples.scan->positions(), points.positions);
  EXPECT_EQ(samples.models.size(), points.size());
}

TEST(AdaptiveSamples, ARoundBodyNeedsNoMoreOfThemForMorePoints) {
  for (const char* name : test::examples<const char*>({"torus", "sphere", "box"})) {
    const AdaptiveSamples few = adaptive_samples(scatter(name, 40'000)), many = adaptive_samples(scatter(name, 200'000));
    EXPECT_LT(many.scan->size(), 10'000U) << name;
    EXPECT_LT(many.scan->size(), 5 * few.scan->size() / 4) << name;
    EXPECT_GT(many.scan->size(), 2'000U) << name;
    EXPECT_LT(rms_off(many, name), 0.005) << name;
  }
}

TEST(AdaptiveSamples, SetsMoreOfThemWhereAFineDetailIs) {
  // A bump of one voxel on a large sphere, three voxels wide.
  const Vector3d pole(0, 0, 80);
  auto points = scatter("sphere", 150'000);
  for (Vector3d& p : points.positions) {
    const double away = (p - pole).squaredNorm();
    if (away < 9.0) p.z() += std::pow(1.0 - away / 9.0, 2);
  }
  const AdaptiveSamples samples = adaptive_samples(points);
  std::size_t near = 0;
  for (const Vector3d& p : samples.scan->positions()) near += (p - pole).norm() < 4.0 ? 1U : 0U;
  EXPECT_GT(near, 25U);
  EXPECT_LT(samples.scan->size(), 10'000U);
}

TEST(AdaptiveSamples, FollowsAStiffnessThatChanges) {
  auto points = scatter("sphere", 60'000);
  for (const Vector3d& p : points.positions) points.stiffness.push_back(p.z() > 0.0 ? 1.0 : 0.5);
  const AdaptiveSamples samples = adaptive_samples(points);
  for (std::size_t i = 0; i < samples.scan->size(); ++i) {
    const double z = samples.scan->positions()[i].z();
    if (std::abs(z) > 1.0) {
      EXPECT_NEAR(samples.scan->stiffness()[i], z > 0.0 ? 1.0 : 0.5, 1e-9);
    }
  }
  EXPECT_LT(samples.scan->size(), 15'000U);
}

TEST(AdaptiveSamplesHeavy, ANoisyScanKeepsOneAVoxel) {
  auto points = scatter("torus", 60'000);
  cloud::Random random(9);
  for (std::size_t i = 0; i < points.size(); ++i) points.positions[i] += random.uniform(-0.3, 0.3) * points.normals[i];
  EXPECT_GT(adaptive_samples(points).scan->size(), 40'000U);
}

TEST(AdaptiveSamples, StrayNormalsAreOutvotedByTheirCell) {
  auto points = scatter("torus", 100'000);
  for (std::size_t i = 0; i < points.size(); i += 16) points.normals[i] = -points.normals[i];
  EXPECT_THAT(rms_off(adaptive_samples(points), "torus"), test::IsAccuracyOf(0.0005));
}

}  // namespace
}  // namespace isotouch::field
