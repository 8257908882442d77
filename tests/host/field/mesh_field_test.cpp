#include "host/field/mesh_field.h"

#include <gtest/gtest.h>

#include <map>
#include <tuple>

#include "host/field/make_grid.h"
#include "host/field/sample_distance.h"
#include "tests/host/field/box_mesh.h"

namespace isotouch::field {
namespace {

using Eigen::Vector3d;

std::tuple<int, int, int> place(const Brick& brick) { return {brick.cell.z(), brick.cell.y(), brick.cell.x()}; }

TEST(MeshField, TheWalkFindsEveryBrickOfTheBandWithTheSameBits) {
  const Vector3d half(10, 7, 2);
  // A second piece, that no seed of the first leads to, and a hollow.
  const MeshDistance distance(
      together(together(box_mesh(-half, half), box_mesh({14, 9, 5}, {16, 11, 7})), turned(box_mesh({-9, -6, -1.5}, {9, 6, 1.5}))));
  const Grid grid = make_grid({-10, -7, -2}, {16, 11, 7}, 0.25, mesh_margin(4));
  const BandField walked = mesh_field(distance, grid, 4);
  const BandField all = sample_distance([&](const Vector3d& p) { return distance(p); }, grid, 4);
  std::map<std::tuple<int, int, int>, const Brick*> by_place;
  for (const Brick& brick : walked.bricks) by_place[place(brick)] = &brick;
  ASSERT_GT(all.bricks.size(), 1000U);
  for (const Brick& brick : all.bricks) {
    ASSERT_EQ(by_place.count(place(brick)), 1U) << brick.cell.transpose();
    ASSERT_EQ(by_place[place(brick)]->distance, brick.distance) << brick.cell.transpose();
  }
  EXPECT_LT(walked.bricks.size(), all.bricks.size() + all.bricks.size() / 100);
}

}  // namespace
}  // namespace isotouch::field
