#include "host/field/scan_lines.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <string>

#include "host/cloud/shapes.h"
#include "tests/support/sanitized.h"

namespace isotouch::field {
namespace {

using cloud::OrientedPoints;
using Eigen::Vector3d;

/// A ball drawn in circles round the z axis, that far apart, with points 1 apart on each.
Scan drawn(double apart) {
  OrientedPoints points;
  for (double z = -28.7; z < 29; z += apart) {
    const double radius = std::sqrt(30 * 30 - z * z);
    const auto count = static_cast<std::size_t>(2 * M_PI * radius);
    for (std::size_t i = 0; i < count; ++i) {
      const double angle = 2 * M_PI * static_cast<double>(i) / static_cast<double>(count) + z;
      points.positions.emplace_back(radius * std::cos(angle), radius * std::sin(angle), z);
      points.normals.push_back(points.positions.back() / 30);
    }
  }
  return Scan(points);
}

TEST(ScanLines, AreSeenWhereTheyAreFarApart) {
  EXPECT_LT(share_in_lines(drawn(1.0)), 0.05);
  EXPECT_LT(share_in_lines(drawn(2.0)), 0.15);
  EXPECT_GT(share_in_lines(drawn(5.0)), 0.5);
}

TEST(ScanLines, EvenScansHaveNone) {
  for (const std::string& name : test::examples(cloud::shape_names())) {
    EXPECT_LT(share_in_lines(Scan(cloud::sample_shape(cloud::shape(name), 3000))), 0.01) << name;
  }
}

}  // namespace
}  // namespace isotouch::field
