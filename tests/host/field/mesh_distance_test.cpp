#include "host/field/mesh_distance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "host/cloud/random.h"
#include "tests/host/field/box_mesh.h"

namespace isotouch::field {
namespace {

using Eigen::Vector3d;

const Vector3d kHalf{1, 2, 3};

cloud::TriangleMesh box() { return box_mesh(-kHalf, kHalf); }

Vector3d any_point(cloud::Random& random) {
  Vector3d p;
  for (double& coordinate : p) coordinate = random.uniform(-5, 5);
  return p;
}

TEST(MeshDistance, IsTheBoxesOwnEverywhere) {
  const MeshDistance distance(box());
  EXPECT_EQ(distance.crossings().faces, 0U);
  cloud::Random random(5);
  for (int i = 0; i < 20'000; ++i) {
    const Vector3d p = any_point(random);
    ASSERT_NEAR(distance(p), box_distance(kHalf, p), 1e-12) << p.transpose();
  }
}

TEST(MeshDistance, HasTheRightSignAtAReentrantCorner) {
  // A tetrahedron pushed in from one face: the sign of the nearest face's own normal fails beside its inner corner.
  cloud::TriangleMesh mesh;
  mesh.vertices = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}, {1.0, 1.0, 0.4}};
  mesh.faces = {{0, 2, 4}, {2, 1, 4}, {1, 0, 4}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};  // the bottom has its middle at (1, 1, 0.4)
  ASSERT_GT(cloud::signed_volume(mesh), 0);
  const MeshDistance distance(mesh);
  EXPECT_GT(distance({1, 1, 0.3}), 0);
  EXPECT_GT(distance({1, 1, 0.05}), 0);
  EXPECT_LT(distance({1, 1, 0.5}), 0);
  EXPECT_NEAR(distance({1, 1, 0.4}), 0, 1e-15);
  EXPECT_GT(distance({-1, -1, -1}), 0);
}

TEST(MeshDistance, ABlockOfSamplesIsTheSameAsOneByOne) {
  const MeshDistance plain(box());
  const MeshDistance crossed(together(box(), box_mesh({0, 0, 0}, {2, 3, 4})));
  cloud::Random random(6);
  int inside = 0;
  for (int i = 0; i < 300; ++i) {
    const Vector3d first = any_point(random);
    for (const MeshDistance* distance : {&plain, &crossed}) {
      const double middle = (*distance)(first + Vector3d::Constant(1.5 * 0.31));
      const auto block = distance->block(first, 0.31, std::abs(middle) / 0.31 + 1e-9);
      ASSERT_EQ(block.middle, middle);
      ASSERT_TRUE(block.points);
      ASSERT_FALSE(distance->block(first, 0.31, std::abs(middle) / 0.31 - 1e-9).points);
      for (int s = 0; s < 64; ++s) {
        const double d = (*distance)(first + 0.31 * Vector3d(s & 3, s >> 2 & 3, s >> 4));
        ASSERT_EQ((*block.points)[static_cast<std::size_t>(s)], d);
        inside += d < 0 ? 1 : 0;
      }
    }
  }
  EXPECT_GT(inside, 1000);
}

TEST(MeshDistance, OfBoxesThatRunThroughEachOtherIsThatOfTheirUnion) {
  const MeshDistance distance(together(box(), box_mesh({0, 0, 0}, {2, 3, 4})));
  EXPECT_GT(distance.crossings().faces, 0U);
  cloud::Random random(7);
  int inside = 0;
  for (int i = 0; i < 20'000; ++i) {
    const Vector3d p = any_point(random);
    const double exact = std::min(box_distance(kHalf, p), box_distance({1, 1.5, 2}, p - Vector3d(1, 1.5, 2)));
    const double d = distance(p);
    ASSERT_EQ(d < 0, exact < 0) << p.transpose();
    if (exact > 0) {
      ASSERT_NEAR(d, exact, 1e-12) << p.transpose();
    }
    inside += d < 0 ? 1 : 0;
  }
  EXPECT_GT(inside, 1000);
}

TEST(MeshDistance, OfBoxesThatShareAnEdgeIsThatOfBoth) {
  // Four faces at one edge: the sum of their normals is zero.
  cloud::TriangleMesh mesh = together(box_mesh({-1, -1, -1}, {0, 0, 1}), box_mesh({0, 0, -1}, {1, 1, 1}));
  for (auto& face : mesh.faces) {
    for (auto& v : face) v = v == 8 ? 3 : v == 12 ? 7 : v;  // the common edge runs from (0, 0, -1) to (0, 0, 1)
  }
  const MeshDistance distance(mesh);
  EXPECT_EQ(distance.crossings().faces, 0U);
  EXPECT_LT(distance({-0.1, -0.1, 0}), 0);
  EXPECT_LT(distance({0.1, 0.1, 0}), 0);
  EXPECT_GT(distance({0.1, -0.1, 0}), 0);
  EXPECT_GT(distance({-0.1, 0.1, 0}), 0);
  EXPECT_GT(distance({1e-3, -1.1e-3, 0}), 0);
}

}  // namespace
}  // namespace isotouch::field
