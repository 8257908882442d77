#include "host/field/outliers.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>

#include "host/cloud/random.h"
#include "host/cloud/shapes.h"

namespace isotouch::field {
namespace {

using Eigen::Vector3d;

TEST(Connected, KeepsEverySampleOfASurface) {
  for (const char* name : {"sphere", "torus", "box", "plate", "capsules"}) {
    const auto points = cloud::sample_shape(cloud::shape(name), 1500);
    EXPECT_EQ(connected(Scan(points)).size(), points.size()) << name;
  }
}

TEST(Connected, KeepsTheSparsePartOfAnUnevenScan) {
  // At one pole of the sphere ten times as many as at the other.
  cloud::Random random(3);
  cloud::OrientedPoints points;
  const auto even = cloud::sample_shape(cloud::shape("sphere"), 6000);
  for (std::size_t i = 0; i < even.size(); ++i) {
    if (random.uniform() > std::pow(10.0, -(even.positions[i].z() + 80.0) / 160.0)) continue;
    points.positions.push_back(even.positions[i]);
    points.normals.push_back(even.normals[i]);
  }
  EXPECT_EQ(connected(Scan(points)).size(), points.size());
}

TEST(Connected, LeavesOutPointsStrewnInTheAir) {
  auto points = cloud::sample_shape(cloud::shape("torus"), 1500);
  const std::size_t sound = points.size();
  cloud::Random random(5);
  const cloud::Shape shape = cloud::shape("torus");
  while (points.size() < sound + 20) {
    const Vector3d place(260 * random.uniform() - 130, 260 * random.uniform() - 130, 260 * random.uniform() - 130);
    if (shape.distance(place) < 15.0) continue;
    points.positions.push_back(place);
    points.normals.push_back(Vector3d(random.uniform() - 0.5, random.uniform() - 0.5, random.uniform() - 0.5).normalized());
  }
  const auto kept = connected(Scan(points));
  ASSERT_EQ(kept.size(), sound);
  for (std::uint32_t i = 0; i < sound; ++i) EXPECT_EQ(kept[i], i);
}

/// Adds an even ball round the origin.
void add_ball(cloud::OrientedPoints& points, std::size_t count, double radius, double side) {
  for (std::size_t i = 0; i < count; ++i) {
    const double z = 1.0 - (2.0 * static_cast<double>(i) + 1.0) / static_cast<double>(count),
                 turn = 2.399963229728653 * static_cast<double>(i);
    const Vector3d way(std::sqrt(1.0 - z * z) * std::cos(turn), std::sqrt(1.0 - z * z) * std::sin(turn), z);
    points.positions.emplace_back(radius * way);
    points.normals.emplace_back(side * way);
  }
}

TEST(ConnectedSides, KeepsASparseSideOfAWall) {
  cloud::OrientedPoints hollow;
  add_ball(hollow, 8000, 30, 1);
  add_ball(hollow, 800, 27, -1);
  const Scan scan(hollow);
  ASSERT_EQ(connected(scan).size(), 8000U) << "the inner side seems to be strays";
  const Sides sides = connected_sides(scan);
  ASSERT_EQ(sides.samples.size(), hollow.size());
  for (std::uint32_t i = 0; i < hollow.size(); ++i) EXPECT_EQ(sides.samples[i], i);
  EXPECT_EQ(sides.sparse, 800U);
}

TEST(ConnectedSides, LeavesOutAnotherLayerOfASurface) {
  cloud::OrientedPoints layers;
  add_ball(layers, 8000, 30, 1);
  add_ball(layers, 800, 27, 1);
  EXPECT_EQ(connected_sides(Scan(layers)).samples.size(), 8000U);
}

TEST(ConnectedSides, LeavesOutStraysWithNormalsAgainstTheSurface) {
  cloud::OrientedPoints points;
  add_ball(points, 8000, 30, 1);
  cloud::Random random(5);
  for (int n = 0; n < 800; ++n) {
    const auto i = static_cast<std::size_t>(random.uniform() * 8000.0);
    points.positions.emplace_back(points.positions[i] * random.uniform(0.8, 1.2));
    points.normals.emplace_back(-points.normals[i]);
  }
  EXPECT_LT(connected_sides(Scan(points)).sparse, 8U);
}

}  // namespace
}  // namespace isotouch::field
