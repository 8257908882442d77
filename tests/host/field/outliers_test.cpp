#include "host/field/outliers.h"

#include <gtest/gtest.h>

#include <cmath>
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

}  // namespace
}  // namespace isotouch::field
