#include "host/field/unlisted_regions.h"

#include <gtest/gtest.h>

#include <array>
#include <set>
#include <tuple>

namespace isotouch::field {
namespace {

using Eigen::Vector3i;

/// A grid of 9 x 8 x 7 cells in which the bricks are the shells of two boxes, one cell thick.
BandField two_shells() {
  BandField field;
  field.grid.size = Vector3i(35, 32, 28);  // the last cell along x is cut
  std::set<std::array<int, 3>> cells;
  const auto shell = [&](const Vector3i& low, const Vector3i& high) {
    for (int z = low.z(); z <= high.z(); ++z) {
      for (int y = low.y(); y <= high.y(); ++y) {
        for (int x = low.x(); x <= high.x(); ++x) {
          const bool within = x > low.x() && x < high.x() && y > low.y() && y < high.y() && z > low.z() && z < high.z();
          if (!within) cells.insert({z, y, x});
        }
      }
    }
  };
  shell({1, 1, 1}, {4, 4, 4});
  shell({4, 4, 1}, {7, 6, 4});
  for (const auto& [z, y, x] : cells) field.bricks.push_back({Vector3i(x, y, z), {}});
  return field;
}

TEST(UnlistedRegions, AreWhatFacesConnect) {
  const UnlistedRegions regions(two_shells());
  EXPECT_EQ(regions.count(), 3U);
  const std::uint32_t first = regions.of({2, 2, 2}), second = regions.of({5, 5, 2});
  EXPECT_EQ(regions.of({3, 3, 3}), first);
  EXPECT_EQ(regions.of({6, 5, 3}), second);
  EXPECT_NE(first, second);  // they meet at an edge
  EXPECT_NE(first, UnlistedRegions::kOuter);
  EXPECT_NE(second, UnlistedRegions::kOuter);
}

TEST(UnlistedRegions, ReachingTheBorderAreOneWithWhatLiesBeyond) {
  const UnlistedRegions regions(two_shells());
  for (const Vector3i& cell : {Vector3i(0, 0, 0), Vector3i(8, 7, 6), Vector3i(6, 2, 3), Vector3i(2, 6, 3), Vector3i(4, 4, 5),
                               Vector3i(-1, 3, 3), Vector3i(3, 8, 3), Vector3i(3, 3, 7)})
    EXPECT_EQ(regions.of(cell), UnlistedRegions::kOuter) << cell.transpose();
}

TEST(UnlistedRegions, WithoutBricksThereIsOneRegion) {
  BandField field;
  field.grid.size = Vector3i::Constant(16);
  const UnlistedRegions regions(field);
  EXPECT_EQ(regions.count(), 1U);
  EXPECT_EQ(regions.of({2, 2, 2}), UnlistedRegions::kOuter);
}

}  // namespace
}  // namespace isotouch::field
