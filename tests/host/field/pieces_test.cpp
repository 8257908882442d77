#include "host/field/pieces.h"

#include <gtest/gtest.h>

#include <cmath>

namespace isotouch::field {
namespace {

using Eigen::Vector3d;

TEST(JumpTree, SplitsAnEdgeBetweenItsFaces) {
  std::vector<WeightedSample> samples;
  for (int i = 0; i < 4; ++i) samples.push_back({{-1.0 - i, 0.3 * i, 0}, {0, 0, 1}, 1});
  for (int i = 0; i < 3; ++i) samples.push_back({{0, 0.2 * i, -1.0 - i}, {1, 0, 0}, 1});
  const JumpTree tree(samples);
  EXPECT_GT(tree.jump(0), 1.4);
  EXPECT_LT(tree.jump(1), 1e-12);
  std::vector<std::size_t> piece;
  tree.split(1, piece);
  EXPECT_EQ(piece, (std::vector<std::size_t>{0, 0, 0, 0, 0, 0, 0}));
  tree.split(2, piece);
  EXPECT_EQ(piece, (std::vector<std::size_t>{0, 0, 0, 0, 1, 1, 1}));
}

TEST(JumpTree, SeesTheTwoSidesOfAPlate) {
  const std::vector<WeightedSample> samples = {
      {{0, 0, 0}, {0, 0, 1}, 1}, {{1, 0, -2}, {0, 0, -1}, 1}, {{2, 0, 0}, {0, 0, 1}, 1}, {{3, 0, -2}, {0, 0, -1}, 1}};
  std::vector<std::size_t> piece;
  JumpTree(samples).split(2, piece);
  EXPECT_EQ(piece, (std::vector<std::size_t>{0, 1, 0, 1}));
}

TEST(JumpTree, JumpOnACircleIsTheTurnAlone) {
  std::vector<WeightedSample> samples;
  for (int i = 0; i < 5; ++i) {
    const Vector3d n(std::sin(0.3 * i), 0, std::cos(0.3 * i));
    samples.push_back({10.0 * n, n, 1});
  }
  const JumpTree tree(samples);
  for (std::size_t rank = 0; rank < 4; ++rank) EXPECT_NEAR(tree.jump(rank), 2 * std::sin(0.15), 1e-12);
}

}  // namespace
}  // namespace isotouch::field
