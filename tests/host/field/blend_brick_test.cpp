#include "host/field/blend_brick.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

#include "host/field/vector_lanes.h"

namespace isotouch::field {
namespace {

/// The same numbers everywhere, in [-1, 1).
class Numbers {
 public:
  float operator()() { return static_cast<float>(engine_() % 4096) / 2048.0F - 1.0F; }
  BrickBlend::Point point(float size) { return {size * (*this)(), size * (*this)(), size * (*this)()}; }

 private:
  std::mt19937 engine_{7};
};

BrickBlend::Model model(Numbers& number, std::uint32_t count) {
  BrickBlend::Model result{};
  for (std::size_t k = 0; k < count; ++k) {
    const float curvature = count % 2 == 0 ? 0.0F : 0.3F * number();
    result.pieces[k] = {number.point(1.0F),
                        number.point(0.6F),
                        number.point(0.6F),
                        number.point(0.6F),
                        0.0F,
                        curvature,
                        0.0F,
                        curvature != 0.0F ? 1.0F / curvature : 0.0F};
  }
  result.count = count;
  result.concave = count + 1;
  result.reach = 3.0F;
  result.trust = 1.5F + number();
  result.inner = number.point(4.0F);
  result.outer = number.point(4.0F);
  result.inner_radius = 2.0F + number();
  result.outer_radius = 2.0F + number();
  return result;
}

TEST(BrickBlend, WiderVectorsGiveTheBitsOfFour) {
  Numbers number;
  std::size_t doubts = 0;
  for (int brick = 0; brick < 60; ++brick) {
    std::vector<BrickBlend::Model> models;
    for (std::uint32_t n = 0; n < 36; ++n) models.push_back(model(number, 1 + n % kMaxPieces));
    std::vector<BlendCandidate> candidates;
    for (const BrickBlend::Model& m : models) candidates.push_back({&m, number.point(brick % 2 == 0 ? 6.0F : 12.0F)});
    BrickBlend::Doubt by_four, by_eight;
    EXPECT_EQ(blend_by_fours(candidates, by_four), blend_by_eights(candidates, by_eight)) << brick;
    EXPECT_EQ(by_four.far, by_eight.far);
    EXPECT_EQ(by_four.suspect, by_eight.suspect);
    if (vector_lanes() == 16) {
      BrickBlend::Doubt by_sixteen;
      EXPECT_EQ(blend_by_fours(candidates, by_four), blend_by_sixteens(candidates, by_sixteen)) << brick;
      EXPECT_EQ(by_four.far, by_sixteen.far);
      EXPECT_EQ(by_four.suspect, by_sixteen.suspect);
    }
    doubts += by_four.far != 0 ? 1U : 0U;
  }
  EXPECT_GT(doubts, 10U);
}

}  // namespace
}  // namespace isotouch::field
