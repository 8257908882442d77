#include "host/view/scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "host/view/light.h"
#include "tests/host/view/sphere_field.h"

namespace isotouch::view {
namespace {

constexpr int kWidth = 200, kHeight = 160;

struct SphereScene {
  SphereField field;
  FieldRays rays{field.view};
  Camera camera{Eigen::Vector3d::UnitZ(), Eigen::Vector3d::UnitY(), corners(), {0, 0, kWidth, kHeight}};
  Image image{kWidth, kHeight, {9, 9, 9}};

  static std::vector<Eigen::Vector3d> corners() { return {Eigen::Vector3d::Constant(-12), Eigen::Vector3d::Constant(12)}; }
  void draw(std::optional<Markers> markers = {}, std::optional<CutPlane> cut = {}) {
    image = scene_image({0, 0, kWidth, kHeight}, {rays, camera, markers, cut}, 0.5F);
  }
  const Colour& at(const Eigen::Vector3d& point) const {
    const auto seen = camera.project(point);
    return image.at(static_cast<int>(seen.x), static_cast<int>(seen.y));
  }
};

float brightness(const Colour& c) { return c.r + c.g + c.b; }

TEST(Scene, SilhouetteOfTheSphereHasItsArea) {
  SphereScene scene;
  scene.draw();
  double covered = 0;
  for (int y = 0; y < kHeight; ++y) {
    const Colour behind = backdrop(static_cast<float>(y) / kHeight);
    for (int x = 0; x < kWidth; ++x) {
      const Colour c = scene.image.at(x, y);
      covered += std::fabs(brightness(c) - brightness(behind)) > 0.02F ? 1 : 0;
    }
  }
  const auto middle = scene.camera.project(Eigen::Vector3d::Zero());
  const double angle = std::asin(kTestRadius / middle.distance);
  const double radius = middle.pixel_per_mm * middle.distance * std::tan(angle);
  EXPECT_NEAR(std::sqrt(covered / std::numbers::pi), radius, 0.6);  // pixels on the rim count whole
}

TEST(Scene, TheLampIsAboveOnTheLeft) {
  SphereScene scene;
  scene.draw();
  const double r = kTestRadius * 0.7;
  const float upper_left = brightness(scene.at({-r * 0.6, r * 0.6, r})), lower_right = brightness(scene.at({r * 0.6, -r * 0.6, r}));
  EXPECT_GT(upper_left, 1.5F * lower_right);
  EXPECT_GT(lower_right, 0.1F);
}

TEST(Scene, MarkersAreSeenInFrontAndThroughTheSurface) {
  SphereScene scene;
  const Touch touch{.proxy = {0, 0, kTestRadius}, .hip = {3, 0, kTestRadius - 3}, .force = {0, 1, 0}};
  scene.draw(Markers(touch, 0.8, 5));
  const Colour proxy = scene.at(touch.proxy), hip = scene.at(touch.hip), plain = scene.at({0, -5, 5}),
               arrow = scene.at({0, 4, kTestRadius});
  EXPECT_GT(proxy.b, 2 * proxy.r);
  EXPECT_GT(hip.r, 1.5F * hip.b);
  EXPECT_GT(hip.b, 0.03F) << "the surface before it should still be seen";
  EXPECT_LT(std::fabs(plain.r - plain.g), 0.2F * plain.g);
  EXPECT_LT(brightness(arrow), 0.5F * brightness(plain));
}

TEST(Scene, CutShowsTheInsideWithLinesAVoxelApart) {
  SphereScene scene;
  scene.draw({}, CutPlane{Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitZ()});
  const Colour face = scene.at({0, 0, 0});
  EXPECT_GT(face.r, face.b) << "the cut is warm";
  // Along a radius the face gets darker at depths of 1, 2 and 3 voxels and is plain between them.
  for (const double depth : {1.0, 2.0, 3.0}) {
    const double on = kTestRadius - depth * kTestEdge, beside = on + kTestEdge / 2;
    EXPECT_LT(brightness(scene.at({on, 0, 0})), brightness(scene.at({beside, 0, 0}))) << depth;
  }
}

}  // namespace
}  // namespace isotouch::view
