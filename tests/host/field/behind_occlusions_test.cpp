#include "host/field/behind_occlusions.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "host/cloud/random.h"

namespace isotouch::field {
namespace {

using cloud::OrientedPoints;
using Eigen::Vector3d;

const Vector3d kSlope = Vector3d(0.8, 0, 0.6);

/// From above: a plate at the height 10 for x < 0, and a slope behind it that falls to larger x.
OrientedPoints plate_over_slope(double gap) {
  OrientedPoints points;
  cloud::Random random(2);
  for (int i = 0; i < 3000; ++i) {
    const double x = random.uniform(-20, 20), y = random.uniform(-15, 15);
    const bool slope = x > gap;
    if (!slope && x > 0) continue;
    points.positions.emplace_back(x, y, slope ? -4.0 / 3.0 * x : 10.0);
    points.normals.push_back(slope ? kSlope : Vector3d::UnitZ());
  }
  return points;
}

OrientedPoints floor_of(const OrientedPoints& points, double opening) {
  const Scan scan(points);
  return behind_occlusions(scan, FrontView(scan.positions(), Vector3d::UnitZ(), 0.6, 4), 0.6, opening);
}

TEST(BehindOcclusions, ContinuesTheSlopeBelowThePlate) {
  const OrientedPoints floor = floor_of(plate_over_slope(0.0), 2.0);
  ASSERT_GT(floor.size(), 40U);
  double least = 0.0;
  for (std::size_t i = 0; i < floor.size(); ++i) {
    const Vector3d& p = floor.positions[i];
    EXPECT_NEAR(kSlope.dot(p), 0.0, 1e-9);
    EXPECT_EQ(floor.normals[i], kSlope);
    EXPECT_LT(p.x(), 1.0) << "where the slope was seen";
    EXPECT_LT(p.z(), 10.0 - 2.0) << "close to the plate";
    least = std::min(least, p.x());
  }
  EXPECT_LT(least, -0.5);
  EXPECT_GT(least, -2.0);  // 2.0 · cot of the slope · cos, and a spacing
}

TEST(BehindOcclusions, AddsNothingWhereNothingIsHidden) {
  const OrientedPoints both = plate_over_slope(0.0);
  OrientedPoints slope;
  for (std::size_t i = 0; i < both.size(); ++i) {
    if (both.positions[i].x() <= 0.0) continue;
    slope.positions.push_back(both.positions[i]);
    slope.normals.push_back(both.normals[i]);
  }
  EXPECT_EQ(floor_of(slope, 2.0).size(), 0U);
  EXPECT_EQ(floor_of(plate_over_slope(0.0), 0.0).size(), 0U);
  EXPECT_EQ(floor_of(plate_over_slope(3.0), 2.0).size(), 0U) << "a gap that is wider than neighbours are apart is a rim";
}

}  // namespace
}  // namespace isotouch::field
