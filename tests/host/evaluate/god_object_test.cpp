#include "host/evaluate/god_object.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "host/cloud/random.h"
#include "host/field/line_crossings.h"
#include "tests/host/evaluate/ball_mesh.h"
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

Vector3d draw(cloud::Random& random, double half) {
  const double x = random.uniform(-half, half), y = random.uniform(-half, half);
  return {x, y, random.uniform(-half, half)};
}

TEST(GodObject, SettledOnABallItIsOnTheSurfaceInEveryTick) {
  const auto mesh = ball(20, 5);
  const field::TriangleTree tree(mesh);
  cloud::Random random(5);
  GodObject object(tree, {0, 0, 30}), one_pass(tree, {0, 0, 30});
  Vector3d way(0, 0, 1);
  double height = 0, height_of_one_pass = 0, farther = 0;
  for (int tick = 0; tick < 3000; ++tick) {
    way = (way + draw(random, 0.02)).normalized();
    const Vector3d hip = 19.5 * way;
    height = std::max(height, tree.nearest(object.settle(hip)).distance);
    height_of_one_pass = std::max(height_of_one_pass, tree.nearest(one_pass.follow(hip)).distance);
    farther = std::max(farther, (object.position() - hip).norm() - tree.nearest(hip).distance);
  }
  EXPECT_LT(height, 1e-7);
  EXPECT_GT(height_of_one_pass, 1e-3) << "then one pass would do";
  // It stays on a face as long as its foot does, also where the next face is a little nearer: half of 0.5 mm times the square of their angle.
  EXPECT_LT(farther, 1e-3);
  EXPECT_GT(farther, 1e-5);
}

TEST(GodObject, InACreaseItRestsOnBothWallsAndOnAWedgeItStaysOnItsSide) {
  cloud::TriangleMesh crease = box({-10, -10, -2}, {10, 10, 0});
  add(crease, box({-10, -10, 0}, {0, 10, 10}));
  const field::TriangleTree walls(crease);
  GodObject held(walls, {5, 0, 5});
  EXPECT_LT((held.settle({-0.4, 3, -0.3}) - Vector3d(0, 3, 0)).norm(), 1e-6);
  EXPECT_LT((held.settle({2, 3, -0.3}) - Vector3d(2, 3, 0)).norm(), 1e-6);

  // The edge at x = 0, z = 0, with 30 degrees of body below it.
  const double slope = std::tan(std::numbers::pi / 12);
  cloud::TriangleMesh wedge;
  wedge.vertices = {{0, -10, 0},          {0, 10, 0}, {-10, -10, -10 * slope}, {-10, 10, -10 * slope}, {-10, -10, 10 * slope},
                    {-10, 10, 10 * slope}};
  wedge.faces = {{0, 1, 5}, {0, 5, 4}, {1, 0, 2}, {1, 2, 3}, {2, 4, 5}, {2, 5, 3}, {0, 4, 2}, {1, 3, 5}};
  cloud::require_closed(wedge, "wedge");
  const field::TriangleTree tree(wedge);
  GodObject on_top(tree, {-5, 0, 5});
  const Vector3d top = Vector3d(slope, 0, 1).normalized();
  for (double depth = 0; depth < 2; depth += 0.05) {  // through the middle, where the other side becomes the nearer one, and out there
    const Vector3d place = on_top.settle({-5, 0, 5 * slope - depth});
    EXPECT_NEAR(top.dot(place), 0, 1e-6);
    EXPECT_GT(place.z(), 0);
  }
  // Round the edge it gets to the other side.
  on_top.settle({3, 0, 0});
  EXPECT_FALSE(on_top.touching());
  on_top.settle({-3, 0, -3});
  EXPECT_LT(on_top.settle({-5, 0, -5 * slope + 0.2}).z(), 0);
}

TEST(GodObject, AThinPlateStopsAHandOfOneMetreASecond) {
  const auto mesh = box({-30, -30, 0}, {30, 30, 0.05});
  const field::TriangleTree tree(mesh);
  cloud::Random random(6);
  for (int stab = 0; stab < 500; ++stab) {
    const Vector3d way = (Vector3d(0, 0, -1) + draw(random, 0.5)).normalized();  // 1 mm a tick
    Vector3d hip = Vector3d(random.uniform(-10, 10), random.uniform(-10, 10), 3 + random.uniform());
    GodObject object(tree, hip);
    for (int tick = 0; tick < 12; ++tick) {
      hip += way;
      object.settle(hip);
      ASSERT_GE(object.position().z(), 0.05) << stab << ", tick " << tick;
    }
    EXPECT_TRUE(object.touching());
    EXPECT_NEAR((object.position() - hip).norm(), 0.05 - hip.z(), 1e-6) << "straight above the hand: no friction";
  }
}

TEST(GodObject, SettledItPassesNoWallInAHundredThousandTicks) {
  cloud::TriangleMesh mesh = ball(6, 3);
  add(mesh, box({2, -0.05, -9}, {9, 0.05, 9}));  // a thin wing that runs into the body
  add(mesh, box({-9, -9, 7}, {9, 9, 7.001}));    // a foil
  const field::TriangleTree tree(mesh);
  cloud::Random random(7);
  GodObject object(tree, {0, 0, 20});
  Vector3d hip(0, 0, 20);
  std::size_t touching = 0;
  for (int tick = 0; tick < 100'000; ++tick) {
    const Vector3d before = object.position();
    hip = tick % 50 == 0 ? draw(random, 12) : Vector3d(hip + draw(random, 0.6));  // up to 1 m/s, and jumps
    object.settle(hip);
    touching += object.touching() ? 1U : 0U;
    ASSERT_FALSE(field::is_inside(tree, object.position())) << tick << ": " << object.position().transpose();
    ASSERT_LE((object.position() - hip).norm(), (before - hip).norm() + 1e-9) << "it moved away from the hand";
    if (tick % 10 != 0) continue;
    const Vector3d place = object.position();
    ASSERT_LT((object.settle(hip) - place).norm(), 1e-4) << tick << ": it had not arrived";
  }
  EXPECT_GT(touching, 15'000U);
  EXPECT_LT(touching, 100'000U);
}

TEST(GodObject, SettledItPassesNoWallAtAVertexWhereSteepFacesMeet) {
  for (const std::uint64_t seed : {1U, 3U, 4U}) {
    cloud::Random random(seed);
    cloud::TriangleMesh mesh = ball(6, 4);
    for (Vector3d& vertex : mesh.vertices) vertex *= random.uniform(0.6, 1);
    const field::TriangleTree tree(mesh);
    GodObject object(tree, {0, 0, 20});
    Vector3d hip(0, 0, 20);
    for (int tick = 0; tick < 6'000; ++tick) {
      hip = tick % 40 == 0 ? draw(random, 9) : Vector3d(hip + draw(random, 0.4));
      object.settle(hip);
      ASSERT_FALSE(field::is_inside(tree, object.position()))
          << "seed " << seed << ", tick " << tick << ": " << object.position().transpose();
    }
  }
}

TEST(GodObject, SettledItRestsWhereNoPlaceRoundItIsNearer) {
  cloud::Random random(9);
  cloud::TriangleMesh mesh = ball(6, 3);
  for (Vector3d& vertex : mesh.vertices) vertex *= random.uniform(0.85, 1);  // pits, peaks, and saddles of every kind
  const field::TriangleTree tree(mesh);
  GodObject object(tree, {0, 0, 20});
  Vector3d hip(0, 0, 20);
  std::size_t touching = 0, farther = 0;
  for (int tick = 0; tick < 40'000; ++tick) {
    hip = tick % 40 == 0 ? draw(random, 9) : Vector3d(hip + draw(random, 0.4));
    const Vector3d place = object.settle(hip);
    if (!object.touching()) continue;
    ++touching;
    bool is_nearest = true;
    for (int i = 0; i < 16; ++i) {
      const Vector3d foot = tree.nearest(place + draw(random, 1e-4)).point;  // a place beside it on the surface
      const Vector3d middle = (foot + place) / 2;
      if (field::is_inside(tree, middle + 1e-7 * (place - hip).normalized())) continue;  // not by a straight way
      is_nearest = is_nearest && (foot - hip).norm() > (place - hip).norm() - 1e-6;
    }
    farther += is_nearest ? 0U : 1U;
  }
  EXPECT_GT(touching, 5000U);
  EXPECT_EQ(farther, 0U);
}

/// Work of a unit spring on the hand along a closed way, by the trapezoidal rule.
double work_of_cycle(const field::TriangleTree& tree, const Vector3d& start, const std::vector<Vector3d>& corners, double step) {
  GodObject object(tree, start);
  Vector3d hip = start, force = Vector3d::Zero();
  double work = 0;
  const auto go = [&](const Vector3d& to) {
    const double steps = std::ceil((to - hip).norm() / step);
    const Vector3d from = hip;
    for (double i = 1; i <= steps; ++i) {
      const Vector3d next = from + i / steps * (to - from);
      const Vector3d now = object.settle(next) - next;
      work += (force + now).dot(next - hip) / 2;
      hip = next;
      force = now;
    }
  };
  for (const Vector3d& corner : corners) go(corner);
  go(start);
  return work;
}

TEST(GodObject, AClosedCycleGivesNoEnergy) {
  const auto sphere = ball(10, 4);
  const field::TriangleTree round(sphere);
  const double pressed = work_of_cycle(round, {0, 0, 12}, {{0, 0, 9}, {1, 2, 9}, {2, 1, 8.8}}, 0.001);
  EXPECT_LT(pressed, 0) << "what it keeps while the next face is nearer";
  EXPECT_GT(pressed, -0.04) << "of 0.5 N mm that the press takes and gives";

  cloud::TriangleMesh mesh = box({-5, -5, -5}, {5, 5, 5});
  add(mesh, box({-5, -5, 5}, {0, 5, 9}));
  const field::TriangleTree tree(mesh);
  cloud::Random random(8);
  double most = -1, least = 0;
  for (int cycle = 0; cycle < 60; ++cycle) {
    std::vector<Vector3d> corners;
    for (int i = 0; i < 5; ++i) corners.emplace_back(Vector3d(2, 0, 4.5) + draw(random, 4));
    const double work = work_of_cycle(tree, {8, 0, 12}, corners, 0.005);
    most = std::max(most, work);
    least = std::min(least, work);
  }
  EXPECT_LT(most, 0.03) << "of some tens: what the rule rounds where the god-object leaves an edge";
  EXPECT_LT(least, -0.5) << "round an edge energy is lost; no cycle led there";
}

}  // namespace
}  // namespace isotouch::evaluate
