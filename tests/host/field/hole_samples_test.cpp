#include "host/field/hole_samples.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "host/cloud/random.h"
#include "host/cloud/shapes.h"

namespace isotouch::field {
namespace {

using Eigen::Vector3d;

constexpr double kHalf = 10;  // of a cube's side; samples are about 1 apart

/// A cube whose top has a round hole of this radius, with a lip down to `depth` below the top.
cloud::OrientedPoints pierced_cube(double radius, double depth) {
  cloud::OrientedPoints points;
  cloud::Random random(5);
  const auto add = [&](const Vector3d& place, const Vector3d& normal) {
    points.positions.push_back(place);
    points.normals.push_back(normal);
  };
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {-1.0, 1.0}) {
      for (double a = 0.5 - kHalf; a < kHalf; ++a) {
        for (double b = 0.5 - kHalf; b < kHalf; ++b) {
          Vector3d place;
          place[axis] = side * kHalf;
          place[(axis + 1) % 3] = a + random.uniform(-0.2, 0.2);
          place[(axis + 2) % 3] = b + random.uniform(-0.2, 0.2);
          if (axis == 2 && side > 0 && std::hypot(place.x(), place.y()) < radius + 0.3) continue;
          add(place, side * Vector3d::Unit(axis));
        }
      }
    }
  }
  const double count = std::floor(2 * std::numbers::pi * radius);
  for (double down = 0.4; down <= depth; down += 0.8) {
    for (double n = 0; n < count; ++n) {
      const double turn = 2 * std::numbers::pi * (n + 0.5 * down) / count;
      const Vector3d way(std::cos(turn), std::sin(turn), 0);
      add(radius * way + (kHalf - down) * Vector3d::UnitZ(), -way);
    }
  }
  return points;
}

cloud::OrientedPoints skins(const cloud::OrientedPoints& points) {
  const Scan scan(points);
  return hole_samples(scan, Surface(scan));
}

TEST(HoleSamples, CoverAHoleWithALip) {
  const cloud::OrientedPoints found = skins(pierced_cube(2.8, 1.2));
  ASSERT_GE(found.size(), 3U);
  ASSERT_EQ(found.normals.size(), found.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_LT(found.positions[i].head<2>().norm(), 2.8) << i;
    EXPECT_LT(std::abs(found.positions[i].z() - (kHalf - 0.8)), 1.2) << i;
    EXPECT_GT(found.normals[i].z(), 0.8) << i;
  }
}

TEST(HoleSamples, ALargeHoleIsLeftToTheModels) { EXPECT_EQ(skins(pierced_cube(8.5, 1.2)).size(), 0U); }

TEST(HoleSamples, AClosedScanGetsNone) {
  EXPECT_EQ(skins(pierced_cube(-1, 0)).size(), 0U);
  for (const char* name : {"sphere", "torus", "box", "plate", "capsules"})
    EXPECT_EQ(skins(cloud::sample_shape(cloud::shape(name), 2500)).size(), 0U) << name;
}

TEST(HoleSamples, AHoleInARoundBodyIsBridgedByTheModels) {
  cloud::OrientedPoints points;
  const cloud::OrientedPoints whole = cloud::sample_shape(cloud::shape("sphere"), 3756);
  for (std::size_t i = 0; i < whole.size(); ++i) {
    if (whole.positions[i].z() > 79) continue;  // of 80: a hole of radius 12.6, three spacings
    points.positions.push_back(whole.positions[i]);
    points.normals.push_back(whole.normals[i]);
  }
  EXPECT_EQ(skins(points).size(), 0U);
}

/// A sphere without what lies less than `away` from its top.
cloud::OrientedPoints open_sphere(double away) {
  const cloud::OrientedPoints whole = cloud::sample_shape(cloud::shape("sphere"), 3756);  // about 4 apart, radius 80
  cloud::OrientedPoints points;
  for (std::size_t i = 0; i < whole.size(); ++i) {
    if ((whole.positions[i] - Vector3d(0, 0, 80)).norm() < away) continue;
    points.positions.push_back(whole.positions[i]);
    points.normals.push_back(whole.normals[i]);
  }
  return points;
}

TEST(HoleSamples, AWideHoleIsAsRoundAsTheBody) {
  const cloud::OrientedPoints found = skins(open_sphere(40));
  ASSERT_GT(found.size(), 50U);
  double farthest = 0.0;
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_NEAR(found.positions[i].norm(), 80.0, 1.5) << i;  // a flat skin lies up to 10 deeper
    EXPECT_GT(found.normals[i].dot(found.positions[i].normalized()), 0.98) << i;
    farthest = std::max(farthest, found.positions[i].z());
  }
  EXPECT_GT(farthest, 79.0);
}

TEST(HoleSamples, TheMissingEndOfABodyIsLeftToTheModels) {
  EXPECT_EQ(skins(open_sphere(std::sqrt(2.0) * 80)).size(), 0U);  // its rim looks to all sides
  const Scan scan(open_sphere(40));
  const Surface closed(scan, Box{Vector3d(-83, -83, -83), Vector3d(83, 83, 75)});  // the rim lies at 70
  EXPECT_EQ(hole_samples(scan, closed).size(), 0U);
}

TEST(HoleSamples, KeepTheStiffnessOfTheRim) {
  cloud::OrientedPoints points = pierced_cube(2.8, 1.2);
  points.stiffness.assign(points.size(), 0.4);
  const cloud::OrientedPoints found = skins(points);
  ASSERT_EQ(found.stiffness.size(), found.size());
  for (const double stiffness : found.stiffness) EXPECT_EQ(stiffness, 0.4);
}

}  // namespace
}  // namespace isotouch::field
