#include "host/motion/felt_surface.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/field_image.h"

namespace isotouch::motion {
namespace {

constexpr double kVoxel = 0.34;
constexpr double kRadius = 20 * kVoxel;
const Eigen::Vector3d kCentre = Eigen::Vector3d(30.2, 29.7, 30.4) * kVoxel - Eigen::Vector3d::Constant(20);

const FieldView& ball() {
  static const test::FieldImage image({61, 61, 61}, [](const test::Point& p) {
    return std::sqrt((p[0] - 30.2) * (p[0] - 30.2) + (p[1] - 29.7) * (p[1] - 29.7) + (p[2] - 30.4) * (p[2] - 30.4)) - 20;
  });
  return image.view();
}

TEST(FeltSurface, SamplesInMillimetres) {
  const FeltSurface surface(ball());
  for (const double outside : {-0.9, -0.3, 0.0, 0.4, 1.0}) {
    const Eigen::Vector3d way = Eigen::Vector3d(2, -1, 0.5).normalized();
    const FeltSample sample = surface.sample(kCentre + (kRadius + outside) * way);
    EXPECT_NEAR(sample.distance, outside, 0.002);
    EXPECT_LT((sample.gradient - way).norm(), 0.01);
    EXPECT_NEAR(sample.curvature, std::sqrt(2.0) / (20 + outside / kVoxel), 0.015);  // two curvatures of one over the radius
  }
}

TEST(FeltSurface, AWayFromOutsideMeetsTheSurfaceOnce) {
  const FeltSurface surface(ball());
  const Eigen::Vector3d way = Eigen::Vector3d(-1, 2, 3).normalized();
  const auto hit = surface.first_hit(kCentre - 30 * way, way, 60);
  ASSERT_TRUE(hit.has_value());
  EXPECT_LT((hit->position - (kCentre - kRadius * way)).norm(), 0.002);
  EXPECT_LT((hit->normal + way).norm(), 0.01);
  EXPECT_NEAR(surface.way_out(hit->position + 0.1 * way, way, 60), 2 * kRadius - 0.1, kVoxel);
  EXPECT_FALSE(surface.first_hit(kCentre - 30 * way, -way, 60).has_value());
  EXPECT_FALSE(surface.first_hit(kCentre, way, 60).has_value()) << "it only leaves";
}

TEST(FeltSurface, ProjectsFromBothSidesAndRefusesBeyondTheBand) {
  const FeltSurface surface(ball());
  const Eigen::Vector3d way = Eigen::Vector3d(0.3, 0.9, -0.4).normalized();
  for (const double outside : {-1.0, 0.7}) {
    const auto foot = surface.project(kCentre + (kRadius + outside) * way);
    ASSERT_TRUE(foot.has_value());
    EXPECT_LT((foot->position - (kCentre + kRadius * way)).norm(), 0.01);
  }
  EXPECT_FALSE(surface.project(kCentre).has_value());
}

}  // namespace
}  // namespace isotouch::motion
