#include "host/field/face_crossings.h"

#include <gtest/gtest.h>

#include "tests/host/field/box_mesh.h"

namespace isotouch::field {
namespace {

FaceCrossings crossings_of(const cloud::TriangleMesh& mesh) { return face_crossings(mesh, FaceTree(mesh)); }

TEST(FaceCrossings, AnEdgeCanRunThroughAFaceThatHasACornerWithBothItsFaces) {
  // A box whose one top corner is raised, and the middle of its top moved so far to the side that a fold of the top hangs through the wall.
  cloud::TriangleMesh mesh;
  mesh.vertices = {{-10, -10, -10}, {10, -10, -10}, {-10, 10, -10}, {10, 10, -10}, {-10, -10, 10},
                   {10, -10, 13},   {-10, 10, 10},  {10, 10, 10},   {-5, 5, 9}};
  mesh.faces = {{0, 2, 3}, {0, 3, 1}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4}, {2, 6, 7}, {2, 7, 3},
                {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}, {4, 5, 8}, {5, 7, 8}, {7, 4, 8}};
  EXPECT_GT(crossings_of(mesh).faces, 0U);
  mesh.vertices[8] = {-2, 3, 11};  // above the face that it hung through
  EXPECT_EQ(crossings_of(mesh).faces, 0U);
}

TEST(FaceCrossings, FacesThatLieOnEachOtherLikeTheBarsOfAPlusTouch) {
  const auto bars = [](double gap) { return together(box_mesh({-2, -1, -1}, {2, 1, 0}), box_mesh({-1, -2, gap}, {1, 2, 1})); };
  constexpr double size = 6;  // of their box's diagonal
  EXPECT_TRUE(crossings_of(bars(0)).touching) << "no corner of one lies on the other";
  EXPECT_EQ(crossings_of(bars(0)).faces, 0U);
  EXPECT_TRUE(crossings_of(bars(5e-7 * size)).touching) << "as far as rounding to floats may part them";
  EXPECT_FALSE(crossings_of(bars(2e-6 * size)).touching);
  EXPECT_FALSE(crossings_of(bars(0.1)).touching);
}

}  // namespace
}  // namespace isotouch::field
