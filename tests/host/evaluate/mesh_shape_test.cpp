#include "host/evaluate/mesh_shape.h"

#include <gtest/gtest.h>

#include <cmath>

#include "host/error.h"

namespace isotouch::evaluate {
namespace {

using Eigen::Vector3d;

/// A box of 10 x 20 x 5 somewhere.
cloud::TriangleMesh box() {
  cloud::TriangleMesh mesh;
  for (int n = 0; n < 8; ++n) mesh.vertices.emplace_back(100 + 10 * (n & 1), -7 + 20 * (n >> 1 & 1), 3 + 5 * (n >> 2));
  mesh.faces = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return mesh;
}

TEST(MeshShape, IsScaledToTheGridOfThePaperAndCentred) {
  const cloud::Shape shape = mesh_shape(box(), "box");
  EXPECT_NEAR((shape.high - Vector3d(46.5, 93, 23.25)).norm(), 0, 1e-9);
  EXPECT_NEAR(shape.distance(Vector3d::Zero()), -23.25, 1e-9);
  EXPECT_NEAR(shape.distance({46.5 + 3, 93 + 4, 0}), 5, 1e-9);
  EXPECT_NEAR((shape.normal({47, 10, 5}) - Vector3d::UnitX()).norm(), 0, 1e-12);
}

TEST(MeshShape, PointsDrawnFromItLieOnItsFaces) {
  const cloud::Shape shape = mesh_shape(box(), "box");
  const cloud::OrientedPoints points = cloud::scatter_on_shape(shape, 500, 3);
  ASSERT_EQ(points.size(), 500U);
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_NEAR(shape.distance(points.positions[i]), 0, 1e-6);
    EXPECT_NEAR(points.normals[i].cwiseAbs().maxCoeff(), 1, 1e-12);
    EXPECT_GT(shape.distance(points.positions[i] + points.normals[i]), 0);
  }
}

TEST(MeshShape, AnOpenMeshIsRefused) {
  cloud::TriangleMesh open = box();
  open.faces.pop_back();
  EXPECT_THROW(mesh_shape(open, "open"), InputError);
}

}  // namespace
}  // namespace isotouch::evaluate
