#include "host/evaluate/mesh_distance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "host/cloud/random.h"

namespace isotouch::evaluate {
namespace {

using Eigen::Vector3d;

/// The box [-1, 1] x [-2, 2] x [-3, 3]: faces, edges and corners are all nearest somewhere.
cloud::TriangleMesh box() {
  cloud::TriangleMesh mesh;
  for (int i = 0; i < 8; ++i) mesh.vertices.emplace_back((i & 1) != 0 ? 1 : -1, (i & 2) != 0 ? 2 : -2, (i & 4) != 0 ? 3 : -3);
  mesh.faces = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return mesh;
}

double exact(const Vector3d& p) {
  const Vector3d q = p.cwiseAbs() - Vector3d(1, 2, 3);
  return q.cwiseMax(0).norm() + std::min(q.maxCoeff(), 0.0);
}

TEST(MeshDistance, IsTheBoxesOwnEverywhere) {
  const MeshDistance distance(box());
  cloud::Random random(5);
  for (int i = 0; i < 20'000; ++i) {
    Vector3d p;
    for (double& coordinate : p) coordinate = random.uniform(-5, 5);
    ASSERT_NEAR(distance(p), exact(p), 1e-12) << p.transpose();
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

}  // namespace
}  // namespace isotouch::evaluate
