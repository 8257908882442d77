#include "host/field/winding_level.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "host/cloud/shapes.h"

namespace isotouch::field {
namespace {

using Eigen::Vector3d;

class HeldToLevel : public ::testing::Test {
 protected:
  const Scan scan{cloud::sample_shape(cloud::shape("sphere"), 2500)};  // about 5 apart
  const WindingSign winding{scan};

  std::vector<Neighbour> nearest(const Vector3d& place) const {
    std::vector<Neighbour> found;
    scan.tree().nearest(place, 9, found);
    return found;
  }
  double held(double distance, const Vector3d& place, std::vector<std::uint8_t> doubtful) const {
    return WindingLevel(scan, std::move(doubtful), winding).hold(distance, place, nearest(place));
  }
  double held(double distance, const Vector3d& place) const { return held(distance, place, std::vector<std::uint8_t>(scan.size(), 1)); }
};

TEST_F(HeldToLevel, LeavesPlacesAloneWhereNoSampleIsDoubtful) {
  for (const double radius : {70.0, 79.0, 82.0, 90.0}) {
    for (const double distance : {-9.0, 0.0, 9.0}) {
      EXPECT_EQ(held(distance, {radius, 0, 0}, std::vector<std::uint8_t>(scan.size(), 0)), distance) << radius;
    }
  }
}

TEST_F(HeldToLevel, ChangesNothingThatIsRight) {
  for (const double radius : {40.0, 70.0, 75.0, 78.0, 79.5, 80.5, 82.0, 85.0, 90.0, 120.0}) {
    for (const Vector3d& way : {Vector3d(1, 0, 0), Vector3d(0, 0.6, 0.8), Vector3d(-0.48, 0.64, 0.6)})
      EXPECT_EQ(held(radius - 80.0, radius * way), radius - 80.0) << radius;
  }
}

TEST_F(HeldToLevel, TurnsWhatLiesClearlyOnTheOtherSide) {
  for (const Vector3d& way : {Vector3d(1, 0, 0), Vector3d(0, 0.6, 0.8), Vector3d(-0.48, 0.64, 0.6)}) {
    EXPECT_GT(held(-3.0, 84.0 * way), 0.0);
    EXPECT_LT(held(3.0, 76.0 * way), 0.0);
  }
}

TEST_F(HeldToLevel, AddsNoMoreThanTheWayToASample) {
  for (const double radius : {83.0, 86.0, 95.0, 150.0}) {
    const Vector3d place(0, radius, 0);
    EXPECT_LE(held(-3.0, place), std::sqrt(nearest(place).front().squared_distance)) << radius;
  }
}

TEST(WindingLevel, StaysAtTheFacesOfAThinPlate) {
  const Scan scan(cloud::sample_shape(cloud::shape("plate"), 3756));  // 4 thick, samples about 3 apart
  const WindingSign winding(scan, 1.0);
  const WindingLevel level(scan, std::vector<std::uint8_t>(scan.size(), 1), winding);
  std::vector<Neighbour> nearest;
  for (double x = -60.0; x <= 60.0; x += 1.0) {
    const Vector3d place(x, 0.3 * x, 1.5);  // half a unit below the face
    scan.tree().nearest(place, 9, nearest);
    EXPECT_EQ(level.hold(-0.5, place, nearest), -0.5) << x;
  }
}

}  // namespace
}  // namespace isotouch::field
