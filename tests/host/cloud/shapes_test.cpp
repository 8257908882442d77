#include "host/cloud/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>

#include "host/cloud/random.h"
#include "host/error.h"
#include "shared/hash64.h"

namespace isotouch::cloud {
namespace {

using Eigen::Vector3d;

std::uint64_t hash_of(const OrientedPoints& points) {
  std::vector<std::uint8_t> bytes;
  for (const auto* list : {&points.positions, &points.normals}) {
    for (const Vector3d& v : *list) {
      for (const double value : v) {
        bytes.resize(bytes.size() + 8);
        store_le(bytes.data() + bytes.size() - 8, std::bit_cast<std::uint64_t>(value));
      }
    }
  }
  return hash64(bytes.data(), bytes.size());
}

/// Distance from each point to the nearest that faces the same way.
std::vector<double> spacings(const OrientedPoints& points) {
  std::vector<double> nearest(points.size(), 1e300);
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (points.normals[i].dot(points.normals[j]) < 0.0) continue;
      const double distance = (points.positions[i] - points.positions[j]).norm();
      nearest[i] = std::min(nearest[i], distance);
      nearest[j] = std::min(nearest[j], distance);
    }
  }
  std::sort(nearest.begin(), nearest.end());
  return nearest;
}

TEST(Shapes, AreTheTenThatTheManualNames) {
  const std::vector<std::string> expected = {"sphere", "torus", "box", "plate", "capsules", "hydrant", "owl", "boy", "bomberman", "jaguar"};
  EXPECT_EQ(shape_names(), expected);
}

TEST(Shapes, AnUnknownNameIsAnsweredWithTheKnownOnes) {
  try {
    shape("cat");
    FAIL();
  } catch (const InputError& e) {
    EXPECT_STREQ(e.what(), "there is no shape 'cat'; choose one of sphere torus box plate capsules hydrant owl boy bomberman jaguar");
  }
}

TEST(Shapes, HaveThePublishedPointCounts) {
  const std::map<std::string, std::size_t> published = {
      {"hydrant", 3756}, {"owl", 3725}, {"boy", 5153}, {"bomberman", 3751}, {"jaguar", 4433}};
  for (const auto& [name, points] : published) EXPECT_EQ(shape(name).default_points, points) << name;
}

TEST(Shapes, ScatteredPointsLieOnTheSurfaceAndKnowItsNormal) {
  for (const std::string& name : shape_names()) {
    const Shape object = shape(name);
    const OrientedPoints points = scatter_on_shape(object, 1000, 5);
    ASSERT_EQ(points.size(), 1000U);
    int creased = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Vector3d& p = points.positions[i];
      const Vector3d& n = points.normals[i];
      ASSERT_NEAR(object.distance(p), 0.0, 1e-11) << name;
      ASSERT_NEAR(n.norm(), 1.0, 1e-12) << name;
      ASSERT_TRUE((p.array() >= object.low.array() - 1e-9).all() && (p.array() <= object.high.array() + 1e-9).all())
          << name << p.transpose();
      if (object.distance(p + 1e-3 * n) <= 0.0 || object.distance(p - 1e-3 * n) >= 0.0) ++creased;  // within 0.001 of a crease
    }
    EXPECT_LE(creased, 5) << name;
  }
}

TEST(ShapesHeavy, NoDistanceExceedsTheWayToTheSurfaceAndTheExactOnesReachIt) {
  for (const std::string& name : shape_names()) {
    const Shape object = shape(name);
    const OrientedPoints surface = scatter_on_shape(object, 3000, 6);
    Random random(9);
    for (int i = 0; i < 200; ++i) {
      Vector3d p;
      for (int axis = 0; axis < 3; ++axis) p[axis] = random.uniform(object.low[axis] - 20, object.high[axis] + 20);
      double nearest = 1e300;
      for (const Vector3d& s : surface.positions) nearest = std::min(nearest, (s - p).norm());
      EXPECT_LE(std::abs(object.distance(p)), nearest + 1e-9) << name;
      if (!object.exact_distance || object.distance(p) < 0.0) continue;
      EXPECT_GT(object.distance(p), nearest - 8.0) << name;  // 3000 points leave gaps
    }
  }
}

TEST(Shapes, SampledPointsAreAsManyAsAskedForAndEvenlySpread) {
  const std::map<std::string, double> areas = {{"sphere", 80424.77}, {"plate", 2 * (160 * 120 + 160 * 4 + 120 * 4.0)}};
  for (const auto& [name, area] : areas) {
    const OrientedPoints points = sample_shape(shape(name), 1500, 1);
    ASSERT_EQ(points.size(), 1500U);
    const std::vector<double> nearest = spacings(points);
    const double densest = std::sqrt(2.0 * area / (std::sqrt(3.0) * 1500));  // the spacing of a perfect hexagonal packing
    EXPECT_GT(nearest.front() / densest, 0.60) << name;                      // random points: 0.02
    EXPECT_LT(nearest.front() / densest, 0.85) << name;
    EXPECT_GT(nearest[750] / densest, 0.75) << name;  // random points: 0.45
    EXPECT_LT(nearest[750] / densest, 0.95) << name;
  }
}

TEST(Shapes, AThinPlateKeepsAsManyPointsOnEitherSide) {
  const OrientedPoints points = sample_shape(shape("plate"), 1500, 3);
  const auto above = std::count_if(points.normals.begin(), points.normals.end(), [](const Vector3d& n) { return n.z() > 0.5; });
  const auto below = std::count_if(points.normals.begin(), points.normals.end(), [](const Vector3d& n) { return n.z() < -0.5; });
  EXPECT_NEAR(static_cast<double>(above), static_cast<double>(below), 30.0);
  EXPECT_GT(above + below, 1300);
}

TEST(Shapes, TheSameSeedDrawsTheSamePointsOnEveryMachine) {
  EXPECT_EQ(hash_of(sample_shape(shape("torus"), 200, 1)), 6647268900835413817ULL);
  EXPECT_EQ(hash_of(sample_shape(shape("hydrant"), 200, 1)), 2380761034309952269ULL);
  EXPECT_EQ(hash_of(scatter_on_shape(shape("jaguar"), 200, 1)), 1013281044582174818ULL);
  EXPECT_NE(hash_of(scatter_on_shape(shape("jaguar"), 200, 1)), hash_of(scatter_on_shape(shape("jaguar"), 200, 2)));
}

}  // namespace
}  // namespace isotouch::cloud
