#include "host/field/unseen_share.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "host/cloud/shapes.h"
#include "host/field/invented_surface.h"
#include "host/field/make_grid.h"
#include "host/field/sample_distance.h"

namespace isotouch::field {
namespace {

using Eigen::Vector3d;

constexpr double kRadius = 20.0;

BandField ball() {
  const Grid grid = make_grid(Vector3d::Constant(-kRadius), Vector3d::Constant(kRadius), 1.0, kBand + 3);
  return sample_distance([](const Vector3d& p) { return p.norm() - kRadius; }, grid, kBand);
}

cloud::OrientedPoints seen(double lowest) {
  const cloud::OrientedPoints sphere = cloud::sample_shape(cloud::shape("sphere"), 3000);
  cloud::OrientedPoints points;
  for (const Vector3d& p : sphere.positions) {
    if (p.normalized().z() <= lowest) continue;
    points.positions.push_back(kRadius * p.normalized());
    points.normals.push_back(p.normalized());
  }
  return points;
}

TEST(UnseenShare, IsNothingWherePointsAreEverywhere) {
  EXPECT_EQ(unseen_share(ball(), Spacings(seen(-2.0)), 3.0), 0.0);
  EXPECT_LT(unseen_share(ball(), Spacings(seen(-2.0)), kGap), 0.001);
}

TEST(UnseenShare, IsThePartWithoutPointsLessItsRim) {
  // Below z = -0.5 of a unit sphere lies a quarter of its area. A point's sixth neighbour is 1.9 mm away, at the rim 2.7 mm: the limits take 7 to 9 mm
  // and 4 to 5 mm of that.
  EXPECT_NEAR(unseen_share(ball(), Spacings(seen(-0.5)), 3.0), 0.10, 0.02);
  EXPECT_NEAR(unseen_share(ball(), Spacings(seen(-0.5)), kGap), 0.16, 0.02);
}

TEST(UnseenShare, OfAWallIsTheSideWithoutPoints) {
  constexpr double kInner = kRadius - 2.0;  // as far as the points are apart
  const BandField wall =
      sample_distance([](const Vector3d& p) { return std::max(p.norm() - kRadius, kInner - p.norm()); }, ball().grid, kBand);
  const cloud::OrientedPoints outside = seen(-2.0);
  const Spacings spacings(outside);
  const double inner = kInner * kInner / (kInner * kInner + kRadius * kRadius);
  EXPECT_NEAR(unseen_share(wall, spacings, kGap), inner, 0.01);
  EXPECT_EQ(unseen_share(wall, spacings, kGap, Showing::kAny), 0.0) << "the points outside are as near";
  SoundScan sound;
  sound.points = outside;
  sound.measured = outside.size();
  EXPECT_NEAR(invented_surface(wall, sound, spacings).share, inner, 0.1) << "a brick may hold both sides, and is judged once";
}

TEST(UnseenShare, OfACavityThatTheSignAloneMakesIsItsSurface) {
  constexpr double kCavity = 8.0, kDeep = 2.5;  // no sample is nearer to the cavity's surface than that
  const auto with_cavity = [](const Vector3d& p) { return p.norm() < kCavity ? kDeep : std::max(p.norm() - kRadius, -kDeep); };
  const BandField body = sample_distance(with_cavity, ball().grid, kBand);
  const double share = kCavity * kCavity / (kCavity * kCavity + kRadius * kRadius);
  const cloud::OrientedPoints outside = seen(-2.0);
  const Spacings spacings(outside);
  EXPECT_NEAR(unseen_share(body, spacings, kGap), share, 0.02);
  SoundScan sound;
  sound.points = outside;
  sound.measured = outside.size();
  const InventedSurface invented = invented_surface(body, sound, spacings);
  EXPECT_NEAR(invented.share, share, 0.02);
  const auto within = [&](const Eigen::Vector3i& cell) {
    return (body.grid.position(4 * cell) + 1.5 * body.grid.edge * Vector3d::Ones()).norm() < kCavity + 3.0;
  };
  EXPECT_TRUE(std::all_of(invented.cells.begin(), invented.cells.end(), within));
}

TEST(UnseenShare, OfNoSurfaceIsNothing) {
  BandField empty = ball();
  empty.bricks.clear();
  EXPECT_EQ(unseen_share(empty, Spacings(seen(-2.0)), kGap), 0.0);
}

}  // namespace
}  // namespace isotouch::field
