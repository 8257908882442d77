#include "host/field/outer_faces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "host/cloud/random.h"
#include "host/field/closed_mesh.h"
#include "host/field/mesh_distance.h"
#include "tests/host/field/box_mesh.h"

namespace isotouch::field {
namespace {

using Eigen::Vector3d;

/// A can whose ends are fans of slivers. The rim of the upper one is ragged.
cloud::TriangleMesh can(double radius, double low, std::uint32_t round, std::uint64_t seed) {
  cloud::TriangleMesh mesh;
  cloud::Random random(seed);
  for (const bool upper : {false, true}) {
    for (std::uint32_t i = 0; i < round; ++i) {
      const double angle = 2 * std::numbers::pi * i / round;
      mesh.vertices.emplace_back(radius * std::cos(angle), radius * std::sin(angle), upper ? random.uniform(-0.5, 0.5) : low);
    }
  }
  mesh.vertices.emplace_back(0, 0, low);
  mesh.vertices.emplace_back(0, 0, 0);
  for (std::uint32_t i = 0; i < round; ++i) {
    const std::uint32_t j = (i + 1) % round;
    mesh.faces.insert(mesh.faces.end(),
                      {{i, j, round + j}, {i, round + j, round + i}, {2 * round, j, i}, {2 * round + 1, round + i, round + j}});
  }
  return mesh;
}

TEST(OuterFaces, SliversThatMeetEachOtherNearlyEverywhereAreCutIntoFewParts) {
  const MeshDistance distance(together(can(25, -50, 300, 1), can(20, -45, 300, 2)));
  EXPECT_GT(distance.outer().faces.size(), 10'000U) << "they do meet";
  EXPECT_LT(distance.outer().faces.size(), 300'000U);
  EXPECT_GT(distance.coarse_parts(), 1.0 / 2048);
  EXPECT_EQ(MeshDistance(together(box_mesh({0, 0, 0}, {1, 1, 1}), box_mesh({0.5, 0.5, 0.5}, {2, 2, 2}))).coarse_parts(), 0.0);
  MeshRepair repair;
  repair.coarse = distance.coarse_parts();
  ASSERT_EQ(repair.warnings().size(), 1U);
  EXPECT_NE(repair.warnings()[0].find("unite the pieces"), std::string::npos);
  cloud::Random random(3);
  int asked = 0;
  for (int i = 0; i < 1'000; ++i) {
    const double angle = random.uniform(0, 2 * std::numbers::pi), radius = random.uniform(0, 15), height = random.uniform(-40, 20);
    const Vector3d p(radius * std::cos(angle), radius * std::sin(angle), height);
    if (std::abs(height) < 1) continue;
    ++asked;
    ASSERT_EQ(distance(p) < 0, height < 0) << p.transpose();
    ASSERT_NEAR(std::abs(distance(p)), std::abs(std::max({height, radius - 25, -50 - height})), 0.6) << p.transpose();
  }
  EXPECT_GT(asked, 900);
}

}  // namespace
}  // namespace isotouch::field
