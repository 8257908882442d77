#include "host/motion/device_in_hand.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/falcon_twin.h"

namespace isotouch::motion {
namespace {

TEST(CountsAt, AreThoseOfTheTwin) {
  for (const test::FalconSet& set : test::falcon_sets()) {
    test::Random random(121);
    int reached = 0, out_of_reach = 0;
    for (int n = 0; n < 50'000; ++n) {
      const test::Point p = {random.uniform(-130, 130), random.uniform(-130, 130), random.uniform(40, 200)};
      const auto exact = set.twin.inverse(p);
      const auto found = counts_at({p.x, p.y, p.z}, set.model);
      ASSERT_EQ(found.has_value(), exact.has_value()) << p.x << ' ' << p.y << ' ' << p.z;
      if (!found) {
        ++out_of_reach;
        continue;
      }
      ++reached;
      for (std::size_t i = 0; i < 3; ++i) ASSERT_NEAR((*found)[i], set.twin.counts_of(*exact)[i], 0.01);
    }
    EXPECT_GT(reached, 10'000);
    EXPECT_GT(out_of_reach, 1'000);
  }
}

TEST(DeviceInHand, KeepsTheLastPlaceWhereTheArmsDoNotReach) {
  DeviceInHand device(libnifalcon_model());
  Input hand = position_input({});
  hand.field_generation = 3;
  hand.buttons = 5;
  const Input inside = device(hand);
  hand.hip.z = Mm::of(100);
  const Input outside = device(hand);
  EXPECT_EQ(outside.packet, inside.packet);
  EXPECT_EQ(device.out_of_reach(), 1U);
  const Result<FalconReply> reply = decode_reply(inside.packet);
  ASSERT_TRUE(reply);
  EXPECT_EQ(*reply, (FalconReply{{-200, -200, -200}, 5, 7}));
  EXPECT_EQ(inside.field_generation, 3U);
  EXPECT_TRUE(inside.fresh);
}

}  // namespace
}  // namespace isotouch::motion
