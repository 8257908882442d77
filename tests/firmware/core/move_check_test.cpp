#include "firmware/core/move_check.h"

#include <gtest/gtest.h>

namespace isotouch::core {
namespace {

Vec3<Mm> at(double x) { return {Mm::from_raw(static_cast<std::int32_t>(x * 1048576)), Mm{}, Mm{}}; }

TEST(MoveCheck, TheLargestMoveIsATicksWayAtTwiceTheLimit) {
  EXPECT_EQ(make_largest_move(libnifalcon_model(), 1'000'000), Mm::of(4));
  EXPECT_NEAR(make_largest_move(libnifalcon_model(), 100'000).raw(), Mm::of(0.4).raw(), 1);
  DeviceModel device = libnifalcon_model();
  device.speed_limit = MmPerS::of(100'000);
  EXPECT_EQ(make_largest_move(device, 4'000'000), Mm::of(100));
  device.speed_limit = MmPerS::of(1);
  EXPECT_GT(make_largest_move(device, 100'000), Mm{});
}

TEST(MoveCheck, ALeapIsMoreThanThatAndToldOnce) {
  MoveState state;
  EXPECT_FALSE(is_leap(at(50), true, Mm::of(4), state)) << "the first one has no place before it";
  EXPECT_FALSE(is_leap(at(54), true, Mm::of(4), state));
  EXPECT_TRUE(is_leap(at(49.99), true, Mm::of(4), state));
  EXPECT_FALSE(is_leap(at(49.99), true, Mm::of(4), state));
}

TEST(MoveCheck, MissedSamplesAllowTheirWayUpToEight) {
  for (const int missed : {1, 6, 7, 30}) {
    const double most = 4.0 * std::min(missed + 1, 8);
    for (const double way : {most, most + 0.01}) {
      MoveState state;
      is_leap(at(0), true, Mm::of(4), state);
      for (int t = 0; t < missed; ++t) EXPECT_FALSE(is_leap(at(700), false, Mm::of(4), state));
      EXPECT_EQ(is_leap(at(way), true, Mm::of(4), state), way > most) << missed;
    }
  }
}

}  // namespace
}  // namespace isotouch::core
