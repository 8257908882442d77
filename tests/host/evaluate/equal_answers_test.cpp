#include "host/evaluate/equal_answers.h"

#include <gtest/gtest.h>

#include "tests/host/evaluate/ball_mesh.h"
#include "tests/host/evaluate/box_mesh.h"

namespace isotouch::evaluate {
namespace {

using Eigen::Vector3d;

bool has_equal_answer(const field::TriangleTree& tree, const Vector3d& hip, const Vector3d& place) {
  const double depth = (place - hip).norm(), tolerance = equal_tolerance(depth);
  return !other_answers(tree, hip, place, depth - tolerance, depth + tolerance).empty();
}

TEST(EqualAnswers, BelowOneFaceThereIsOneAnswer) {
  const auto mesh = box({0, 0, 0}, {20, 20, 20});
  const field::TriangleTree tree(mesh);
  EXPECT_FALSE(has_equal_answer(tree, {10, 10, 19}, {10, 10, 20}));
  EXPECT_FALSE(has_equal_answer(tree, {10, 10, 19.9}, {10, 10, 20}));
}

TEST(EqualAnswers, NearAnEdgeThereAreTwoOnlyAroundTheMiddle) {
  const auto mesh = box({0, 0, 0}, {20, 20, 20});
  const field::TriangleTree tree(mesh);
  EXPECT_TRUE(has_equal_answer(tree, {19, 10, 19}, {19, 10, 20}));
  EXPECT_TRUE(has_equal_answer(tree, {19.05, 10, 19}, {19.05, 10, 20}));
  EXPECT_FALSE(has_equal_answer(tree, {18.8, 10, 19}, {18.8, 10, 20})) << "the other side is farther";
  EXPECT_FALSE(has_equal_answer(tree, {19.2, 10, 19}, {19.2, 10, 20}))
      << "the other side is nearer: the god-object stays because of its past";
}

TEST(EqualAnswers, AreWaysToThePlaces) {
  const auto mesh = box({0, 0, 0}, {20, 20, 20});
  const field::TriangleTree tree(mesh);
  const Vector3d hip(19.4, 10.5, 19);
  EXPECT_TRUE(other_answers(tree, hip, {19.4, 10.5, 20}, 0.7, 1.3).empty());
  for (const Vector3d& way : other_answers(tree, hip, {19.4, 10.5, 20}, 0, 2)) EXPECT_EQ(way, Vector3d(20 - 19.4, 0, 0));
  EXPECT_FALSE(other_answers(tree, hip, {19.4, 10.5, 20}, 0, 2).empty());
}

TEST(EqualAnswers, TheOtherSideOfAPlateIsNoAnswer) {
  const auto mesh = box({0, 0, 0}, {20, 20, 2});
  const field::TriangleTree tree(mesh);
  EXPECT_FALSE(has_equal_answer(tree, {10, 10, 1}, {10, 10, 2}));
}

TEST(EqualAnswers, TheFacesOfABallAreOneAnswer) {
  const auto mesh = ball(20, 4);
  const field::TriangleTree tree(mesh);
  const Vector3d way = Vector3d(1, 2, 3).normalized();
  for (const double depth : {0.1, 0.5, 1.0}) {
    const Vector3d hip = (20 - depth) * way;
    EXPECT_FALSE(has_equal_answer(tree, hip, tree.nearest(hip).point)) << depth;
  }
}

TEST(EqualAnswers, InTheMiddleOfAnUpperEdgeOfARoofThereAreTwo) {
  const auto mesh = ball(20, 0);  // eight faces, 109 degrees between them
  const field::TriangleTree tree(mesh);
  const Vector3d hip = 0.93 * Vector3d(10, 10, 0);  // below the middle of an edge
  EXPECT_TRUE(has_equal_answer(tree, hip, tree.nearest(hip).point));
}

}  // namespace
}  // namespace isotouch::evaluate
