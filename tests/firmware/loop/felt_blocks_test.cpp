#include "firmware/loop/felt_blocks.h"

#include <gtest/gtest.h>

#include "firmware/core/field_sampler.h"
#include "firmware/core/stiffness_at.h"
#include "tests/support/field_image.h"
#include "tests/support/random.h"
#include "tests/support/reference.h"

namespace isotouch::loop {
namespace {

using test::Point;
using test::to_voxel;

constexpr Point kMiddle = {32, 32, 32};

struct Ball {
  test::FieldImage image{{64, 64, 64},
                         [](const Point& p) { return test::length(p - kMiddle) - 20.0; },
                         {.stiffness_part = [](const Point& p) { return 100 + static_cast<int>(p.x + p.y); }}};
  const FieldView& view = image.view();
  BlockSums sums{view.image.size()};
  FeltBlocks felt;

  Ball() { sums.take(view.image); }
  std::uint8_t& byte(std::size_t at) { return const_cast<std::uint8_t*>(view.image.data())[at]; }
  bool whole_at(const Vec3<Voxel>& point) { return felt.are_whole(view, sums, point); }
};

Vec3<Voxel> on_the_surface(test::Random& random) { return to_voxel(kMiddle + random.direction() * random.uniform(19, 21)); }

TEST(FeltBlocks, FindAnyBitThatChangesASample) {
  Ball ball;
  test::Random random(7);
  int felt = 0;
  for (int i = 0; i < 200'000; ++i) {
    const Vec3<Voxel> point = on_the_surface(random);
    ball.felt.forget();
    ASSERT_TRUE(ball.whole_at(point));
    // A number of a brick near it; an entry of the tables could lead the sampler anywhere.
    const auto sample = [](Voxel x) { return x.raw() >> Voxel::kFractionBits; };
    const auto near = [&random](std::int32_t x) { return x - 3 + static_cast<std::int32_t>(random.bits() % 8); };
    const std::int16_t* const number =
        &ball.view.brick(near(sample(point.x)), near(sample(point.y)), near(sample(point.z)))[random.bits() % 64];
    std::uint8_t& byte = ball.byte(static_cast<std::size_t>(reinterpret_cast<const std::uint8_t*>(number) - ball.view.image.data()) + 1);
    const core::FieldSample before = core::sample_field(ball.view, point);
    byte ^= 4;
    const core::FieldSample after = core::sample_field(ball.view, point);
    if (!(before.distance == after.distance) || !(before.gradient == after.gradient)) {
      ++felt;
      ASSERT_FALSE(ball.whole_at(point)) << "what the last call looked at";
      ball.felt.forget();
      ASSERT_FALSE(ball.whole_at(point));
    }
    byte ^= 4;
  }
  EXPECT_GT(felt, 5'000);
}

TEST(FeltBlocks, FindTheEntriesOfTheTablesAndTheStiffness) {
  Ball ball;
  test::Random random(8);
  for (int i = 0; i < 1000; ++i) {
    const Vec3<Voxel> point = on_the_surface(random);
    const auto at = [](Voxel x) { return x.raw() >> Voxel::kFractionBits; };
    const std::int32_t x = at(point.x), y = at(point.y), z = at(point.z);
    const std::uint32_t node = ball.view.root[ball.view.root_entry(x, y, z)];
    const void* const places[] = {&ball.view.root[ball.view.root_entry(x, y, z)], &ball.view.nodes[FieldView::node_entry(node, x, y, z)],
                                  &ball.view.stiffness_parts[ball.view.brick_number(x, y, z)]};
    for (const void* const place : places) {
      std::uint8_t& byte = ball.byte(static_cast<std::size_t>(static_cast<const std::uint8_t*>(place) - ball.view.image.data()));
      ball.felt.forget();
      byte ^= 16;
      EXPECT_FALSE(ball.whole_at(point));
      byte ^= 16;
      EXPECT_TRUE(ball.whole_at(point));
    }
  }
}

TEST(FeltBlocks, RememberWhereTheTickBegan) {
  Ball ball;
  const Vec3<Voxel> here{Voxel::of(32), Voxel::of(32), Voxel::of(12)}, there{Voxel::of(32), Voxel::of(32), Voxel::of(52)};
  ASSERT_TRUE(ball.whole_at(here));
  auto& byte =
      ball.byte(static_cast<std::size_t>(reinterpret_cast<const std::uint8_t*>(ball.view.brick(32, 32, 12)) - ball.view.image.data()));
  byte ^= 1;
  EXPECT_FALSE(ball.whole_at(there));
  EXPECT_TRUE(ball.whole_at(there)) << "only what is read";
}

TEST(FeltBlocks, AnyPointWillDo) {
  Ball ball;
  for (const double x : {-8191.0, 0.0, 31.0, 63.9, 8191.0}) {
    for (const double z : {-8191.0, 0.0, 12.0, 63.9, 8191.0}) EXPECT_TRUE(ball.whole_at(to_voxel({x, 32, z})));
  }
}

}  // namespace
}  // namespace isotouch::loop
