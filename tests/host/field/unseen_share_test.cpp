#include "host/field/unseen_share.h"

#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "host/cloud/shapes.h"
#include "host/field/make_grid.h"
#include "host/field/sample_distance.h"

namespace isotouch::field {
namespace {

using Eigen::Vector3d;

constexpr double kRadius = 20.0;

BandField ball() {
  const Grid grid = make_grid(Vector3d::Constant(-kRadius), Vector3d::Constant(kRadius), 0.5, kBand + 3);
  return sample_distance([](const Vector3d& p) { return p.norm() - kRadius; }, grid, kBand);
}

std::vector<Vector3d> seen(double lowest) {
  const cloud::OrientedPoints sphere = cloud::sample_shape(cloud::shape("sphere"), 3000);
  std::vector<Vector3d> points;
  for (const Vector3d& p : sphere.positions) {
    if (p.normalized().z() > lowest) points.push_back(kRadius * p.normalized());
  }
  return points;
}

TEST(UnseenShare, IsNothingWherePointsAreEverywhere) {
  const std::array<double, 2> shares = unseen_shares(ball(), seen(-2.0), {3.0, 1.5});
  EXPECT_EQ(shares[0], 0.0);
  EXPECT_LT(shares[1], 0.001);
}

TEST(UnseenShare, IsThePartWithoutPointsLessItsRim) {
  // Below z = -0.5 of a unit sphere lies a quarter of its area; the rim takes a few spacings of it.
  const std::array<double, 2> shares = unseen_shares(ball(), seen(-0.5), {3.0, 1.5});
  EXPECT_LT(shares[0], shares[1]);
  EXPECT_GT(shares[0], 0.12);
  EXPECT_LT(shares[1], 0.25);
}

TEST(UnseenShare, OfNoSurfaceIsNothing) {
  BandField empty = ball();
  empty.bricks.clear();
  EXPECT_EQ(unseen_shares(empty, seen(-2.0), {3.0, 1.5})[1], 0.0);
}

}  // namespace
}  // namespace isotouch::field
