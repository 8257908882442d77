#include "host/encoding/brick_rows.h"

#include <gtest/gtest.h>

#include "tests/host/encoding/field_bodies.h"

namespace isotouch::encoding {
namespace {

TEST(BrickRows, FindsEveryListedBrickAndNoOther) {
  const auto field = test::field_of(test::ball(11), Eigen::Vector3d::Constant(11));
  const BrickRows rows(field);
  std::size_t found = 0;
  for (int z = -1; z <= rows.size().z(); ++z) {
    for (int y = -1; y <= rows.size().y(); ++y) {
      for (int x = -1; x <= rows.size().x(); ++x) {
        const Eigen::Vector3i cell(x, y, z);
        const std::size_t place = rows.find(cell);
        if (place == BrickRows::kAbsent) continue;
        ASSERT_LT(place, field.bricks.size());
        EXPECT_EQ(field.bricks[place].cell, cell);
        ++found;
      }
    }
  }
  EXPECT_EQ(found, field.bricks.size());
  EXPECT_GT(found, 100U);
}

TEST(BrickRows, AnEmptyFieldHasEmptyRows) {
  field::BandField field;
  field.grid.size = {9, 8, 17};
  const BrickRows rows(field);
  EXPECT_EQ(rows.size(), Eigen::Vector3i(3, 2, 5));
  EXPECT_TRUE(rows.row(1, 4).empty());
  EXPECT_TRUE(rows.row(2, 0).empty());
  EXPECT_EQ(rows.find({0, 0, 0}), BrickRows::kAbsent);
}

}  // namespace
}  // namespace isotouch::encoding
