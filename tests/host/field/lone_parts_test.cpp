#include "host/field/lone_parts.h"

#include <gtest/gtest.h>

#include "host/cloud/shapes.h"

namespace isotouch::field {
namespace {

using cloud::OrientedPoints;
using Eigen::Vector3d;

/// Balls round one place, the largest first; each faces as its sign says.
Scan shells(const std::vector<double>& signs) {
  OrientedPoints points;
  double radius = 1;
  for (const double sign : signs) {
    const OrientedPoints ball = cloud::sample_shape(cloud::shape("sphere"), static_cast<std::size_t>(4000 * radius * radius));
    for (std::size_t i = 0; i < ball.size(); ++i) {
      points.positions.emplace_back(radius * ball.positions[i]);
      points.normals.emplace_back(sign * ball.normals[i]);
    }
    radius *= 0.55;
  }
  return Scan(points);
}

/// 1 where all normals of a shell point away from the middle, -1 where all point to it, 0 else.
std::vector<double> signs(const Scan& scan, std::size_t count) {
  std::vector<double> found;
  std::size_t first = 0;
  double radius = 1;
  for (; count > 0; --count, radius *= 0.55) {
    const auto size = static_cast<std::size_t>(4000 * radius * radius);
    std::size_t out = 0;
    for (std::size_t i = first; i < first + size; ++i) out += scan.normals()[i].dot(scan.positions()[i]) > 0 ? 1U : 0U;
    found.push_back(out == size ? 1 : out == 0 ? -1 : 0);
    first += size;
  }
  return found;
}

TEST(LoneParts, ShellsInEachOtherFaceAlternately) {
  for (const double a : {-1.0, 1.0}) {
    for (const double b : {-1.0, 1.0}) {
      for (const double c : {-1.0, 1.0}) {
        Scan scan = shells({a, b, c});
        turn_lone_parts(scan, false);
        EXPECT_EQ(signs(scan, 3), (std::vector<double>{1, -1, 1})) << a << b << c;
      }
    }
  }
}

TEST(LoneParts, TheFilesNormalsStayWithinAnotherPart) {
  Scan scan = shells({-1, 1});
  EXPECT_EQ(turn_lone_parts(scan, true), 4000U);
  EXPECT_EQ(signs(scan, 2), (std::vector<double>{1, 1}));
}

TEST(LoneParts, WhatIsOnePartStays) {
  Scan scan = shells({-1});
  EXPECT_EQ(turn_lone_parts(scan, false), 0U);
}

}  // namespace
}  // namespace isotouch::field
