#include "host/field/face_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "host/cloud/random.h"
#include "tests/host/field/random_places.h"
#include "tests/host/field/triangle_soup.h"

namespace isotouch::field {
namespace {

using Eigen::Vector3d;

double square_to(const FaceTree& tree, const Vector3d& point, std::uint32_t face) {
  return (point - nearest_on_triangle(point, tree.faces()[face].corners).point).squaredNorm();
}

TEST(FaceTree, TheNearestPlaceIsThatOfAllFacesToTheLastBitWhereverTheSearchBegins) {
  for (const std::size_t count : {1U, 2U, 4U, 5U, 16U, 17U, 64U, 1000U}) {
    // About the origin, away from it, and so small there that the floats of the boxes are as coarse as the faces.
    for (const auto& [size, away] : {std::pair(1.0, 0.0), std::pair(1.0, 300.0), std::pair(1e-4, 300.0)}) {
      cloud::TriangleMesh mesh = soup(count);
      for (std::size_t face = 0; face < count; ++face) mesh.faces.push_back(mesh.faces[face]);  // each twice: equally near
      for (Vector3d& vertex : mesh.vertices) vertex = size * vertex + Vector3d(away, -away, away);
      const FaceTree tree(mesh);
      cloud::Random random(8);
      for (int i = 0; i < 200; ++i) {
        const Vector3d point = size * draw(random, i % 2 == 0 ? 14 : 2000) + Vector3d(away, -away, away);
        double least = std::numeric_limits<double>::max();
        std::uint32_t nearest = 0;
        for (std::uint32_t face = 0; face < tree.faces().size(); ++face) {
          if (const double square = square_to(tree, point, face); square < least) least = square, nearest = face;
        }
        const FaceTree::Place place = tree.nearest(point, static_cast<std::uint32_t>(random.bits() % tree.faces().size()), tree.whole());
        ASSERT_EQ(place.square, least);
        ASSERT_EQ(place.face, nearest);
        ASSERT_EQ(place.offset.squaredNorm(), least);
        ASSERT_GE(square_to(tree, point, tree.near(point)), least);
      }
    }
  }
}

TEST(FaceTree, NeedlesAndPointsAreFoundToTheLastBit) {
  cloud::TriangleMesh mesh = soup(400);
  cloud::Random random(12);
  for (std::size_t face = 0; face < mesh.faces.size();
       ++face) {  // the third corner on the line of the others, but for rounding, or on one of them
    const auto& [a, b, c] = mesh.faces[face];
    const double share = face % 3 == 0 ? 1 : random.uniform(-0.5, 1.5);
    mesh.vertices[c] = mesh.vertices[a] + share * (mesh.vertices[b] - mesh.vertices[a]);
    if (face % 5 == 0) mesh.vertices[b] = mesh.vertices[c] = mesh.vertices[a];
  }
  const FaceTree tree(mesh);
  for (int i = 0; i < 1000; ++i) {
    const Vector3d point = draw(random, 14);
    double least = std::numeric_limits<double>::max();
    for (std::uint32_t face = 0; face < tree.faces().size(); ++face) least = std::fmin(least, square_to(tree, point, face));
    ASSERT_EQ(tree.nearest(point).square, least);
  }
}

TEST(FaceTree, APartAnswersForItsRegionAsTheWholeTree) {
  const cloud::TriangleMesh mesh = soup(3000);
  const FaceTree tree(mesh);
  cloud::Random random(11);
  std::size_t smaller = 0;
  for (int i = 0; i < 200; ++i) {
    const Vector3d middle = draw(random, 14);
    const double reach = random.uniform(0, 0.5);
    const FaceTree::Part part = tree.part(middle, std::sqrt(tree.nearest(middle).square) + 2 * reach);
    smaller += part.nodes[0] != tree.whole().nodes[0] ? 1U : 0U;
    for (int j = 0; j < 10; ++j) {
      const Vector3d point = middle + draw(random, 1).normalized() * random.uniform(0, reach);
      const FaceTree::Place whole = tree.nearest(point), found = tree.nearest(point, 0, part);
      ASSERT_EQ(found.square, whole.square);
      ASSERT_EQ(found.face, whole.face);
    }
  }
  EXPECT_GT(smaller, 100U);
}

TEST(FaceTree, EveryFaceWithinTheDistanceIsCalledOnce) {
  const cloud::TriangleMesh mesh = soup(500);
  const FaceTree tree(mesh);
  std::vector<std::uint32_t> numbers;
  for (const FaceTree::Face& face : tree.faces()) numbers.push_back(face.number);
  std::sort(numbers.begin(), numbers.end());
  for (std::uint32_t n = 0; n < numbers.size(); ++n) ASSERT_EQ(numbers[n], n);
  cloud::Random random(9);
  std::size_t within = 0;
  for (int i = 0; i < 100; ++i) {
    const Vector3d point = draw(random, 12);
    const double square = random.uniform(0, 20);
    std::vector<int> calls(mesh.faces.size(), 0);
    tree.each_near(point, std::sqrt(square), [&](std::uint32_t face) { ++calls[face]; });
    for (std::uint32_t face = 0; face < calls.size(); ++face) {
      const bool is_within = square_to(tree, point, face) <= square;
      within += is_within ? 1 : 0;
      ASSERT_LE(calls[face], 1);
      ASSERT_TRUE(calls[face] == 1 || !is_within);
    }
  }
  EXPECT_GT(within, 500U);
}

TEST(FaceTree, AboveASmoothSurfaceFewFacesAreAsked) {
  constexpr std::uint32_t kSide = 100;
  const auto height = [](double x, double y) { return 0.004 * (x * x - x * y); };
  cloud::TriangleMesh mesh;
  for (std::uint32_t y = 0; y <= kSide; ++y) {
    for (std::uint32_t x = 0; x <= kSide; ++x) {
      const double u = 0.4 * x - 20, v = 0.4 * y - 20;
      mesh.vertices.emplace_back(u, v, u + height(u, v));  // askew to all coordinates
      if (x == 0 || y == 0) continue;
      const std::uint32_t here = y * (kSide + 1) + x, below = here - kSide - 1;
      mesh.faces.push_back({below - 1, below, here});
      mesh.faces.push_back({below - 1, here, here - 1});
    }
  }
  const FaceTree tree(mesh);
  cloud::Random random(10);
  std::size_t asked = 0;
  constexpr std::size_t kPoints = 1000;
  for (std::size_t i = 0; i < kPoints; ++i) {
    const double u = random.uniform(-10, 10), v = random.uniform(-10, 10), above = random.uniform(0, 3);
    const Vector3d point(u - above, v, u + height(u, v) + above);
    const double square = tree.nearest(point).square;
    tree.each_near(point, std::sqrt(square), [&](std::uint32_t) { ++asked; });
  }
  EXPECT_LT(asked, 2 * kPoints);
  EXPECT_GE(asked, kPoints);
}

}  // namespace
}  // namespace isotouch::field
