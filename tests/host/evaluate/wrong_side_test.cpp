#include "host/evaluate/wrong_side.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>

#include "tests/host/evaluate/box_mesh.h"

namespace isotouch::evaluate {
namespace {

using Eigen::Vector3d;

WrongSide between(const cloud::TriangleMesh& surface, const cloud::TriangleMesh& truth, double area_a_line) {
  return wrong_side(field::TriangleTree(surface), field::TriangleTree(truth), area_a_line);
}

TEST(WrongSide, AShiftAlongAnyAxisCountsBothSides) {
  const auto truth = box({0, 0, 0}, {10, 10, 10});
  for (int axis = 0; axis < 3; ++axis) {
    for (const double shift : {0.02, 0.5, 3.0, 20.0}) {
      const Vector3d by = shift * Vector3d::Unit(axis);
      const auto found = between(box(by, Vector3d(10, 10, 10) + by), truth, 0.01);
      const double each = 100 * std::min(shift, 10.0);
      EXPECT_NEAR(found.volume, 2 * each, 0.02 * each) << axis << " by " << shift;
      EXPECT_NEAR(found.too_much, each, 0.02 * each) << axis << " by " << shift;
    }
  }
}

TEST(WrongSide, PartsThatRunThroughEachOtherCountOnce) {
  auto truth = box({0, 0, 0}, {10, 10, 10});
  const auto second = box({5, 2, 2}, {15, 8, 8});
  for (const auto& [a, b, c] : second.faces) truth.faces.push_back({a + 8, b + 8, c + 8});
  truth.vertices.insert(truth.vertices.end(), second.vertices.begin(), second.vertices.end());
  const auto found = between(box({0, 0, 0}, {10, 10, 10}), truth, 0.01);
  EXPECT_NEAR(found.volume, 180, 2);
  EXPECT_EQ(found.too_much, 0);
}

TEST(WrongSide, FacesWithoutAreaChangeNothing) {
  auto surface = box({0, 0, 0}, {10, 10, 10});
  const auto clean = between(surface, box({1, 0, 0}, {10, 10, 10}), 0.01);
  surface.vertices.emplace_back(5, 5, 5);
  surface.vertices.emplace_back(5, 5, 5);
  surface.vertices.emplace_back(5, 5, 5);
  surface.faces.push_back({8, 9, 10});
  surface.faces.push_back({0, 8, 9});
  EXPECT_EQ(between(surface, box({1, 0, 0}, {10, 10, 10}), 0.01).volume, clean.volume);
  EXPECT_NEAR(clean.volume, 100, 1e-9);
}

}  // namespace
}  // namespace isotouch::evaluate
