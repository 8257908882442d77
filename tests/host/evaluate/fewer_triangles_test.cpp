#include "host/evaluate/fewer_triangles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "host/evaluate/zero_surface.h"
#include "host/motion/felt_surface.h"
#include "tests/support/accuracy.h"
#include "tests/support/field_image.h"

namespace isotouch::evaluate {
namespace {

constexpr double kVoxel = 0.34;

/// Handles are lost or made where this changes: V - E + F.
long euler(const cloud::TriangleMesh& mesh) { return static_cast<long>(mesh.vertices.size()) - static_cast<long>(mesh.faces.size()) / 2; }

/// The farthest middle of a face or of a side, voxels.
double farthest_middle(const cloud::TriangleMesh& mesh, const FieldView& field) {
  const motion::FeltSurface felt(field);
  double worst = 0;
  for (const auto& [a, b, c] : mesh.faces) {
    const Eigen::Vector3d &p = mesh.vertices[a], &q = mesh.vertices[b], &r = mesh.vertices[c];
    for (const Eigen::Vector3d& place : {Eigen::Vector3d((p + q + r) / 3), Eigen::Vector3d((p + q) / 2)})
      worst = std::max(worst, std::abs(felt.sample(place).distance) / kVoxel);
  }
  return worst;
}

struct Both {
  cloud::TriangleMesh all, fewer;
};

Both surfaces(const FieldView& field) {
  Both both{zero_surface(field, Corners::kApart), {}};
  both.fewer = fewer_triangles(field, both.all);
  EXPECT_NO_THROW(cloud::require_closed(both.fewer, "fewer"));
  EXPECT_EQ(euler(both.fewer), euler(both.all));
  for (std::size_t face = 0; face < both.fewer.faces.size(); ++face) EXPECT_GT(cloud::face_normal(both.fewer, face).norm(), 0.5);
  return both;
}

TEST(FewerTriangles, ABallKeepsItsShapeWithAFiftiethOfThem) {
  const test::FieldImage image({61, 61, 61}, [](const test::Point& p) {
    return test::length({p[0] - 30.2, p[1] - 29.7, p[2] - 30.4}) - 20;
  });
  const auto [all, fewer] = surfaces(image.view());
  EXPECT_LT(fewer.faces.size(), all.faces.size() / 20);
  EXPECT_GT(fewer.faces.size(), all.faces.size() / 100);
  EXPECT_THAT(farthest_middle(fewer, image.view()), test::IsAccuracyOf(kSurfaceTolerance + 1e-4));
  EXPECT_NEAR(volume(pieces(fewer)) / volume(pieces(all)), 1, 5e-3);
}

TEST(FewerTriangles, HandlesHollowsAndSpecksStay) {
  const test::FieldImage image({61, 61, 61}, [](const test::Point& p) {
    const double around = std::hypot(p[0] - 30.1, p[1] - 30.3) - 16;
    const double ring = std::hypot(around, p[2] - 30.2) - 6;
    const double hollow = test::length({p[0] - 46.1, p[1] - 30.3, p[2] - 30.2}) - 2;
    const double speck = test::length({p[0] - 30.1, p[1] - 30.3, p[2] - 30.2}) - 1.5;
    return std::min(std::max(ring, -hollow), speck);
  });
  const auto [all, fewer] = surfaces(image.view());
  EXPECT_EQ(euler(fewer), 4) << "a ring has 0, each ball 2";
  EXPECT_EQ(pieces(fewer).size(), 3U);
  EXPECT_LT(fewer.faces.size(), all.faces.size() / 5);
}

TEST(FewerTriangles, ABoxKeepsItsEdges) {
  const test::FieldImage image({48, 48, 48}, [](const test::Point& p) {
    return std::max({std::abs(p[0] - 23.2) - 10, std::abs(p[1] - 23.5) - 10, std::abs(p[2] - 24) - 10});
  });
  const auto [all, fewer] = surfaces(image.view());
  EXPECT_LT(fewer.faces.size(), all.faces.size() / 10);
  EXPECT_NEAR(volume(pieces(fewer)) / volume(pieces(all)), 1, 2e-3);
  EXPECT_LT(farthest_middle(fewer, image.view()), farthest_middle(all, image.view()) + kSurfaceTolerance);
}

}  // namespace
}  // namespace isotouch::evaluate
