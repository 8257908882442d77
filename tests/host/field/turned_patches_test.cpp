#include "host/field/turned_patches.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <string>
#include <vector>

#include "host/cloud/shapes.h"
#include "tests/support/sanitized.h"

namespace isotouch::field {
namespace {

using cloud::OrientedPoints;
using Eigen::Vector3d;

/// The sample and its nearest ones, so many.
std::vector<std::size_t> patch(const Scan& scan, std::size_t sample, std::size_t count) {
  std::vector<Neighbour> found;
  scan.tree().nearest(scan.positions()[sample], count, found);
  std::vector<std::size_t> indices;
  for (const Neighbour& n : found) indices.push_back(n.index);
  return indices;
}

std::size_t wrong(const Scan& scan, const OrientedPoints& truth) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < scan.size(); ++i) count += scan.normals()[i].dot(truth.normals[i]) < 0.0 ? 1U : 0U;
  return count;
}

TEST(TurnedPatchesHeavy, AreTurnedBackWhateverTheirSize) {
  for (const std::string& name : test::examples<std::string>({"owl", "torus", "hydrant", "jaguar"})) {
    const OrientedPoints truth = cloud::sample_shape(cloud::shape(name), 4000);
    for (const std::size_t count : {40U, 200U, 500U}) {
      Scan scan(truth);
      for (const std::size_t place : {std::size_t{7}, std::size_t{2900}}) {
        for (const std::size_t i : patch(scan, place, count)) {
          if (scan.normals()[i].dot(truth.normals[i]) > 0.0) scan.turn_normal(i);
        }
      }
      const std::size_t before = wrong(scan, truth);
      ASSERT_GT(before, count - 1);
      EXPECT_GT(turn_patches(scan), 9 * before / 10) << name << " " << count;
      EXPECT_LE(wrong(scan, truth), before / 10) << name << " " << count;
    }
  }
}

TEST(TurnedPatches, SoundScansAreLeftAlone) {
  for (const std::string& name : test::examples(cloud::shape_names())) {
    Scan scan(cloud::sample_shape(cloud::shape(name), 4000));
    EXPECT_EQ(turn_patches(scan), 0U) << name;
  }
}

TEST(TurnedPatches, TheSidesOfAThinWallAndOfANarrowGapAreNone) {
  for (const double apart : {-0.3, -0.1, 0.1, 0.3}) {  // spacings; below 0 a wall, above a gap
    OrientedPoints sides;
    for (int side = 0; side < 2; ++side) {
      for (int n = 0; n < 1600; ++n) {
        const double x = n % 40 + (side == 0 ? 0.0 : 0.37), y = n / 40 + (n % 2 == 0 ? 0.0 : 0.21);
        if (side == 1 && n % 3 == 0) continue;  // one of them is the smaller part
        sides.positions.emplace_back(x, y, side == 0 ? 0.0 : apart);
        sides.normals.emplace_back(0, 0, side == 0 ? 1 : -1);
      }
    }
    Scan scan(sides);
    EXPECT_EQ(turn_patches(scan), 0U) << apart;
  }
}

}  // namespace
}  // namespace isotouch::field
