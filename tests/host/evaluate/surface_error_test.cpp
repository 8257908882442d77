#include "host/evaluate/surface_error.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "host/cloud/random.h"
#include "host/error.h"
#include "tests/support/accuracy.h"
#include "tests/support/field_image.h"

namespace isotouch::evaluate {
namespace {

constexpr double kVoxel = 0.34;

/// Points around a ball of `radius` voxels, centre (40.2, 39.7, 40.4).
cloud::OrientedPoints around(double radius, std::size_t count) {
  cloud::OrientedPoints points;
  cloud::Random random(3);
  while (points.size() < count) {
    Eigen::Vector3d way;
    for (double& coordinate : way) coordinate = random.uniform(-1, 1);
    if (way.norm() < 0.1) continue;
    way.normalize();
    points.normals.push_back(way);
    points.positions.push_back(kVoxel * (Eigen::Vector3d(40.2, 39.7, 40.4) + radius * way) - Eigen::Vector3d::Constant(20));
  }
  return points;
}

const FieldView& ball() {
  static const test::FieldImage image({81, 81, 81}, [](const test::Point& p) {
    return std::sqrt((p[0] - 40.2) * (p[0] - 40.2) + (p[1] - 39.7) * (p[1] - 39.7) + (p[2] - 40.4) * (p[2] - 40.4)) - 30;
  });
  return image.view();
}

TEST(SurfaceError, IsTheFloorOnTheSurfaceItself) {
  const SurfaceError error = surface_error(ball(), around(30, 2000));
  EXPECT_EQ(error.points, 2000U);
  EXPECT_EQ(error.lost, 0U);
  EXPECT_THAT(error.rms_voxel, test::IsAccuracyOf(0.000055));
  EXPECT_THAT(error.normal_rms_deg, test::IsAccuracyOf(0.0056));
}

TEST(SurfaceError, AKnownOffsetIsMeasuredOnBothSides) {
  for (const double offset : {-1.9, -0.5, 0.25, 1.9}) {
    const SurfaceError error = surface_error(ball(), around(30 + offset, 500));
    EXPECT_NEAR(error.rms_voxel, std::abs(offset), 0.001);
    EXPECT_NEAR(error.max_voxel, std::abs(offset), 0.002);
    EXPECT_NEAR(error.p99_voxel, std::abs(offset), 0.002);
    EXPECT_NEAR(error.rms_mm, std::abs(offset) * kVoxel, 0.001);
  }
}

TEST(SurfaceError, PointsWithoutACrossingAreLostAndEnterNothingElse) {
  cloud::OrientedPoints points = around(30, 300);
  const cloud::OrientedPoints far = around(32.2, 100);
  points.positions.insert(points.positions.end(), far.positions.begin(), far.positions.end());
  points.normals.insert(points.normals.end(), far.normals.begin(), far.normals.end());
  const SurfaceError error = surface_error(ball(), points);
  EXPECT_EQ(error.lost, 100U);
  EXPECT_EQ(error.points, 300U);
  EXPECT_THAT(error.max_voxel, test::IsAccuracyOf(0.00014));
}

TEST(SurfaceError, ACrossingInTheWrongDirectionIsNone) {
  cloud::OrientedPoints turned = around(30, 100);
  for (Eigen::Vector3d& normal : turned.normals) normal = -normal;
  EXPECT_THROW((void)surface_error(ball(), turned), InputError);
}

// A trilinear gradient is made of central differences: between walls and gaps of one voxel each there is none.
TEST(SurfaceError, WhereTheFieldHasNoNormalItHasNoGoodOne) {
  const auto comb = [](const test::Point& p) {
    const bool within = std::max({std::abs(p[0] - 12), std::abs(p[1] - 12), std::abs(p[2] - 12)}) < 4.5;
    return !within ? 100.0 : std::lround(p[0]) % 2 == 1 ? -1.0 : 1.0;
  };
  const test::FieldImage image({25, 25, 25}, comb, test::trilinear_options());
  cloud::OrientedPoints points;
  for (double y = 10; y < 14; y += 0.3) {
    points.positions.push_back(kVoxel * Eigen::Vector3d(11.5, y, 11.4) - Eigen::Vector3d::Constant(20));
    points.normals.emplace_back(Eigen::Vector3d::UnitX());
  }
  EXPECT_EQ(surface_error(image.view(), points).normal_rms_deg, 180);
}

TEST(SurfaceError, NothingComparedIsAFailure) { EXPECT_THROW((void)surface_error(ball(), {}), InputError); }

}  // namespace
}  // namespace isotouch::evaluate
