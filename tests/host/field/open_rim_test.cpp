#include "host/field/open_rim.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <string>
#include <utility>

#include "host/cloud/random.h"
#include "host/cloud/shapes.h"
#include "tests/support/sanitized.h"

namespace isotouch::field {
namespace {

using Eigen::Vector3d;

/// The samples of a shape on one side of a plane across z.
cloud::OrientedPoints below(const std::string& name, double z, std::size_t points) {
  const cloud::OrientedPoints all = cloud::sample_shape(cloud::shape(name), points);
  cloud::OrientedPoints part;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all.positions[i].z() > z) continue;
    part.positions.push_back(all.positions[i]);
    part.normals.push_back(all.normals[i]);
  }
  return part;
}

void expect_no_shape_is_open(std::size_t points) {
  for (const std::string& name : test::examples(cloud::shape_names())) {
    const OpenRim rim = open_rim(Scan(cloud::sample_shape(cloud::shape(name), points)));
    EXPECT_EQ(rim.samples, 0U) << name << " of " << points;
  }
}

TEST(OpenRim, NoShapeOfOursIsOpen) { expect_no_shape_is_open(1500); }

TEST(OpenRimHeavy, NorAreTheyWithMorePoints) { expect_no_shape_is_open(4000); }

/// Points at random places of a ball's wall, without order, and of its inner side.
cloud::OrientedPoints hollow_ball(double thickness, std::size_t points, double below) {
  cloud::OrientedPoints ball;
  cloud::Random random(1);
  while (ball.size() < points) {
    const Vector3d p(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
    if (p.norm() > 1 || p.norm() < 0.1 || p.normalized().z() > below) continue;
    const bool inner = ball.size() % 2 == 1;
    ball.positions.push_back((inner ? 35 - thickness : 35) * p.normalized());
    ball.normals.push_back((inner ? -1 : 1) * p.normalized());
  }
  return ball;
}

TEST(OpenRim, AThinWallOfPointsAtRandomIsNotOpen) {
  EXPECT_EQ(open_rim(Scan(hollow_ball(5, 2500, 2))).samples, 0U);
  EXPECT_EQ(open_rim(Scan(hollow_ball(3, 2500, 2))).samples, 0U);
  const OpenRim cut = open_rim(Scan(hollow_ball(3, 2500, 0)));
  EXPECT_GT(cut.samples, 100U);
  EXPECT_LT(cut.least_surrounded, 0.2);
}

TEST(OpenRim, OfAHemisphereIsItsEquator) {
  const double equator = 2 * M_PI * 80;
  for (const std::size_t points : test::examples<std::size_t>({4000, 1000, 16000})) {
    const OpenRim rim = open_rim(Scan(below("sphere", 0, points)));
    EXPECT_NEAR(rim.length, equator, 0.2 * equator) << points;
    EXPECT_LT(rim.place.norm(), 8) << points;
  }
}

TEST(OpenRim, ItsLinksRunAlongIt) {
  const OpenRim rim = open_rim(Scan(below("sphere", 0, 4000)));
  double length = 0;
  for (const auto& [a, b] : rim.links) {
    length += (b - a).norm();
    EXPECT_NEAR(a.head<2>().norm(), 80, 4);
    EXPECT_GT(a.z(), -8);
  }
  EXPECT_NEAR(length, rim.length, 0.04 * rim.length);
  std::size_t ends = 0;
  for (const auto& link : rim.links) {
    for (const Vector3d& end : link) {
      std::size_t met = 0;
      for (const auto& other : rim.links) met += (other[0] == end ? 1U : 0U) + (other[1] == end ? 1U : 0U);
      ends += met == 1 ? 1U : 0U;
    }
  }
  EXPECT_LE(ends, rim.links.size() / 10) << "the ring is closed; a few samples stand beside it";
  EXPECT_TRUE(open_rim(Scan(cloud::sample_shape(cloud::shape("sphere"), 1500))).links.empty());
}

TEST(OpenRim, OfATubeCutLengthwiseIsBothCircles) {
  const double circles = 2 * M_PI * (70 - 25) + 2 * M_PI * (70 + 25);
  const OpenRim rim = open_rim(Scan(below("torus", 0, 8000)));
  EXPECT_NEAR(rim.length, circles, 0.2 * circles);
}

TEST(OpenRim, RoundAHoleItIsSurroundedAndRoundALimbOrAcrossAWallItIsNot) {
  const auto away_from = [](const std::string& name, const Vector3d& place, double radius) {
    const cloud::OrientedPoints all = cloud::sample_shape(cloud::shape(name), 4000);
    cloud::OrientedPoints part;
    for (std::size_t i = 0; i < all.size(); ++i) {
      if ((all.positions[i] - place).norm() < radius) continue;
      part.positions.push_back(all.positions[i]);
      part.normals.push_back(all.normals[i]);
    }
    return open_rim(Scan(part));
  };
  EXPECT_GT(away_from("sphere", {0, 0, 80}, 40).least_surrounded, 0.7);
  const OpenRim tube = away_from("torus", {70, 0, 0}, 60);
  EXPECT_GT(tube.samples, 30U);
  EXPECT_LT(tube.least_surrounded, 0.2);
  const OpenRim wall = away_from("plate", {80, 60, 0}, 70);
  EXPECT_GT(wall.samples, 30U);
  EXPECT_LT(wall.least_surrounded, 0.2);
}

TEST(OpenRim, APatchEndsOutwardAllRoundAndAHoleOrATubeDoesNot) {
  const cloud::OrientedPoints ball = cloud::sample_shape(cloud::shape("sphere"), 4000);
  cloud::OrientedPoints with_patch = ball;
  std::size_t seen = 0;
  for (std::size_t i = 0; i < ball.size(); ++i) {
    if (ball.positions[i].z() > -70) continue;
    with_patch.positions.push_back(0.8 * ball.positions[i]);  // the far wall, as one sees it through an opening
    with_patch.normals.push_back(-ball.normals[i]);
    ++seen;
  }
  ASSERT_GT(seen, 100U);
  EXPECT_EQ(open_rim(Scan(with_patch)).patches, seen);
  for (const auto& [name, z] :
       test::examples<std::pair<const char*, double>>({{"sphere", 70}, {"torus", 0}, {"owl", 20}, {"sphere", -70}})) {
    const OpenRim rim = open_rim(Scan(below(name, z, 8000)));
    EXPECT_GT(rim.samples, 12U) << name << z;
    EXPECT_EQ(rim.patches, 0U) << name << z;
  }
}

/// Points at random on a fin of 0.6 x 40 x 20, but for so much of the height of its end face at y = 20, in the middle.
cloud::OrientedPoints fin(double unseen_height, unsigned seed) {
  const Vector3d half(0.3, 20, 10);
  cloud::OrientedPoints fin;
  cloud::Random random(seed);
  for (int axis = 0; axis < 3; ++axis) {
    for (int i = 0; i < 16 * half.prod() / half[axis]; ++i) {  // two on each square
      Vector3d p = half;
      for (double& coordinate : p) coordinate *= random.uniform(-1, 1);
      const double side = i % 2 == 0 ? 1 : -1;
      p[axis] = side * half[axis];
      if (axis == 1 && side > 0 && std::abs(p.z()) < unseen_height / 2) continue;
      fin.positions.push_back(p);
      fin.normals.push_back(side * Vector3d::Unit(axis));
    }
  }
  return fin;
}

TEST(OpenRim, ANarrowEndWithoutSamplesForAPieceIsNoRimAndOneWithoutAnyIs) {
  for (const unsigned seed : {8U, 14U}) {  // chains of 13 and 15 samples
    EXPECT_EQ(open_rim(Scan(fin(5, seed))).samples, 0U) << seed;
    const OpenRim cut = open_rim(Scan(fin(20, seed)));
    EXPECT_LT(cut.least_surrounded, 0.2) << seed;
    EXPECT_NEAR(cut.least_place.y(), 20, 2) << seed;
  }
}

TEST(OpenRim, AHoleOfAFewSamplesIsNone) {
  cloud::OrientedPoints points = cloud::sample_shape(cloud::shape("sphere"), 4000);
  cloud::OrientedPoints pricked;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if ((points.positions[i] - Vector3d(0, 0, 80)).norm() < 5) continue;
    pricked.positions.push_back(points.positions[i]);
    pricked.normals.push_back(points.normals[i]);
  }
  ASSERT_LT(pricked.size(), points.size());
  EXPECT_EQ(open_rim(Scan(std::move(pricked))).samples, 0U);
}

}  // namespace
}  // namespace isotouch::field
