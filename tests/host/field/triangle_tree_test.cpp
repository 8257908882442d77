#include "host/field/triangle_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include "host/cloud/random.h"
#include "tests/host/field/random_places.h"
#include "tests/host/field/triangle_soup.h"

namespace isotouch::field {
namespace {

using Eigen::Vector3d;

TEST(TriangleTree, TheNearestPlaceIsThatOfAllFacesAskedInTurn) {
  for (const std::size_t count : {1U, 2U, 5U, 64U, 1000U}) {
    const cloud::TriangleMesh mesh = soup(count);
    const TriangleTree tree(mesh);
    cloud::Random random(8);
    for (int i = 0; i < 200; ++i) {
      const Vector3d point = draw(random, 14);
      double nearest = std::numeric_limits<double>::max();
      for (std::uint32_t face = 0; face < mesh.faces.size(); ++face) {
        nearest = std::min(nearest, (nearest_on_triangle(point, tree.corners(face)).point - point).norm());
      }
      const TriangleTree::Foot foot = tree.nearest(point);
      EXPECT_NEAR(foot.distance, nearest, 1e-12);
      EXPECT_NEAR((foot.point - point).norm(), foot.distance, 1e-12);
      EXPECT_NEAR((nearest_on_triangle(point, tree.corners(foot.face)).point - point).norm(), foot.distance, 1e-12);
      const double enough = nearest * random.uniform(0.5, 3);
      const double found = tree.nearest(point, enough, static_cast<std::uint32_t>(random.bits() % count)).distance;
      EXPECT_GE(found, nearest - 1e-12);
      EXPECT_LE(found, std::max(nearest, enough) + 1e-12);
    }
  }
}

TEST(TriangleTree, AVisitMissesNoFaceThatItsQuestionWants) {
  const cloud::TriangleMesh mesh = soup(500);
  const TriangleTree tree(mesh);
  const double x = 1.25;
  std::vector<int> seen(mesh.faces.size(), 0);
  tree.visit([&](const TriangleTree::Box& box) { return box.low.x() <= x && x <= box.high.x(); },
             [&](std::uint32_t face) { ++seen[face]; });
  std::size_t across = 0;
  for (std::uint32_t face = 0; face < mesh.faces.size(); ++face) {
    const Corners at = tree.corners(face);
    const bool meets = std::min({at[0].x(), at[1].x(), at[2].x()}) <= x && x <= std::max({at[0].x(), at[1].x(), at[2].x()});
    across += meets ? 1 : 0;
    EXPECT_LE(seen[face], 1);
    EXPECT_TRUE(!meets || seen[face] == 1);
  }
  EXPECT_GT(across, 10U);
}

TEST(TriangleTree, EveryPartOfATriangleIsNamedAsItIs) {
  const Corners triangle = {Vector3d(0, 0, 0), Vector3d(4, 0, 0), Vector3d(0, 4, 0)};
  const std::pair<Vector3d, int> cases[] = {{{-1, -1, 1}, 0}, {{6, -1, 1}, 1}, {{-1, 6, 1}, 2}, {{2, -1, 1}, 3},
                                            {{3, 3, 1}, 4},   {{-1, 2, 1}, 5}, {{1, 1, 1}, 6}};
  for (const auto& [point, feature] : cases) EXPECT_EQ(nearest_on_triangle(point, triangle).feature, feature) << point.transpose();
}

}  // namespace
}  // namespace isotouch::field
