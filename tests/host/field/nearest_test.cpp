#include "host/field/nearest.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "host/cloud/random.h"

namespace isotouch::field {
namespace {

/// A lattice: most distances occur many times.
std::vector<Eigen::Vector3d> lattice() {
  std::vector<Eigen::Vector3d> positions;
  for (int i = 0; i < 6 * 6 * 6; ++i) positions.emplace_back(i % 6, i / 6 % 6, i / 36);
  return positions;
}

std::vector<Neighbour> all_sorted(const std::vector<Eigen::Vector3d>& positions, const Eigen::Vector3d& x) {
  std::vector<Neighbour> all;
  for (std::uint32_t i = 0; i < positions.size(); ++i) all.push_back({squared_distance(positions[i], x), i});
  std::sort(all.begin(), all.end());
  return all;
}

bool same(const Neighbour& a, const Neighbour& b) { return a.index == b.index && a.squared_distance == b.squared_distance; }

TEST(Nearest, OrdersEqualDistancesByIndex) {
  const auto positions = lattice();
  const Nearest tree(positions);
  std::vector<Neighbour> found;
  for (const Eigen::Vector3d& x : {Eigen::Vector3d(2.5, 2.5, 2.5), Eigen::Vector3d(3.0, 2.0, 1.0), Eigen::Vector3d(-1.0, 7.0, 2.0)}) {
    const auto all = all_sorted(positions, x);
    for (const std::size_t count : {1U, 5U, 9U, 30U}) {
      tree.nearest(x, count, found);
      ASSERT_EQ(found.size(), count);
      EXPECT_TRUE(std::equal(found.begin(), found.end(), all.begin(), same)) << count;
    }
  }
}

TEST(Nearest, FindsEverythingWithinARadiusAndNothingElse) {
  const auto positions = lattice();
  const Nearest tree(positions);
  std::vector<Neighbour> found;
  cloud::Random random(3);
  for (int trial = 0; trial < 50; ++trial) {
    const Eigen::Vector3d x(random.uniform(-1, 7), random.uniform(-1, 7), random.uniform(-1, 7));
    const double radius = random.uniform(0, 4);
    tree.within(x, radius, found);
    auto all = all_sorted(positions, x);
    all.erase(std::find_if(all.begin(), all.end(), [&](const Neighbour& n) { return n.squared_distance > radius * radius; }), all.end());
    ASSERT_EQ(found.size(), all.size());
    EXPECT_TRUE(std::equal(found.begin(), found.end(), all.begin(), same));
  }
}

TEST(Nearest, GoesBeyondTheNearestByAMargin) {
  const auto positions = lattice();
  const Nearest tree(positions);
  std::vector<Neighbour> found;
  cloud::Random random(5);
  for (int trial = 0; trial < 50; ++trial) {
    const Eigen::Vector3d x(random.uniform(-1, 7), random.uniform(-1, 7), random.uniform(-1, 7));
    const double margin = random.uniform(0, 2);
    tree.nearest_and_beyond(x, 9, margin, found);
    auto all = all_sorted(positions, x);
    const double radius = std::sqrt(all[8].squared_distance) + margin;
    all.erase(std::find_if(all.begin(), all.end(), [&](const Neighbour& n) { return n.squared_distance > radius * radius; }), all.end());
    ASSERT_EQ(found.size(), all.size());
    EXPECT_GT(found.size(), 8U);
    EXPECT_TRUE(std::equal(found.begin(), found.end(), all.begin(), same));
  }
}

TEST(Nearest, FindsTheSameInAnyOrder) {
  const auto positions = lattice();
  const Nearest tree(positions);
  std::vector<Neighbour> found, sorted;
  tree.within_in_any_order({2.0, 2.5, 3.0}, 2.0, found);
  tree.within({2.0, 2.5, 3.0}, 2.0, sorted);
  std::sort(found.begin(), found.end());
  EXPECT_GT(found.size(), 8U);
  ASSERT_EQ(found.size(), sorted.size());
  EXPECT_TRUE(std::equal(found.begin(), found.end(), sorted.begin(), same));
}

TEST(Nearest, GivesAllOfASmallSet) {
  const std::vector<Eigen::Vector3d> positions = {{0, 0, 0}, {1, 0, 0}};
  const Nearest tree(positions);
  std::vector<Neighbour> found;
  tree.nearest({0.9, 0, 0}, 12, found);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].index, 1U);
  tree.nearest_and_beyond({0.9, 0, 0}, 9, 0.0, found);
  ASSERT_EQ(found.size(), 2U);
}

}  // namespace
}  // namespace isotouch::field
