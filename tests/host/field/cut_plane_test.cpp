#include "host/field/cut_plane.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <string>

#include "host/cloud/shapes.h"

namespace isotouch::field {
namespace {

using cloud::OrientedPoints;
using Eigen::Vector3d;

/// The part of a shape that lies below a place along a direction.
Scan below(const char* shape, const Vector3d& direction, double height, std::size_t points = 4000) {
  const OrientedPoints all = cloud::sample_shape(cloud::shape(shape), points);
  OrientedPoints part;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (direction.dot(all.positions[i]) > height) continue;
    part.positions.push_back(all.positions[i]);
    part.normals.push_back(all.normals[i]);
    part.stiffness.push_back(direction.dot(all.positions[i]) > height - 20 ? 2.0 : 1.0);
  }
  return Scan(part);
}

TEST(CutPlane, IsFoundWhereABallWasCut) {
  const Vector3d direction = Vector3d(1, -2, 3).normalized();
  for (const std::size_t points : {1000U, 4000U, 16000U}) {
    const Scan scan = below("sphere", direction, 20, points);
    const auto plane = cut_plane(scan, open_rim(scan));
    ASSERT_TRUE(plane) << points;
    EXPECT_GT(plane->axis.dot(direction), 0.999) << points;
    EXPECT_NEAR(direction.dot(plane->place), 20, 0.5 * scan.median_spacing()) << points;
  }
}

TEST(CutPlane, AHoleThatMayBeABulgeIsNone) {
  const Scan scan = below("sphere", Vector3d::UnitZ(), 60);
  EXPECT_GT(open_rim(scan).samples, 12U);
  const auto plane = cut_plane(scan, open_rim(scan));
  EXPECT_TRUE(!plane || !plane->is_cut());
}

/// The upper part of a ball, and a table that begins at a distance from it.
Scan on_table(const Scan& ball, double gap) {
  OrientedPoints standing{ball.positions(), ball.normals(), {}};
  const double step = 0.7 * ball.median_spacing();
  for (double x = -160; x <= 160; x += step) {
    for (double y = -160; y <= 160; y += step) {
      if (std::hypot(x, y) < 78 + gap) continue;
      standing.positions.emplace_back(x, y, -20 - gap);
      standing.normals.emplace_back(0, 0, 1);
    }
  }
  return Scan(standing);
}

TEST(CutPlane, ATableLooksBackAtTheScan) {
  const Scan cut = below("sphere", -Vector3d::UnitZ(), 20);
  EXPECT_TRUE(cut_plane(cut, open_rim(cut))->is_cut());
  for (const double gap : {0.0, 12.0}) {  // with a gap, the body has a rim of its own
    const Scan scan = on_table(cut, gap);
    const auto plane = cut_plane(scan, open_rim(scan));
    ASSERT_TRUE(plane) << gap;
    EXPECT_EQ(plane->is_only_end, gap == 0.0);
    EXPECT_TRUE(plane->is_table()) << gap;
    EXPECT_FALSE(plane->is_cut()) << gap;
  }
}

TEST(CutPlane, AScanThatGoesOnBehindItIsNone) {
  OrientedPoints all = cloud::sample_shape(cloud::shape("torus"), 4000);
  OrientedPoints part;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all.positions[i].x() > 40 && std::abs(all.positions[i].y()) < 12) continue;  // a tube that ends in two planes
    part.positions.push_back(all.positions[i]);
    part.normals.push_back(all.normals[i]);
  }
  const Scan scan(part);
  EXPECT_GT(open_rim(scan).samples, 24U);
  EXPECT_FALSE(cut_plane(scan, open_rim(scan)));
  const Scan closed(all);
  EXPECT_FALSE(cut_plane(closed, open_rim(closed)));
}

TEST(CutPlane, RimsElsewhereHaveNoPartInItsCap) {
  const Scan whole = below("torus", Vector3d::UnitZ(), 0, 8000);
  OrientedPoints part{whole.positions(), whole.normals(), whole.stiffness()};
  std::size_t kept = 0;
  for (std::size_t i = 0; i < part.size(); ++i) {
    if ((part.positions[i] - Vector3d(70, 0, -25)).norm() < 16) continue;  // a hole at its bottom
    part.positions[kept] = part.positions[i];
    part.normals[kept] = part.normals[i];
    part.stiffness[kept++] = part.stiffness[i];
  }
  part.positions.resize(kept);
  part.normals.resize(kept);
  part.stiffness.resize(kept);
  const Scan scan(part);
  const OpenRim rim = open_rim(scan);
  const auto plane = cut_plane(scan, rim);
  ASSERT_TRUE(plane);
  EXPECT_LT(plane->on_plane.size(), rim.along.size());
  EXPECT_GT(plane->least_surrounded, 0.5);
  const auto over_hole = [](const OrientedPoints& cap) {
    const auto is_near = [](const Vector3d& p) { return std::hypot(p.x() - 70, p.y()) < 20; };
    return static_cast<double>(std::count_if(cap.positions.begin(), cap.positions.end(), is_near));
  };
  const double usual = over_hole(plane_cap(whole, *cut_plane(whole, open_rim(whole))));
  EXPECT_NEAR(over_hole(plane_cap(scan, *plane)), usual, 0.06 * usual);
}

TEST(CutPlane, ItsCapFillsARingAndLeavesItsHole) {
  const Scan scan = below("torus", Vector3d::UnitZ(), 0, 8000);
  const OpenRim rim = open_rim(scan);
  const auto plane = cut_plane(scan, rim);
  ASSERT_TRUE(plane);
  const OrientedPoints cap = plane_cap(scan, *plane);
  ASSERT_GT(cap.size(), 400U);
  for (std::size_t i = 0; i < cap.size(); ++i) {
    const double radius = cap.positions[i].head<2>().norm();
    EXPECT_GT(radius, 44);
    EXPECT_LT(radius, 96);
    EXPECT_NEAR(cap.positions[i].z(), 0, 0.5 * scan.median_spacing());
    EXPECT_GT(cap.normals[i].z(), 0.999);
    EXPECT_EQ(cap.stiffness[i], 2.0);
  }
  const double ring = M_PI * (95 * 95 - 45 * 45), each = 0.75 * 0.75 * std::sqrt(0.75) * scan.median_spacing() * scan.median_spacing();
  EXPECT_NEAR(static_cast<double>(cap.size()), ring / each, 0.15 * ring / each);
}

}  // namespace
}  // namespace isotouch::field
