#include "host/encoding/small_components.h"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace isotouch::encoding {
namespace {

constexpr std::int16_t kFar = 2 << 12;

/// 3 x 3 x 3 bricks, all outside but for what is set.
struct Space {
  std::vector<Neighbours> around;
  std::vector<Coefficients> coefficients;

  Space() {
    field::BandField field;
    field.grid.size = {12, 12, 12};
    for (int n = 0; n < 27; ++n) field.bricks.push_back({{n % 3, n / 3 % 3, n / 9}, {}});
    around = neighbours(field);
    coefficients.resize(27);
    for (Coefficients& brick : coefficients) brick.fill(kFar);
  }

  std::int16_t& at(int x, int y, int z) {
    return coefficients[static_cast<std::size_t>(((z >> 2) * 3 + (y >> 2)) * 3 + (x >> 2))][sample_number(x & 3, y & 3, z & 3)];
  }
  void fill(std::array<int, 3> first, std::array<int, 3> size, std::int16_t value) {
    for (int z = 0; z < size[2]; ++z) {
      for (int y = 0; y < size[1]; ++y) {
        for (int x = 0; x < size[0]; ++x) at(first[0] + x, first[1] + y, first[2] + z) = value;
      }
    }
  }
};

using Counts = std::pair<std::size_t, std::size_t>;  // pieces, cavities

Counts dropped(Space& space) {
  const SmallComponents found = drop_small_components(space.coefficients, space.around);
  return {found.pieces, found.cavities};
}

TEST(Specks, ATinySetIsTurnedAlsoAcrossBricks) {
  for (const std::array<int, 3>& corner : {std::array<int, 3>{5, 5, 5}, {3, 3, 3}, {7, 4, 3}}) {
    for (const std::int16_t value : {std::int16_t{-100}, std::int16_t{-5000}}) {
      Space space;
      space.fill(corner, {{2, 2, 2}}, value);
      EXPECT_EQ(dropped(space), (Counts{1, 0}));
      for (const Coefficients& brick : space.coefficients) {
        for (const std::int16_t coefficient : brick) EXPECT_GE(coefficient, 1 << 9);
      }
    }
  }
}

TEST(Specks, SoIsATinyHollow) {
  Space space;
  for (Coefficients& brick : space.coefficients) brick.fill(-kFar);
  space.at(4, 3, 6) = 7;
  EXPECT_EQ(dropped(space), (Counts{0, 1}));
  EXPECT_LE(space.at(4, 3, 6), -(1 << 9));
}

TEST(Specks, AreCountedInASentence) {
  EXPECT_TRUE(SmallComponents{}.warnings().empty());
  const std::vector<std::string> some = SmallComponents{1, 24}.warnings();
  ASSERT_EQ(some.size(), 2U);
  EXPECT_EQ(some[0], "1 piece of surface too small for the grid left out; a smaller --voxel keeps more");
  EXPECT_EQ(some[1], "24 cavities too small for the grid filled; a smaller --voxel keeps more");
}

TEST(Specks, WhatIsLargerStays) {
  Space space;
  space.fill({{3, 3, 3}}, {{3, 3, 1}}, -200);
  const std::vector<Coefficients> before = space.coefficients;
  EXPECT_EQ(dropped(space), (Counts{0, 0}));
  EXPECT_EQ(space.coefficients, before);
}

TEST(Specks, WhatGoesOnBeyondTheListedBricksStays) {
  Space space;
  space.at(0, 5, 5) = -300;
  EXPECT_EQ(dropped(space), (Counts{0, 0}));
  EXPECT_EQ(space.at(0, 5, 5), -300);
}

TEST(Specks, ATipAtTheCornerOfABodyStays) {
  Space space;
  space.fill({{4, 4, 4}}, {{3, 3, 3}}, -kFar);
  space.at(3, 3, 3) = -300;
  EXPECT_EQ(dropped(space), (Counts{0, 0}));
  EXPECT_EQ(space.at(3, 3, 3), -300);
  space.at(4, 4, 4) = -300;  // now the body's corner is as unclear as the speck
  EXPECT_EQ(dropped(space), (Counts{1, 0}));
  EXPECT_GT(space.at(3, 3, 3), 0);
}

}  // namespace
}  // namespace isotouch::encoding
