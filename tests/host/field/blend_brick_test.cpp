#include "host/field/blend_brick.h"

#include <gtest/gtest.h>

#include <cmath>
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

/// Samples around a brick, as a live field has them.
struct Surroundings {
  static constexpr float kReach = 10.0F, kDepth = 7.0F;

  Surroundings(Numbers& number, std::size_t count, float size) {
    for (std::uint32_t n = 0; n < count; ++n) models.push_back(model(number, 1 + n % kMaxPieces));
    for (BrickBlend::Model& m : models) {
      m.body = 2.0F + number();
      candidates.push_back({&m, number.point(size)});
    }
  }

  BrickReading blend() const { return blend_body(candidates, kReach, kDepth); }
  BrickReading nearest() const { return nearest_distances(candidates); }

  std::vector<BrickBlend::Model> models;
  std::vector<BlendCandidate> candidates;
};

/// So far from the brick's middle, in some direction.
BrickBlend::Point away(Numbers& number, float distance) {
  const BrickBlend::Point p = number.point(1.0F);
  const float length = std::hypot(p.x, p.y, p.z);
  return {p.x / length * distance, p.y / length * distance, p.z / length * distance};
}

TEST(BlendBody, WiderVectorsGiveTheBitsOfFour) {
  constexpr float kReach = Surroundings::kReach, kDepth = Surroundings::kDepth;
  Numbers number;
  for (int brick = 0; brick < 60; ++brick) {
    const Surroundings around(number, 36, brick % 2 == 0 ? 6.0F : 12.0F);
    const BrickReading body = blend_body_by_fours(around.candidates, kReach, kDepth);
    EXPECT_EQ(body.distance, blend_body_by_eights(around.candidates, kReach, kDepth).distance);
    EXPECT_EQ(body.influence, blend_body_by_eights(around.candidates, kReach, kDepth).influence);
    const BrickReading nearest = nearest_distances_by_fours(around.candidates);
    EXPECT_EQ(nearest.distance, nearest_distances_by_eights(around.candidates).distance);
    EXPECT_EQ(nearest.influence, nearest_distances_by_eights(around.candidates).influence);
    if (vector_lanes() < 16) continue;
    EXPECT_EQ(body.distance, blend_body_by_sixteens(around.candidates, kReach, kDepth).distance);
    EXPECT_EQ(body.influence, blend_body_by_sixteens(around.candidates, kReach, kDepth).influence);
    EXPECT_EQ(nearest.distance, nearest_distances_by_sixteens(around.candidates).distance);
    EXPECT_EQ(nearest.influence, nearest_distances_by_sixteens(around.candidates).influence);
  }
}

TEST(BlendBody, ASampleBeyondTheInfluenceChangesNothing) {
  Numbers number;
  std::size_t changed = 0, tries = 0;
  for (int brick = 0; brick < 40; ++brick) {
    Surroundings around(number, 40, 5.0F);
    const BrickReading body = around.blend(), nearest = around.nearest();
    for (int n = 0; n < 25; ++n) {
      around.candidates.push_back({&around.models.front(), away(number, std::sqrt(body.influence) + 1e-3F)});
      EXPECT_EQ(around.blend().distance, body.distance);
      around.candidates.back().own = away(number, std::sqrt(nearest.influence) + 1e-3F);
      EXPECT_EQ(around.nearest().distance, nearest.distance);
      around.candidates.back().own = away(number, std::sqrt(body.influence) - 0.5F);
      changed += around.blend().distance != body.distance ? 1U : 0U;
      ++tries;
      around.candidates.pop_back();
    }
  }
  EXPECT_GT(changed, tries / 20) << "else it is much too large";
}

TEST(BlendBody, WhereTheNearestAreEquallyFarNoOtherCounts) {
  Numbers number;
  Surroundings around(number, 10, 5.0F);
  // Nine are 6 from the brick's first place, and the tenth is a little farther from it, but as near as they to the places around.
  const float far[][3] = {{6, 0, 0},  {-6, 0, 0}, {0, 6, 0}, {0, -6, 0}, {0, 0, 6},
                          {0, 0, -6}, {4, 4, 2},  {4, 2, 4}, {2, 4, 4},  {6.25F, 0, 0}};
  for (std::size_t n = 0; n < 10; ++n) around.candidates[n].own = {far[n][0] - 1.5F, far[n][1] - 1.5F, far[n][2] - 1.5F};
  const BrickReading ten = around.blend();
  around.candidates.pop_back();
  const BrickReading nine = around.blend();
  EXPECT_EQ(ten.distance[0], nine.distance[0]);
  EXPECT_NE(ten.distance, nine.distance);
}

TEST(BlendBody, OfTheNearestThatAreEquallyFarNoneIsLost) {
  Numbers number;
  // Ten are 5 from the brick's first place; the last of them stands behind a sample that lies beyond the influence but is nearer to other places.
  const float far[][3] = {{5, 0, 0}, {0, 5, 0}, {0, 0, 5}, {3, 4, 0}, {4, 3, 0}, {3, 0, 4}, {4, 0, 3}, {0, 3, 4}, {-4, 0, 3}, {-3, -4, 0}};
  Surroundings around(number, 71, 5.0F);
  for (std::size_t n = 0; n < 10; ++n) around.candidates[n].own = {far[n][0] - 1.5F, far[n][1] - 1.5F, far[n][2] - 1.5F};
  for (std::size_t n = 10; n < 71; ++n) {  // the others are nearer to the other places
    BrickBlend::Point& own = around.candidates[n].own;
    do own = {1.25F + 2.75F * number(), 1.25F + 2.75F * number(), 1.25F + 2.75F * number()};
    while (std::hypot(own.x + 1.5F, own.y + 1.5F, own.z + 1.5F) < 5.05F);
  }
  const BlendCandidate beyond = {around.candidates.back().model, {-1.766F, -5.3F, -5.3F}};
  around.candidates.pop_back();
  const BrickReading without = around.blend();
  ASSERT_GT(std::hypot(beyond.own.x, beyond.own.y, beyond.own.z), std::sqrt(without.influence));
  around.candidates.insert(around.candidates.begin() + 9, beyond);
  EXPECT_EQ(around.blend().distance, without.distance);
}

TEST(BlendBody, WithoutASampleInReachThereIsNoBody) {
  Numbers number;
  for (int hundredths = 100; hundredths < 800; ++hundredths) {
    const float band = static_cast<float>(hundredths) / 100.0F, depth = 2.0F * band + 1.0F, reach = depth + band;
    Surroundings around(number, 3, 1.0F);
    for (BlendCandidate& c : around.candidates) c.own.x += 1.5F + reach;  // in reach of some places alone
    for (const float distance : blend_body(around.candidates, reach, depth).distance) ASSERT_TRUE(std::abs(distance) < 100.0F) << band;
    ASSERT_GE(blend_body(around.candidates, reach, depth).distance[0], band);
  }
}

}  // namespace
}  // namespace isotouch::field
