#include "host/published/build.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>

#include "host/error.h"
#include "host/field/balls.h"
#include "host/published/indicator.h"
#include "host/published/levels.h"

namespace isotouch::published {
namespace {

/// Six points on the axes, one also tilted against its neighbours, so that the radii differ.
///
/// Worked by hand. The octahedron of radius 3 with normals along the axes: of two neighbours the second lies at a = (-3, 3, 0) from the first,
/// -n·a = 3, |a|² = 18, so r = 18 / 6 = 3; of two opposite ones a = (-6, 0, 0), r = 36 / 12 = 3. With the top lowered to z = 2:
///
///     sample      partner           a             -n·a    |a|²    r
///     (±3,0,0)    top (0,0,2)       (∓3, 0, 2)    3       13      13/6   ← least
///     (0,±3,0)    top               the same                      13/6
///     (0,0,-3)    sides             (3, 0, 3)     3       18      3
///                 top               (0, 0, 5)     5       25      5/2    ← least
///     (0,0,2)     sides             (3, 0, -2)    2       13      13/4
///                 bottom            (0, 0, -5)    5       25      5/2    ← least
cloud::OrientedPoints flattened_octahedron() {
  return {{{3, 0, 0}, {-3, 0, 0}, {0, 3, 0}, {0, -3, 0}, {0, 0, 2}, {0, 0, -3}},
          {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}};
}

field::Grid unit_grid(int size) {
  field::Grid grid;
  grid.size = Eigen::Vector3i::Constant(size);
  grid.origin = Eigen::Vector3d::Constant(-(size - 1) / 2);
  return grid;
}

TEST(Published, RadiiAreThoseWorkedByHand) {
  const std::array<double, 6> expected = {13.0 / 6, 13.0 / 6, 13.0 / 6, 13.0 / 6, 2.5, 2.5};
  const std::vector<double> radii = field::packing_radii_brute_force(flattened_octahedron());
  ASSERT_EQ(radii.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_NEAR(radii[i], expected[i], 1e-14) << i;
}

/// Spheres of radius 13/6 about (±5/6, 0, 0) and (0, ±5/6, 0), and one of 5/2 about (0, 0, -1/2) that two samples share. In the layer z = 0 a node
/// (x, y) is inside when (|x| - 5/6)² + y² <= 169/36, or the same with x and y exchanged, or x² + y² <= 6. In z = 1 the right-hand sides are
/// 133/36 and 4; in z = 2, 25/36 and 0 (exactly the top sample); in z = -1 133/36 and 6; in z = -2 25/36 and 4; in z = -3 none and 0.
constexpr std::array<std::array<const char*, 7>, 7> kInside = {{
    {".......", ".......", ".......", "...#...", ".......", ".......", "......."},  // z = -3
    {".......", "...#...", "..###..", ".#####.", "..###..", "...#...", "......."},  // z = -2
    {".......", "..###..", ".#####.", ".#####.", ".#####.", "..###..", "......."},  // z = -1
    {"...#...", "..###..", ".#####.", "#######", ".#####.", "..###..", "...#..."},  // z = 0
    {".......", "..###..", ".#####.", ".#####.", ".#####.", "..###..", "......."},  // z = 1
    {".......", ".......", "...#...", "..###..", "...#...", ".......", "......."},  // z = 2
    {".......", ".......", ".......", ".......", ".......", ".......", "......."},  // z = 3
}};

/// The same nodes after peeling: a digit is the depth, '.' is outside.
constexpr std::array<std::array<const char*, 7>, 7> kLevels = {{
    {".......", ".......", ".......", "...0...", ".......", ".......", "......."},  // z = -3
    {".......", "...0...", "..000..", ".00100.", "..000..", "...0...", "......."},  // z = -2
    {".......", "..000..", ".01110.", ".01210.", ".01110.", "..000..", "......."},  // z = -1
    {"...0...", "..010..", ".01210.", "0122210", ".01210.", "..010..", "...0..."},  // z = 0
    {".......", "..000..", ".00100.", ".01110.", ".00100.", "..000..", "......."},  // z = 1
    {".......", ".......", "...0...", "..000..", "...0...", ".......", "......."},  // z = 2
    {".......", ".......", ".......", ".......", ".......", ".......", "......."},  // z = 3
}};

template <class Field, class Show>
std::string drawn(const Field& field, Show show) {
  std::string text;
  for (int k = 0; k < field.grid.size.z(); ++k) {
    for (int j = 0; j < field.grid.size.y(); ++j) {
      for (int i = 0; i < field.grid.size.x(); ++i) text += show(field.at(i, j, k));
      text += '\n';
    }
    text += '\n';
  }
  return text;
}

std::string drawn(const std::array<std::array<const char*, 7>, 7>& table) {
  std::string text;
  for (const auto& layer : table) {
    for (const char* row : layer) text += std::string(row) + '\n';
    text += '\n';
  }
  return text;
}

TEST(Published, IndicatorIsTheTableWorkedByHand) {
  field::Progress progress;
  const auto points = flattened_octahedron();
  const Indicator inside = nodes_in_spheres(points, field::packing_radii_brute_force(points), unit_grid(7), progress);
  EXPECT_EQ(drawn(inside, [](int value) { return value != 0 ? '#' : '.'; }), drawn(kInside));
}

TEST(Published, LevelsAreTheTableWorkedByHand) {
  field::Progress progress;
  const Built built = build(flattened_octahedron(), unit_grid(7), progress);
  EXPECT_EQ(drawn(built.levels, [](int level) { return level > 0 ? '.' : static_cast<char>('0' - level); }), drawn(kLevels));
  EXPECT_EQ(built.without_sphere, 0U);
}

TEST(Published, ALevelCountsStepsToTheOutsideAndEndsAtMinusSeven) {
  Indicator block(unit_grid(25), 0);
  const Eigen::Vector3i low(1, 2, 3);
  const Eigen::Vector3i high(23, 22, 20);
  for (int k = low.z(); k <= high.z(); ++k) {
    for (int j = low.y(); j <= high.y(); ++j) {
      for (int i = low.x(); i <= high.x(); ++i) block.at(i, j, k) = 1;
    }
  }
  field::Progress progress;
  const LevelField levels = peel(block, progress);
  std::array<int, 9> seen{};
  for (int k = 0; k < 25; ++k) {
    for (int j = 0; j < 25; ++j) {
      for (int i = 0; i < 25; ++i) {
        const Eigen::Array3i node(i, j, k);
        const int depth = std::min((node - low.array()).minCoeff(), (high.array() - node).minCoeff());  // to the nearest face
        const int expected = depth < 0 ? 1 : std::max(-depth, -7);
        ASSERT_EQ(levels.at(i, j, k), expected);
        ++seen[static_cast<std::size_t>(1 - expected)];
      }
    }
  }
  for (const int count : seen) EXPECT_GT(count, 0);
}

TEST(Published, BeyondTheGridIsOutside) {
  field::Progress progress;
  const LevelField levels = peel(Indicator(unit_grid(3), 1), progress);
  for (std::size_t n = 0; n < 27; ++n) EXPECT_EQ(levels.values[n], n == 13 ? -1 : 0);
}

TEST(Published, PointsWithoutAPartnerBelowGiveNoSphere) {
  cloud::OrientedPoints flat;
  for (int i = 0; i < 9; ++i) {
    flat.positions.emplace_back(i % 3 - 1, i / 3 - 1, 0);
    flat.normals.emplace_back(0, 0, 1);
  }
  field::Progress progress;
  const Built built = build(flat, unit_grid(9), progress);
  EXPECT_EQ(built.without_sphere, 9U);
  EXPECT_EQ(built.inside_nodes, 0U);
}

TEST(Published, StagesAreTimedAndInsideNodesCountedBeforeThePeeling) {
  field::Progress progress;
  const Built built = build(flattened_octahedron(), unit_grid(7), progress);
  std::size_t drawn_inside = 0;
  for (const char c : drawn(kInside)) drawn_inside += c == '#' ? 1U : 0U;
  EXPECT_EQ(built.inside_nodes, drawn_inside);
  ASSERT_EQ(progress.seconds().size(), 3U);
  EXPECT_EQ(progress.seconds()[0].first, "radii");
  EXPECT_EQ(progress.seconds()[1].first, "indicator");
  EXPECT_EQ(progress.seconds()[2].first, "levels");
}

TEST(Published, ABandFieldHoldsEveryLevelWithinAFarBorder) {
  field::Progress progress;
  const Built built = build(flattened_octahedron(), unit_grid(14), progress);
  const field::BandField band = to_band_field(built.levels);
  EXPECT_EQ(band.band, 7.0);
  EXPECT_EQ(band.bricks.size(), 4U * 4 * 4);
  for (const field::Brick& brick : band.bricks) {
    for (int n = 0; n < 64; ++n) {
      const Eigen::Vector3i sample = 4 * brick.cell + Eigen::Vector3i(n & 3, (n >> 2) & 3, n >> 4);
      const bool border = (sample.array() < 2).any() || (sample.array() > 11).any();
      const float distance = brick.distance[static_cast<std::size_t>(n)];
      if (border) {
        EXPECT_GT(distance, 7.0F);
      } else {
        EXPECT_EQ(distance, static_cast<float>(built.levels.at(sample.x(), sample.y(), sample.z())));
      }
    }
  }
}

TEST(Published, AGridTooLargeToBeKeptDenseIsRefused) {
  field::Progress progress;
  EXPECT_THROW(build(flattened_octahedron(), unit_grid(646), progress), InputError);
}

}  // namespace
}  // namespace isotouch::published
