#include "host/view/camera.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace isotouch::view {
namespace {

std::vector<Eigen::Vector3d> corners() {
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < 8; ++i) points.emplace_back((i & 1) != 0 ? 30 : -10, (i & 2) != 0 ? 12 : -8, (i & 4) != 0 ? 5 : -20);
  return points;
}

TEST(Direction, ZeroIsInFrontForEveryUpAxis) {
  EXPECT_TRUE((Direction{0, 0, 'y'}.towards_eye().isApprox(Eigen::Vector3d::UnitZ())));
  EXPECT_TRUE((Direction{0, 0, 'z'}.towards_eye().isApprox(Eigen::Vector3d(-Eigen::Vector3d::UnitY()))));
  EXPECT_TRUE((Direction{0, 0, 'x'}.towards_eye().isApprox(Eigen::Vector3d::UnitZ())));
  EXPECT_TRUE((Direction{90, 0, 'y'}.towards_eye().isApprox(Eigen::Vector3d::UnitX())));
  EXPECT_TRUE((Direction{17, 90, 'z'}.towards_eye().isApprox(Eigen::Vector3d::UnitZ())));
}

TEST(Camera, SeesAllPointsAsLargeAsTheyFit) {
  const Rect area{40, 20, 600, 380};
  const auto points = corners();
  for (const Direction direction : {Direction{35, 20, 'y'}, Direction{-120, -40, 'z'}, Direction{0, 90, 'y'}}) {
    const Camera camera(direction.towards_eye(), direction.up_axis(), points, area);
    double left = 1e9, right = -1e9, top = 1e9, bottom = -1e9;
    for (const auto& p : points) {
      const auto seen = camera.project(p);
      EXPECT_GT(seen.distance, 0);
      left = std::min(left, seen.x - 40);
      right = std::max(right, seen.x - 40);
      top = std::min(top, seen.y - 20);
      bottom = std::max(bottom, seen.y - 20);
    }
    EXPECT_GE(left, 0);
    EXPECT_LE(right, 560);
    EXPECT_GE(top, 0);
    EXPECT_LE(bottom, 360);
    const bool fills_width = right - left > 0.94 * 560, fills_height = bottom - top > 0.94 * 360;
    EXPECT_TRUE(fills_width || fills_height);
    if (fills_width) {
      EXPECT_NEAR(left, 560 - right, 0.5);
    }
    if (fills_height) {
      EXPECT_NEAR(top, 360 - bottom, 0.5);
    }
  }
}

TEST(Camera, RayGoesThroughThePointThatIsProjectedThere) {
  const auto points = corners();
  const Camera camera(Direction{35, 20, 'y'}.towards_eye(), Eigen::Vector3d::UnitY(), points, {0, 0, 640, 480});
  for (const auto& p : points) {
    const auto seen = camera.project(p);
    const Ray ray = camera.ray(seen.x, seen.y);
    const double along = (p - ray.from).dot(ray.direction);
    EXPECT_LT((ray.at(along) - p).norm(), 1e-9);
  }
}

TEST(Camera, UpIsUpAndRightIsRight) {
  const std::vector<Eigen::Vector3d> points = {Eigen::Vector3d(-1, -1, 0), Eigen::Vector3d(1, 1, 0)};
  const Camera camera(Eigen::Vector3d::UnitZ(), Eigen::Vector3d::UnitY(), points, {0, 0, 100, 100});
  EXPECT_LT(camera.project({-1, 0, 0}).x, camera.project({1, 0, 0}).x);
  EXPECT_GT(camera.project({0, -1, 0}).y, camera.project({0, 1, 0}).y);
}

}  // namespace
}  // namespace isotouch::view
