#include "host/field/winding_sign.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include "host/cloud/random.h"
#include "host/cloud/shapes.h"

namespace isotouch::field {
namespace {

using Eigen::Vector3d;

TEST(SampleAreas, AddUpToTheSurface) {
  const auto total = [](const char* name, std::size_t count) {
    const auto areas = sample_areas(Scan(cloud::sample_shape(cloud::shape(name), count)));
    return std::accumulate(areas.begin(), areas.end(), 0.0);
  };
  EXPECT_NEAR(total("sphere", 1500) / (4.0 * std::numbers::pi * 80.0 * 80.0), 1.0, 0.02);
  EXPECT_NEAR(total("torus", 1500) / (4.0 * std::numbers::pi * std::numbers::pi * 70.0 * 25.0), 1.0, 0.03);
  EXPECT_NEAR(total("plate", 3000) / (8.0 * (80.0 * 60.0 + 80.0 * 2.0 + 60.0 * 2.0)), 1.0, 0.06);
}

TEST(SampleAreas, GrowWhereSamplesAreFartherApart) {
  cloud::Random random(3);
  cloud::OrientedPoints points;
  const auto even = cloud::sample_shape(cloud::shape("sphere"), 6000);
  for (std::size_t i = 0; i < even.size(); ++i) {
    if (even.positions[i].z() > 0.0 && random.uniform() > 0.1) continue;
    points.positions.push_back(even.positions[i]);
    points.normals.push_back(even.normals[i]);
  }
  const auto areas = sample_areas(Scan(points));
  EXPECT_NEAR(std::accumulate(areas.begin(), areas.end(), 0.0) / (4.0 * std::numbers::pi * 80.0 * 80.0), 1.0, 0.05);
}

TEST(WindingSignHeavy, IsOneInTheBodyAndZeroOutside) {
  for (const char* name : {"sphere", "torus", "box", "capsules"}) {
    const cloud::Shape shape = cloud::shape(name);
    const Scan scan(cloud::sample_shape(shape, 2500));
    const WindingSign enclosure(scan);
    cloud::Random random(7);
    std::size_t inside = 0;
    for (int n = 0; n < 2000; ++n) {
      const Vector3d place(random.uniform(-120, 120), random.uniform(-120, 120), random.uniform(-120, 120));
      const double distance = shape.distance(place);
      if (std::abs(distance) < 8.0) continue;  // about one and a half spacings
      inside += distance < 0.0 ? 1U : 0U;
      EXPECT_NEAR(enclosure(place), distance < 0.0 ? 1.0 : 0.0, 0.15) << name << ' ' << place.transpose();
    }
    EXPECT_GT(inside, 10U) << name;
  }
}

TEST(WindingSign, ChangesByHalfAcrossAHole) {
  // Of a sphere the cap above z = 64 is missing: a hole of radius 48.
  const auto whole = cloud::sample_shape(cloud::shape("sphere"), 3000);
  cloud::OrientedPoints points;
  for (std::size_t i = 0; i < whole.size(); ++i) {
    if (whole.positions[i].z() > 64.0) continue;
    points.positions.push_back(whole.positions[i]);
    points.normals.push_back(whole.normals[i]);
  }
  const Scan scan(points);
  const WindingSign enclosure(scan);
  EXPECT_NEAR(enclosure({0, 0, 64}), 0.5, 0.05);
  EXPECT_GT(enclosure({0, 0, 30}), 0.7);
  EXPECT_LT(enclosure({0, 0, 100}), 0.3);
}

TEST(WindingSign, HardlyHearsTurnedNormals) {
  auto points = cloud::sample_shape(cloud::shape("sphere"), 2500);
  for (std::size_t i = 0; i < points.size(); i += 17) points.normals[i] = -points.normals[i];  // 6 %
  const Scan scan(points);
  const WindingSign enclosure(scan);
  EXPECT_GT(enclosure({0, 0, 0}), 0.8);
  EXPECT_GT(enclosure({0, 40, 40}), 0.8);
  EXPECT_NEAR(enclosure({0, 0, 100}), 0.0, 0.08);
}

class HeldByEnclosure : public ::testing::Test {
 protected:
  const Scan scan{cloud::sample_shape(cloud::shape("sphere"), 2500)};
  const WindingSign enclosure{scan};

  double held(double distance, const Vector3d& place) const {
    std::vector<Neighbour> found;
    scan.tree().nearest(place, 9, found);
    return signed_by_winding(distance, place, found.front().squared_distance, found.back().squared_distance, enclosure);
  }
};

TEST_F(HeldByEnclosure, LeavesThePlacesNextToSamplesAlone) {
  for (const double radius : {77.0, 79.0, 80.0, 81.0, 83.0}) {
    for (const double distance : {-5.0, -0.5, 0.5, 5.0}) EXPECT_EQ(held(distance, {radius, 0, 0}), distance) << radius;
  }
}

TEST_F(HeldByEnclosure, ChangesNothingThatIsRight) {
  for (const double radius : {0.0, 20.0, 50.0, 70.0, 90.0, 120.0}) EXPECT_EQ(held(radius - 80.0, {0, radius, 0}), radius - 80.0) << radius;
}

TEST_F(HeldByEnclosure, TurnsTheSignFarFromEverySample) {
  EXPECT_LT(held(3.0, {0, 0, 20}), -20.0);
  EXPECT_LT(held(0.0, {0, 50, 0}), -10.0);
  EXPECT_GT(held(-3.0, {120, 0, 0}), 15.0);
  EXPECT_GT(held(-1e9, {0, 0, 200}), 50.0);
}

TEST(WindingSign, HardlyShowsTheNoiseOfSamples) {
  auto points = cloud::sample_shape(cloud::shape("sphere"), 2500);
  cloud::Random random(5);
  for (auto& p : points.positions) p += random.uniform(-2, 2) * p.normalized();
  const Scan scan(points);
  const auto deviation = [&](const WindingSign& winding) {
    double squares = 0.0;
    for (int n = 0; n < 500; ++n) {
      const Vector3d way = Vector3d(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)).normalized();
      squares += std::pow(winding(82.5 * way) - winding(-82.5 * way), 2);
    }
    return std::sqrt(squares / 500);
  };
  EXPECT_LT(deviation(WindingSign(scan, 1.2)), 0.8 * deviation(WindingSign(scan)));
}

}  // namespace
}  // namespace isotouch::field
