#include "host/evaluate/crease_hand.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "tests/host/evaluate/box_mesh.h"

namespace isotouch::evaluate {
namespace {

using Eigen::Vector3d;

constexpr double kDepth = 0.5;

/// Two edges of a millimetre that make a bend of 30 degrees; the second one runs the other way, with its walls in the other order.
struct Bend {
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(M_PI / 6, Vector3d::UnitZ()).toRotationMatrix();
  const Vector3d middle{1, 0, 0};
  const Vector3d last = middle + turn * Vector3d::UnitX();
  const Vector3d left = Vector3d(0, 1, 1).normalized(), right = Vector3d(0, -1, 1).normalized();
  const std::vector<SharpEdge> creases = {{{0, 0, 0}, middle, {left, right}, -90}, {last, middle, {turn * right, turn* left}, -90}};
  const cloud::TriangleMesh mesh = box({-5, -5, -5}, {5, 5, -4});  // not touched
  const field::TriangleTree tree{mesh};
  FeltPath path{tree, {0.5, 0, 1}};
  CreaseHand hand{creases, {creases[0], {0.5, 0, 0}}, path, kDepth};

  /// Goes on and rests, until the hand is where it should be.
  Vector3d after(double ahead, double side) {
    for (int tick = 0; tick < 200; ++tick) hand.step(tick < 100 ? ahead / 100 : 0, side);
    return path.hip();
  }
};

TEST(CreaseHand, SinksHalfwayBetweenTheWalls) {
  Bend bend;
  bend.hand.sink(0.1);
  EXPECT_LT((bend.path.hip() - Vector3d(0.5, 0, -kDepth)).norm(), 1e-9);
}

TEST(CreaseHand, GoesOnWhereTheCreaseBendsAndKnowsTheWalls) {
  Bend bend;
  bend.hand.sink(0.1);
  EXPECT_LT((bend.after(0.3, -1) - (Vector3d(0.8, 0, 0) - kDepth * bend.left)).norm(), 1e-9);
  const Vector3d place = bend.middle + bend.turn * Vector3d(0.3, 0, 0);
  EXPECT_LT((bend.after(0.5, -1) - (place - kDepth * bend.turn * bend.left)).norm(), 0.006) << "a step ends at the bend";
  EXPECT_LT((bend.after(0, 1) - (place - kDepth * bend.turn * bend.right)).norm(), 0.006);
}

TEST(CreaseHand, TurnsBackWhereTheCreaseEnds) {
  Bend bend;
  bend.hand.sink(0.1);
  const Vector3d place = bend.middle + bend.turn * Vector3d(0.7, 0, 0);
  EXPECT_LT((bend.after(1.8, 0) - (place - Vector3d(0, 0, kDepth))).norm(), 0.04) << "two steps end at an end of an edge";
}

}  // namespace
}  // namespace isotouch::evaluate
