#include "host/field/lone_parts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

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
  EXPECT_EQ(turn_lone_parts(scan, true).size(), 4000U);
  EXPECT_EQ(signs(scan, 2), (std::vector<double>{1, 1}));
}

TEST(LoneParts, WhatIsOnePartStays) {
  Scan scan = shells({-1});
  EXPECT_TRUE(turn_lone_parts(scan, false).empty());
}

/// The wall of a tube along z, and its bottom where it has one; as if its rim had not been scanned.
void add_tube(OrientedPoints& points, double radius, double low, double high, double sign, bool bottom) {
  for (double z = low; z <= high; z += 1) {
    const int around = static_cast<int>(2 * M_PI * radius);
    for (int n = 0; n < around; ++n) {
      const double turn = 2 * M_PI * (n + 0.5 * std::fmod(z, 2.0)) / around;
      const Vector3d out(std::cos(turn), std::sin(turn), 0);
      points.positions.emplace_back(radius * out + Vector3d(0, 0, z));
      points.normals.emplace_back(sign * out);
    }
  }
  for (double x = -radius; bottom && x <= radius; x += 1) {
    for (double y = -radius; y <= radius; y += 1) {
      if (std::hypot(x, y) > radius - 0.5) continue;
      points.positions.emplace_back(x, y, low);
      points.normals.emplace_back(0, 0, -sign);
    }
  }
}

/// None of them, in this order of the points and in the reverse one.
void expect_stay(OrientedPoints points) {
  Scan scan(points);
  EXPECT_TRUE(turn_lone_parts(scan, true).empty());
  std::reverse(points.positions.begin(), points.positions.end());
  std::reverse(points.normals.begin(), points.normals.end());
  Scan reversed(points);
  EXPECT_TRUE(turn_lone_parts(reversed, true).empty());
}

TEST(LoneParts, TheWallOfAHoleStays) {
  OrientedPoints panel;
  for (double x = -50; x <= 50; x += 1) {
    for (double y = -50; y <= 50; y += 1) {
      if (std::hypot(x, y) < 11) continue;
      panel.positions.emplace_back(x, y, 0);
      panel.normals.emplace_back(0, 0, 1);
    }
  }
  add_tube(panel, 8, -40, -3, -1, false);
  expect_stay(panel);
}

TEST(LoneParts, TheInsideOfACupStays) {
  for (const double inner_top : {97.0, 100.0, 103.0}) {
    OrientedPoints cup;
    add_tube(cup, 40, 0, 100, 1, true);
    add_tube(cup, 34, 6, inner_top, -1, true);
    expect_stay(cup);
  }
}

}  // namespace
}  // namespace isotouch::field
