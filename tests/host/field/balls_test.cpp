#include "host/field/balls.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <string>

#include "host/cloud/read_cloud.h"
#include "host/cloud/shapes.h"

namespace isotouch::field {
namespace {

/// Equal to the last bit, and something was compared.
void expect_same_radii(const cloud::OrientedPoints& points, const std::string& name) {
  const auto slow = packing_radii_brute_force(points);
  const auto quick = packing_radii(points);
  ASSERT_EQ(slow.size(), points.size());
  ASSERT_EQ(quick.size(), points.size());
  ASSERT_GT(points.size(), 0U);
  for (std::size_t i = 0; i < points.size(); ++i) ASSERT_EQ(slow[i], quick[i]) << name << ", point " << i;
}

cloud::OrientedPoints pair_above_each_other(double gap) {
  return {{{0.0, 0.0, 0.0}, {0.0, 0.0, -gap}}, {{0.0, 0.0, 1.0}, {0.0, 0.0, -1.0}}};
}

TEST(PackingRadii, TouchTheOppositeSideOfAThinWall) {
  const auto radii = packing_radii_brute_force(pair_above_each_other(4.0));
  EXPECT_DOUBLE_EQ(radii[0], 2.0);
  EXPECT_DOUBLE_EQ(radii[1], 2.0);
}

TEST(PackingRadii, FollowTheFormula) {
  // a = (3, 0, -1): |a|² = 10, depth 1, radius 5. From there a = (-3, 0, 1) lies above the plane of the second point: no ball.
  const cloud::OrientedPoints points{{{0.0, 0.0, 0.0}, {3.0, 0.0, -1.0}}, {{0.0, 0.0, 1.0}, {0.0, 0.0, 1.0}}};
  const auto radii = packing_radii_brute_force(points);
  EXPECT_DOUBLE_EQ(radii[0], 5.0);
  EXPECT_EQ(radii[1], std::numeric_limits<double>::infinity());
  expect_same_radii(points, "two points");
}

TEST(PackingRadii, AreThoseOfTheSphere) {
  const auto points = cloud::sample_shape(cloud::shape("sphere"), 300);
  for (const double r : packing_radii(points)) EXPECT_NEAR(r, 80.0, 1e-9);
}

TEST(PackingRadii, OfACoplanarPatchAreInfinite) {
  cloud::OrientedPoints points;
  for (int i = 0; i < 20; ++i) {
    points.positions.emplace_back(i % 5, i / 5, 0.0);
    points.normals.emplace_back(0.0, 0.0, 1.0);
  }
  expect_same_radii(points, "patch");
  EXPECT_EQ(packing_radii(points)[7], std::numeric_limits<double>::infinity());
}

TEST(PackingRadii, ShrinkingBallsGiveTheBruteForceRadiiOnTheShapes) {
  for (const char* name : {"sphere", "torus", "box", "plate", "capsules"})
    expect_same_radii(cloud::sample_shape(cloud::shape(name), 1200), name);
}

TEST(PackingRadii, ShrinkingBallsGiveTheBruteForceRadiiOnScans) {
  const char* folder = std::getenv("ISOTOUCH_DATA");
  if (folder == nullptr) GTEST_SKIP() << "ISOTOUCH_DATA is not set";
  for (const char* name : {"penguin", "wingnut", "bunny_scan_badnormals"}) {
    cloud::CloudReport report;
    expect_same_radii(cloud::read_cloud(std::filesystem::path(folder) / "clouds" / (std::string(name) + ".ply"), report), name);
  }
}

}  // namespace
}  // namespace isotouch::field
