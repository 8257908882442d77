#include "host/encoding/round_creases.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace isotouch::encoding {
namespace {

/// Every brick of a 32^3 grid, filled from a function of the index.
field::BandField band_of(const std::function<double(double, double, double)>& distance) {
  field::BandField field;
  field.grid.size = {32, 32, 32};
  for (int z = 0; z < 8; ++z) {
    for (int y = 0; y < 8; ++y) {
      for (int x = 0; x < 8; ++x) {
        field::Brick brick{{x, y, z}, {}};
        for (int n = 0; n < 64; ++n) {
          brick.distance[static_cast<std::size_t>(n)] =
              static_cast<float>(distance(4 * x + (n & 3), 4 * y + ((n >> 2) & 3), 4 * z + (n >> 4)));
        }
        field.bricks.push_back(brick);
      }
    }
  }
  return field;
}

float at(const field::BandField& field, int x, int y, int z) {
  const auto brick = static_cast<std::size_t>(((z / 4) * 8 + y / 4) * 8 + x / 4);
  return field.bricks[brick].distance[static_cast<std::size_t>(((z & 3) << 4) | ((y & 3) << 2) | (x & 3))];
}

TEST(RoundCreases, LowersOnlyTheRoofOfACrease) {
  const auto crease = [](double x, double, double z) { return std::min(x - z, x + z - 30.2) / std::sqrt(2.0) + 3.0; };
  const field::BandField sharp = band_of(crease), round = round_creases(sharp, neighbours(sharp));
  int lowered = 0;
  for (int z = 2; z < 30; ++z) {
    for (int x = 2; x < 30; ++x) {
      const float before = at(sharp, x, 16, z), after = at(round, x, 16, z);
      EXPECT_LE(after, before);
      if (std::abs(z - 15.1) > 3.0) {  // away from the crease
        EXPECT_EQ(after, before);
      }
      if (after < before) {
        ++lowered;
        EXPECT_LT(before - after, 0.5F);
      }
    }
  }
  EXPECT_GT(lowered, 4);
}

TEST(RoundCreases, AfterItNoCreaseIsSharperThanAsked) {
  const auto crease = [](double x, double y, double z) { return std::min(0.9 * (x - 16) + 0.3 * (z - 15) + 0.31 * (y - 16), 16.2 - x); };
  const field::BandField sharp = band_of(crease), round = round_creases(sharp, neighbours(sharp));
  float sharpest = 0;
  for (int z = 8; z < 24; ++z) {
    for (int x = 8; x < 24; ++x) {
      const float here = at(round, x, 16, z);
      if (std::abs(here) > 2) continue;
      const float around = at(round, x - 1, 16, z) + at(round, x + 1, 16, z) + at(round, x, 15, z) + at(round, x, 17, z) +
                           at(round, x, 16, z - 1) + at(round, x, 16, z + 1);
      sharpest = std::min(sharpest, around - 6 * here);
    }
  }
  EXPECT_GT(sharpest, -1.1F * kSharpestCrease);  // the fixed count of Jacobi steps comes within a tenth
  EXPECT_LT(sharpest, -0.5F * kSharpestCrease);  // the crease is there
}

TEST(RoundCreases, LeavesConvexEdgesAndSmoothBodiesAlone) {
  const auto edge = [](double x, double, double z) { return std::max(x - 16.3, z - 15.2); };
  const auto ball = [](double x, double y, double z) { return std::hypot(x - 15.5, y - 15.5, z - 15.5) - 9.0; };
  const auto bowl = [](double x, double y, double z) { return 9.0 - std::hypot(x - 15.5, y - 15.5, z - 15.5); };
  for (const auto& body : {std::function<double(double, double, double)>(edge), {ball}, {bowl}}) {
    const field::BandField before = band_of(body), after = round_creases(before, neighbours(before));
    for (std::size_t b = 0; b < before.bricks.size(); ++b) EXPECT_EQ(before.bricks[b].distance, after.bricks[b].distance);
  }
}

}  // namespace
}  // namespace isotouch::encoding
