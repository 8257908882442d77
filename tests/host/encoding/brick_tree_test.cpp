#include "host/encoding/brick_tree.h"

#include <gtest/gtest.h>

#include <set>

namespace isotouch::encoding {
namespace {

field::Brick brick_at(int x, int y, int z, float distance) {
  field::Brick brick{{x, y, z}, {}};
  brick.distance.fill(distance);
  return brick;
}

TEST(BrickTree, AnEmptyFieldIsOutsideThroughout) {
  field::BandField field;
  field.grid.size = {40, 17, 16};
  const BrickTree tree = brick_tree(BrickRows(field), {});
  EXPECT_EQ(tree.root, std::vector<std::uint32_t>(3 * 2 * 1, 0));
  EXPECT_EQ(tree.nodes.size(), 2U * 64);
  EXPECT_TRUE(tree.stored.empty());
}

TEST(BrickTree, AGapHasTheSignOfTheBrickBeforeIt) {
  field::BandField field;
  field.grid.size = {32, 8, 8};
  field.bricks = {brick_at(1, 0, 0, -3), brick_at(6, 0, 0, 3)};
  const BrickTree tree = brick_tree(BrickRows(field), {BrickKind::kStored, BrickKind::kStored});
  ASSERT_EQ(tree.root, (std::vector<std::uint32_t>{2, 3}));
  EXPECT_EQ(std::vector<std::uint32_t>(tree.nodes.begin() + 128, tree.nodes.begin() + 132), (std::vector<std::uint32_t>{0, 2, 1, 1}));
  EXPECT_EQ(std::vector<std::uint32_t>(tree.nodes.begin() + 192, tree.nodes.begin() + 196), (std::vector<std::uint32_t>{1, 1, 3, 0}));
  EXPECT_EQ(tree.stored, (std::vector<std::size_t>{0, 1}));
}

TEST(BrickTree, NodesOfOneKindAreShared) {
  field::BandField field;
  field.grid.size = {64, 16, 16};
  for (int z = 0; z < 4; ++z) {
    for (int y = 0; y < 4; ++y) {
      field.bricks.push_back(brick_at(1, y, z, -3));
      field.bricks.push_back(brick_at(13, y, z, 3));
    }
  }
  const BrickTree tree = brick_tree(BrickRows(field), std::vector<BrickKind>(field.bricks.size(), BrickKind::kStored));
  EXPECT_EQ(tree.root, (std::vector<std::uint32_t>{2, 1, 1, 3}));
}

TEST(BrickTree, TheBricksOfANodeLieTogetherAndEachIsStoredOnce) {
  field::BandField field;
  field.grid.size = {64, 64, 64};
  for (int z = 0; z < 16; ++z) {
    for (int y = 0; y < 16; ++y) {
      for (int x = 0; x < 16; x += 3) field.bricks.push_back(brick_at(x, y, z, 3));
    }
  }
  std::vector<BrickKind> kinds(field.bricks.size(), BrickKind::kStored);
  kinds[7] = BrickKind::kOutside;
  const BrickTree tree = brick_tree(BrickRows(field), kinds);
  EXPECT_EQ(tree.stored.size(), field.bricks.size() - 1);
  EXPECT_EQ(std::set<std::size_t>(tree.stored.begin(), tree.stored.end()).size(), tree.stored.size());
  std::uint32_t next = 2;  // numbers rise through the nodes without a gap
  for (const std::uint32_t brick : tree.nodes) {
    if (brick > 1) {
      EXPECT_EQ(brick, next++);
    }
  }
  EXPECT_EQ(next, tree.stored.size() + 2);
}

}  // namespace
}  // namespace isotouch::encoding
