#include "host/evaluate/god_object.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "host/cloud/random.h"
#include "host/field/line_crossings.h"
#include "tests/host/evaluate/box_mesh.h"

namespace isotouch::evaluate {
namespace {

using Eigen::Vector3d;

void add(cloud::TriangleMesh& mesh, const cloud::TriangleMesh& other) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), other.vertices.begin(), other.vertices.end());
  for (const auto& [a, b, c] : other.faces) mesh.faces.push_back({a + first, b + first, c + first});
}

TEST(GodObject, InFreeSpaceItIsTheHand) {
  const auto mesh = box({-1, -1, -1}, {1, 1, 1});
  const field::TriangleTree tree(mesh);
  GodObject object(tree, {0, 0, 5});
  EXPECT_EQ(object.follow({3, 3, 3}), Vector3d(3, 3, 3));
  EXPECT_FALSE(object.touching());
}

TEST(GodObject, OnAFaceItIsTheNearestPointOnIt) {
  const auto mesh = box({-1, -1, -1}, {1, 1, 1});
  const field::TriangleTree tree(mesh);
  GodObject object(tree, {0.2, 0.1, 5});
  EXPECT_LT((object.follow({0.3, -0.2, 0.4}) - Vector3d(0.3, -0.2, 1)).norm(), 1e-8);
  EXPECT_TRUE(object.touching());
  EXPECT_LT((object.follow({-0.9, 0.8, 0.1}) - Vector3d(-0.9, 0.8, 1)).norm(), 1e-8);
}

TEST(GodObject, InACornerItRestsOnThreePlanes) {
  cloud::TriangleMesh mesh = box({0, 0, 0}, {10, 10, 1});
  add(mesh, box({0, 0, 1}, {1, 10, 10}));
  add(mesh, box({1, 0, 1}, {10, 1, 10}));
  const field::TriangleTree tree(mesh);
  GodObject object(tree, {5, 6, 7});
  EXPECT_LT((object.follow({0.5, 0.2, 0.4}) - Vector3d(1, 1, 1)).norm(), 1e-8);
  EXPECT_LT((object.follow({0.5, 4, 0.4}) - Vector3d(1, 4, 1)).norm(), 1e-8);
  EXPECT_LT((object.follow({5, 4, 0.4}) - Vector3d(5, 4, 1)).norm(), 1e-8);
}

TEST(GodObject, ItNeverPassesTheMeshWhateverTheHandDoes) {
  cloud::TriangleMesh mesh = box({-3, -3, -3}, {3, 3, 3});
  add(mesh, box({2, -0.05, -5}, {9, 0.05, 5}));  // a thin wing that runs into the body
  add(mesh, box({-5, -5, 4}, {5, 5, 4.001}));    // a foil
  const field::TriangleTree tree(mesh);
  cloud::Random random(3);
  const auto draw = [&](double half) {
    const double x = random.uniform(-half, half), y = random.uniform(-half, half);
    return Vector3d(x, y, random.uniform(-half, half));
  };
  GodObject object(tree, {0, 0, 20});
  Vector3d hip(0, 0, 20);
  std::size_t touching = 0;
  for (int tick = 0; tick < 20000; ++tick) {
    const Vector3d before = object.position();
    hip = tick % 50 == 0 ? draw(10) : Vector3d(hip + draw(0.3));
    if (tick % 7 == 0) hip = Vector3d(std::round(hip.x()), std::round(hip.y()), hip.z());  // exactly over edges and corners
    object.follow(hip);
    touching += object.touching() ? 1U : 0U;
    ASSERT_FALSE(field::is_inside(tree, object.position())) << tick << ": " << object.position().transpose();
    EXPECT_LE((object.position() - hip).norm(), (before - hip).norm() + 1e-9) << "it moved away from the hand";
  }
  EXPECT_GT(touching, 1000U);
  EXPECT_LT(touching, 20000U);
}

TEST(GodObject, AFoilIsAWall) {
  const auto mesh = box({-100, -100, 0}, {100, 100, 1e-6});
  const field::TriangleTree tree(mesh);
  cloud::Random random(4);
  GodObject object(tree, {0, 0, 5});
  for (int tick = 0; tick < 5000; ++tick) {
    const double x = random.uniform(-50, 50), y = random.uniform(-50, 50);
    object.follow({x, y, random.uniform(-30, 5)});
    ASSERT_GT(object.position().z(), 1e-6);
  }
}

}  // namespace
}  // namespace isotouch::evaluate
