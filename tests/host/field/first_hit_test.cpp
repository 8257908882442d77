#include "host/field/first_hit.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

#include "host/cloud/random.h"
#include "tests/host/field/random_places.h"

namespace isotouch::field {
namespace {

using Eigen::Vector3d;

TEST(FirstHit, TheFirstFaceIsThatOfAllFacesAskedInTurn) {
  cloud::Random random(5);
  cloud::TriangleMesh mesh;
  for (std::uint32_t i = 0; i < 300; ++i) {
    const Vector3d middle = draw(random, 10);
    for (int corner = 0; corner < 3; ++corner) mesh.vertices.push_back(middle + draw(random, 2));
    mesh.faces.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  const TriangleTree tree(mesh);
  int met = 0;
  for (int n = 0; n < 500; ++n) {
    const Vector3d from = draw(random, 15);
    const Vector3d direction = (draw(random, 8) - from).normalized();
    double nearest = std::numeric_limits<double>::max();
    for (std::uint32_t face = 0; face < mesh.faces.size(); ++face) {
      const auto [a, b, c] = tree.corners(face);
      Eigen::Matrix3d sides;
      sides << b - a, c - a, -direction;
      const Vector3d uvt = sides.inverse() * (from - a);
      if (uvt.x() >= 0 && uvt.y() >= 0 && uvt.x() + uvt.y() <= 1 && uvt.z() >= 0) nearest = std::min(nearest, uvt.z());
    }
    const auto hit = first_hit(tree, from, direction);
    ASSERT_EQ(hit.has_value(), nearest < 1e300);
    if (!hit) continue;
    ++met;
    EXPECT_NEAR(hit->t, nearest, 1e-9);
    EXPECT_EQ(hit->from_inside, hit->normal.dot(direction) > 0);
    const auto second = first_hit(tree, from, direction, hit->t + 1e-6);
    EXPECT_TRUE(!second || second->t > hit->t);
  }
  EXPECT_GT(met, 100);
}

}  // namespace
}  // namespace isotouch::field
