#include "host/field/line_crossings.h"

#include <gtest/gtest.h>

#include "tests/host/field/box_mesh.h"

namespace isotouch::field {
namespace {

TEST(LineCrossings, CountHowOftenBoxesEncloseAPoint) {
  const cloud::TriangleMesh mesh =
      together(together(box_mesh({-3, -3, -3}, {3, 3, 3}), box_mesh({-1, -2, -2}, {5, 2, 2})), turned(box_mesh({-2, -1, -1}, {2, 1, 1})));
  const TriangleTree tree(mesh);
  EXPECT_EQ(turns_round(tree, {10, 0, 0}), 0);
  EXPECT_EQ(turns_round(tree, {-10, 0, 0}), 0);
  EXPECT_EQ(turns_round(tree, {4, 1.5, 1.5}), 1);
  EXPECT_EQ(turns_round(tree, {2.5, 0, 0}), 2);
  EXPECT_EQ(turns_round(tree, {0, 0, 0}), 1);     // inside both, and in the hollow
  EXPECT_EQ(turns_round(tree, {-1.5, 0, 0}), 0);  // inside the first alone, and in the hollow
  EXPECT_EQ(turns_round(TriangleTree(turned(mesh)), {2.5, 0, 0}), -2);
}

TEST(LineCrossings, ALineThroughEdgesAndCornersCountsEachSurfaceOnce) {
  const cloud::TriangleMesh mesh = box_mesh({0, 0, 0}, {2, 2, 2});
  const TriangleTree tree(mesh);
  for (const double y : {0.0, 0.5, 1.0, 2.0}) {
    for (const double z : {0.0, 0.5, 1.0, 2.0}) {
      int turns = 0, crossings = 0;
      each_crossing(tree, y, z, [&](double, int turn) { turns += turn, ++crossings; });
      EXPECT_EQ(turns, 0) << y << ' ' << z;
      EXPECT_TRUE(crossings == 0 || crossings == 2) << y << ' ' << z;
      const bool within = y > 0 && y < 2 && z > 0 && z < 2;
      EXPECT_TRUE(!within || crossings == 2) << y << ' ' << z;
    }
  }
}

}  // namespace
}  // namespace isotouch::field
