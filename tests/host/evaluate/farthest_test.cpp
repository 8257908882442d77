#include "host/evaluate/farthest.h"

#include <gtest/gtest.h>

namespace isotouch::evaluate {
namespace {

using Eigen::Vector3d;

cloud::TriangleMesh triangle(const Vector3d& a, const Vector3d& b, const Vector3d& c) { return {{a, b, c}, {{0, 1, 2}}}; }

Farthest from_to(const cloud::TriangleMesh& from, const cloud::TriangleMesh& to, double fineness) {
  return farthest(field::TriangleTree(from), field::TriangleTree(to), fineness);
}

TEST(Farthest, ACornerIsFoundExactly) {
  const auto found = from_to(triangle({0, 0, 1}, {9, 0, 1}, {0, 9, 3}), triangle({-20, -20, 0}, {40, -20, 0}, {-20, 40, 0}), 0.1);
  EXPECT_EQ(found.distance, 3);
  EXPECT_EQ(found.place, Vector3d(0, 9, 3));
}

TEST(Farthest, AMiddleIsFoundWithinTheFineness) {
  // Two flat triangles far apart under the corners of a large one: its middle is the farthest.
  cloud::TriangleMesh two = triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  for (const Vector3d& v : {Vector3d(100, 0, 0), Vector3d(101, 0, 0), Vector3d(100, 1, 0)}) two.vertices.push_back(v);
  two.faces.push_back({3, 4, 5});
  const auto line = triangle({0.5, 0.2, 0}, {100.5, 0.2, 0}, {50, 0.3, 0});
  for (const double fineness : {5.0, 0.5, 0.01}) {
    const double found = from_to(line, two, fineness).distance;
    EXPECT_LE(found, 49.8);
    EXPECT_GE(found, 49.1 - fineness);
  }
}

TEST(Farthest, HoweverNearTheSurfacesAreThePlaceIsOneOfThem) {
  const auto lower = triangle({5, 5, 0}, {6, 5, 0}, {5, 6, 0});
  for (const double height : {0.0, 0.001, 0.2}) {
    const auto upper = triangle({5, 5, height}, {6, 5, height}, {5, 6, height});
    const auto found = from_to(upper, lower, 10);
    EXPECT_EQ(found.distance, height);
    EXPECT_EQ(found.place, Vector3d(5, 5, height));
  }
}

TEST(Farthest, TheTwoWaysDiffer) {
  const auto small = triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  const auto large = triangle({0, 0, 0}, {10, 0, 0}, {0, 10, 0});
  EXPECT_NEAR(from_to(small, large, 0.01).distance, 0, 1e-12);
  EXPECT_NEAR(from_to(large, small, 0.01).distance, 9, 0.01);
}

}  // namespace
}  // namespace isotouch::evaluate
