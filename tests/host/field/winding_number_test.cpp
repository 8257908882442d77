#include "host/field/winding_number.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "host/cloud/random.h"
#include "tests/host/field/box_mesh.h"
#include "tests/support/accuracy.h"

namespace isotouch::field {
namespace {

using Eigen::Vector3d;

TEST(WindingNumber, CountsHowOftenBoxesEncloseAPoint) {
  const cloud::TriangleMesh mesh =
      together(together(box_mesh({-3, -3, -3}, {3, 3, 3}), box_mesh({-1, -2, -2}, {5, 2, 2})), turned(box_mesh({-2, -1, -1}, {2, 1, 1})));
  const FaceTree tree(mesh);
  const WindingNumber winding(tree);
  EXPECT_NEAR(winding({10, 0, 0}), 0, 0.1);
  EXPECT_NEAR(winding({4, 1.5, 1.5}), 1, 0.1);
  EXPECT_NEAR(winding({2.5, 0, 0}), 2, 0.1);
  EXPECT_NEAR(winding({0, 0, 0}), 1, 0.1);     // inside both, and in the hollow
  EXPECT_NEAR(winding({-1.5, 0, 0}), 0, 0.1);  // inside the first alone, and in the hollow
}

TEST(WindingNumber, OfAFineSphereIsWholeThroughTheTree) {
  constexpr std::uint32_t kRings = 60, kSides = 90;
  cloud::TriangleMesh mesh;
  for (std::uint32_t ring = 0; ring <= kRings; ++ring) {
    for (std::uint32_t side = 0; side < kSides; ++side) {
      const double polar = M_PI * ring / kRings;
      const double around = 2 * M_PI * side / kSides;
      mesh.vertices.emplace_back(std::sin(polar) * std::cos(around), std::sin(polar) * std::sin(around), std::cos(polar));
    }
  }
  for (std::uint32_t ring = 0; ring < kRings; ++ring) {
    for (std::uint32_t side = 0; side < kSides; ++side) {
      const std::uint32_t here = ring * kSides + side;
      const std::uint32_t beside = ring * kSides + (side + 1) % kSides;
      mesh.faces.push_back({here, here + kSides, beside});
      mesh.faces.push_back({beside, here + kSides, beside + kSides});
    }
  }
  const FaceTree tree(mesh);
  const WindingNumber winding(tree);
  cloud::Random random(3);
  double worst = 0;
  int inside = 0;
  for (int i = 0; i < 4000; ++i) {
    const Vector3d p(random.uniform(-1.5, 1.5), random.uniform(-1.5, 1.5), random.uniform(-1.5, 1.5));
    if (std::abs(p.norm() - 1) < 0.01) continue;
    worst = std::max(worst, std::abs(winding(p) - (p.norm() < 1 ? 1 : 0)));
    inside += p.norm() < 1 ? 1 : 0;
  }
  EXPECT_THAT(worst, test::IsAccuracyOf(0.052));
  EXPECT_GT(inside, 500);
}

}  // namespace
}  // namespace isotouch::field
