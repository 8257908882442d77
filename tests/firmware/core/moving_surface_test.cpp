/// A hand on a surface that patches move: what it feels, and that it stays on its side.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <deque>
#include <string>
#include <vector>

#include "firmware/core/lag.h"
#include "firmware/core/moved_surface.h"
#include "tests/firmware/core/led_hand.h"
#include "tests/support/alloc_guard.h"

namespace isotouch::core {
namespace {

TEST(MovingSurface, OneThatRisesOrSinksUnderARestingHandChangesTheForceGently) {
  for (const double step : {0.05, 0.3, 1.0, 2.0, 2.9, -0.05, -0.3, -1.0, -2.0, -2.9}) {
    std::deque<FieldImage> fields;
    for (int n = 0; n <= 4; ++n) fields.push_back(field_of(block(20 + n * step * 0.5)));
    const double z = 14;
    Hand hand = pressed(fields[0], z);
    ASSERT_NEAR(hand.force().z, spring(6), 0.03);
    double most = 0;
    for (std::size_t n = 2; n <= 4; n += 2) {
      double largest = std::max(hand.force().z, spring(20 + static_cast<double>(n) * step * 0.5 - z));
      hand.patch(fields[n]);
      for (int t = 0; t < 200; ++t) {
        hand.go_to({24, 24, z});
        most = std::max(most, hand.change());
        ASSERT_LE(hand.force().z, largest + 0.03) << step;
        ASSERT_GE(hand.force().z, -1e-3) << step;
      }
      EXPECT_NEAR(hand.force().z, spring(20 + static_cast<double>(n) * step * 0.5 - z), 0.05) << step;
      EXPECT_FALSE(hand.lags()) << step;
      EXPECT_TRUE(hand.touches());
    }
    EXPECT_LE(most, kMostChange) << step;
    EXPECT_GT(most, std::abs(step) >= 0.3 ? 0.9 * kMostChange : 0.0) << step;
  }
}

TEST(MovingSurface, OneThatIsGoneLetsTheForceGoByARamp) {
  const FieldImage before = field_of(block(20)), after = field_of(nothing());
  Hand hand = pressed(before, 14);
  const double given = hand.force().z;
  hand.patch(after);
  double last = given;
  int ticks = 0;
  for (; ticks < 1000; ++ticks) {
    hand.go_to({24, 24, 14});
    ASSERT_LE(hand.change(), kMostChange);
    ASSERT_LE(hand.force().z, last);
    ASSERT_FALSE(hand.touches());
    last = hand.force().z;
    if (last == 0) break;
  }
  EXPECT_NEAR(ticks, given / kMostChange, 3);
  hand.go_to({24, 24, 14});
  EXPECT_FALSE(hand.lags());
}

/// A force limit that the spring is far beyond is no store: what was never felt is not let go either.
TEST(MovingSurface, UnderAStreamAForceAtItsLimitIsLetGoAtOnce) {
  const FieldImage before = field_of(block(20)), elsewhere = field_of(block(20.01)), after = field_of(nothing());
  TickSettings strong;
  strong.stiffness = Stiffness::of(3.0);
  strong.force_limit = Newton::of(3.0);
  for (const int patches : {0, 1, 20}) {
    Hand hand = pressed(before, 8, strong);  // the spring would give 18 N
    for (int n = 0; n < patches; ++n) {
      hand.patch(n % 2 == 0 ? elsewhere : before);
      for (int t = 0; t < 33; ++t) hand.go_to({24, 24, 8});
    }
    ASSERT_NEAR(hand.force().z, 3.0, 0.001) << patches;
    hand.patch(after);
    int ticks = 0;
    for (; hand.force().z > 0 && ticks < 1000; ++ticks) {
      hand.go_to({24, 24, 8});
      ASSERT_LE(hand.change(), kMostChange);
    }
    EXPECT_NEAR(ticks, 3.0 / 0.0475, 2) << patches;
  }
}

/// The same where the hand leaves the body by itself while its force still lags behind a patch elsewhere.
TEST(MovingSurface, AHandThatSlipsOffAnEdgeKeepsNoMoreThanItsLimitLetThrough) {
  const FieldImage before = field_of(block(20)), elsewhere = field_of(block(20.01));
  TickSettings strong;
  strong.stiffness = Stiffness::of(3.0);
  strong.force_limit = Newton::of(3.0);
  for (const int wait : {1, 5, 12}) {
    Hand hand(before, strong);
    hand.lead({38, 24, 30}, {38, 24, 8}, 400);
    hand.patch(elsewhere);
    for (int t = 0; t < wait; ++t) hand.go_to({38, 24, 8});
    ASSERT_NEAR(length(hand.force()), 3.0, 0.01);
    int ticks = 0, free = 0;
    for (; ticks < 600; ++ticks) {
      hand.go_to({std::min(41.0, 38 + 1.0 * ticks), 24, 8});
      if (!hand.touches() && length(hand.force()) > 0) ++free;
    }
    ASSERT_FALSE(hand.touches());
    EXPECT_LE(free, 3.0 / 0.0475 + 2) << wait;
  }
}

/// What the spring holds against the dampers of a moving hand goes with them: a hand that stops is not pulled in.
TEST(MovingSurface, OneThatIsLaidOverAMovingHandNeverPullsIt) {
  const FieldImage before = field_of(block(20)), after = field_of(block(20.4));
  for (const Damping damping : {Damping::of(0.01), Damping::of(0.02), Damping::of(0.05), Damping::of(0.1)}) {
    for (const double speed : {0.2, 0.4, 0.6}) {  // voxels a tick: up to 300 mm/s
      TickSettings damped;
      damped.hand_damping = damping;
      Hand hand(before, damped);
      double z = 30;
      while (z - speed > 20.2) hand.go_to({24, 24, z -= speed});
      hand.patch(after);
      for (int t = 0; t < 400; ++t) {
        hand.go_to({24, 24, z -= speed * std::max(0.0, 1 - t / 10.0)});
        ASSERT_GE(hand.force().z, -1e-3) << damping.raw() << " " << speed << " tick " << t;
      }
      ASSERT_TRUE(hand.touches());
      EXPECT_NEAR(hand.force().z, std::min(8.0, spring(20.4 - z)), 0.02) << damping.raw() << " " << speed;
    }
  }
}

/// The spring that is gone gives no more than it held.
TEST(MovingSurface, AHandThatGoesWithAForceThatIsLetGoUsesItUp) {
  const FieldImage before = field_of(block(20)), after = field_of(nothing());
  for (const double speed : {0.02, 0.1, 0.5}) {  // voxels a tick
    Hand hand = pressed(before, 14);
    const double held = 0.5 * kStiffness * 9;  // mJ
    hand.patch(after);
    double work = 0, z = 14;
    for (int t = 0; t < 400; ++t) {
      work += hand.force().z * speed * kEdge;
      z += speed;
      hand.go_to({24, 24, z});
    }
    EXPECT_LE(work, held * 1.02 + spring(6) * speed * kEdge) << speed;
    EXPECT_GT(work, 0.01 * held) << speed;
  }
}

TEST(MovingSurface, AHandThatPushesAgainstAForceThatIsLetGoDoesNotMakeItGrow) {
  const FieldImage before = field_of(block(20)), after = field_of(nothing());
  Hand hand = pressed(before, 14);
  hand.patch(after);
  double last = hand.force().z, z = 14;
  for (int t = 0; t < 100; ++t) {
    hand.go_to({24, 24, z -= 0.05});
    ASSERT_LE(hand.force().z, last);
    last = hand.force().z;
  }
}

TEST(MovingSurface, ABodyThatAppearsRoundTheHandGivesNoForceUntilItHasLeft) {
  const FieldImage before = field_of(nothing()), after = field_of(ball({24, 24, 24}, 12));
  Hand hand(before);
  hand.lead({24, 24, 24}, {24, 24, 25}, 20);
  hand.patch(after);
  for (int t = 0; t < 100; ++t) {
    hand.go_to({24, 24, 25 + 0.05 * t});
    ASSERT_EQ(length(hand.force()), 0) << t;
    ASSERT_TRUE(hand.is_inside());
  }
  hand.lead({24, 24, 30}, {24, 24, 38}, 200);
  EXPECT_FALSE(hand.is_inside());
  hand.lead({24, 24, 38}, {24, 24, 34}, 200);
  EXPECT_TRUE(hand.touches());
  EXPECT_NEAR(hand.force().z, spring(2), 0.05);
}

TEST(MovingSurface, ABodyThatAppearsRoundATouchingHandLetsItsForceGo) {
  const FieldImage before = field_of(block(20)), after = field_of(ball({24, 24, 20}, 13));
  Hand hand = pressed(before, 14);
  hand.patch(after);
  for (int t = 0; t < 200; ++t) {
    hand.go_to({24, 24, 14});
    ASSERT_LE(hand.change(), kMostChange);
    ASSERT_TRUE(hand.is_inside());
  }
  EXPECT_EQ(length(hand.force()), 0);
}

/// What a scan's noise does: a free hand just in front of the surface must not fall through it.
TEST(MovingSurface, ASurfaceThatRisesALittleOverAFreeHandIsFelt) {
  for (const double rise : {0.3, 1.0, 2.5}) {
    const FieldImage before = field_of(block(20)), after = field_of(block(20 + rise));
    Hand hand(before);
    hand.lead(kAbove, {24, 24, 20.2}, 400);
    ASSERT_FALSE(hand.touches());
    hand.patch(after);
    hand.go_to({24, 24, 20.2});
    EXPECT_TRUE(hand.touches()) << rise;
    EXPECT_LE(length(hand.force()), kMostChange) << "no blow";
    for (int t = 0; t < 100; ++t) {
      hand.go_to({24, 24, 20.2});
      ASSERT_LE(hand.change(), kMostChange);
    }
    EXPECT_NEAR(hand.force().z, spring(rise - 0.2), 0.05) << rise;
    hand.lead({24, 24, 20.2}, {24, 24, 10}, 400);
    EXPECT_TRUE(hand.touches()) << "it does not let the hand through";
  }
}

TEST(MovingSurface, APlateIsNeverLeftByItsBack) {
  for (const double step : {-2.9, -2.0, -1.0, -0.4, 0.4, 1.0, 2.0, 2.9}) {
    const FieldImage before = field_of(plate(22)), after = field_of(plate(22 + step));
    for (const double z : {23.0, 22.0, 20.0, 15.0}) {  // in the plate, and beyond it
      Hand hand = pressed(before, z);
      ASSERT_TRUE(hand.touches());
      hand.patch(after);
      for (int t = 0; t < 100; ++t) {
        hand.go_to({24, 24, z});
        ASSERT_LE(hand.change(), kMostChange) << step << " " << z;
        ASSERT_GT(hand.proxy().z, std::min(23.5 + step - 0.2, z)) << step << " " << z << " tick " << t;
      }
      EXPECT_TRUE(hand.touches() || z > 23.5 + step - 0.1) << step << " " << z;
    }
  }
}

TEST(MovingSurface, AHandFeelsItsOwnWayAtOnce) {
  const FieldImage before = field_of(block(20)), after = field_of(block(22));
  Hand hand = pressed(before, 14);
  hand.patch(after);
  for (int t = 0; t < 8; ++t) hand.go_to({24, 24, 14});
  const double force = hand.force().z;
  ASSERT_TRUE(hand.lags());
  hand.go_to({24, 24, 14.5});
  EXPECT_NEAR(hand.force().z, force - spring(0.5), kMostChange + 0.01);
}

/// A patch somewhere else is not felt: after it the forces are those that they would have been.
TEST(MovingSurface, APatchElsewhereIsNotFelt) {
  const auto with_lump = [](double x) {
    return field_of([=](const Point& at) { return std::min(block(20)(at), length(at - Point{x, 12, 21}) - 3); });
  };
  const FieldImage before = with_lump(12), after = with_lump(14);
  TickSettings rough, damped, limited;
  rough.friction = Ratio::of(0.4);
  damped.damping = Damping::of(0.01);
  damped.hand_damping = Damping::of(0.005);
  limited.force_limit = Newton::of(1.0);
  for (const TickSettings& settings : {TickSettings{}, rough, damped, limited}) {
    for (const double push : {0.0, 0.1, 0.2}) {  // voxels a tick: up to 100 mm/s
      Hand patched = pressed(before, 16, settings), alone = pressed(before, 16, settings);
      double most = 0, largest = 0;
      for (int t = 0; t < 300; ++t) {
        if (t % 33 == 20) patched.patch(t % 2 == 0 ? after : before);
        const Point at = {24 + 0.02 * t, 24, 16 - push * (t % 50 < 25 ? t % 50 : 50 - t % 50)};
        patched.go_to(at), alone.go_to(at);
        most = std::max(most, length(patched.force() - alone.force()));
        largest = std::max(largest, length(alone.force()));
      }
      EXPECT_LE(most, 0.01) << push;
      EXPECT_GT(largest, 0.9);
    }
  }
}

TEST(MovingSurface, DampersDoNotTakeAPatchForSpeed) {
  const FieldImage before = field_of(block(20)), after = field_of(block(22.5));
  TickSettings damped;
  damped.damping = Damping::of(0.01);
  damped.hand_damping = Damping::of(0.005);
  damped.passivity = Damping::of(0.012);
  damped.friction = Ratio::of(0.5);
  Hand hand = pressed(before, 14, damped);
  hand.patch(after);
  for (int t = 0; t < 300; ++t) {
    hand.go_to({24, 24, 14});
    ASSERT_LE(hand.change(), kMostChange) << t;
  }
}

TEST(MovingSurface, ASphereThatRollsUnderARestingHandChangesTheForceGently) {
  std::deque<FieldImage> fields;
  for (int n = 0; n < 24; ++n) fields.push_back(field_of(ball({18 + 0.5 * n, 24, 20}, 9)));
  Hand hand(fields[0]);
  hand.lead({22, 24, 34}, {22, 24, 26}, 400);
  for (int t = 0; t < 100; ++t) hand.go_to({22, 24, 26});
  ASSERT_TRUE(hand.touches());
  for (std::size_t n = 1; n < fields.size(); ++n) {
    hand.patch(fields[n]);
    for (int t = 0; t < 33; ++t) {
      hand.go_to({22, 24, 26});
      ASSERT_LE(hand.change(), kMostChange) << n;
      ASSERT_LE(length(hand.force()), spring(6)) << n;
    }
  }
}

/// A hand of 0.3 kg that rests against a spring and a damper of an arm, as the surface comes and goes: the work that it is given.
TEST(MovingSurface, TheWorkThatAHandIsGivenIsBounded) {
  for (const double speed : {10.0, 40.0, -10.0, -40.0}) {  // mm/s, by 30 patches a second
    std::deque<FieldImage> fields;
    const double step = speed / 30 / kEdge;
    const int patches = static_cast<int>(10 / std::abs(speed) * 30);
    for (int n = 0; n <= patches; ++n) fields.push_back(field_of(block((speed > 0 ? 14 : 24) + n * step)));
    const double rest = speed > 0 ? 14 * kEdge - 1 : 24 * kEdge - 1;
    Hand hand(fields[0]);
    hand.lead(kAbove, {24, 24, rest / kEdge}, 400);
    const double push = hand.force().z;  // what the arm holds against
    double z = rest, v = 0, work = 0, fastest = 0, most_force = 0;
    std::size_t next = 1;
    for (int t = 0; t < patches * 33 + 300; ++t) {
      if (t % 33 == 0 && next < fields.size()) hand.patch(fields[next++]);
      const double force = hand.force().z;
      v += (force - push - 0.3 * (z - rest) - 0.01 * v) / 0.3;  // mm/ms² per kg: N/kg = 1e-3 mm/ms²
      const double way = v * 1e-3;
      work += force * way;
      z += way;
      fastest = std::max(fastest, std::abs(v));
      most_force = std::max(most_force, force);
      hand.go_to({24, 24, z / kEdge});
    }
    RecordProperty("work_mj_per_cm_at_" + std::to_string(static_cast<int>(speed)), std::to_string(work / std::abs(10.0)));
    std::printf("%+.0f mm/s: %.2f mJ over 10 mm of motion, hand moved %.2f mm, fastest %.1f mm/s, largest force %.2f N\n", speed, work,
                z - rest, fastest, most_force);
    EXPECT_LT(most_force, 8.01);
    EXPECT_LT(std::abs(work), 40);
  }
}

TEST(MovingSurface, CostsNoAllocation) {
  const FieldImage before = field_of(block(20)), after = field_of(block(21));
  Hand hand = pressed(before, 14);
  const test::AllocGuard guard;
  hand.patch(after);
  for (int t = 0; t < 50; ++t) hand.go_to({24, 24, 14});
  EXPECT_EQ(guard.count(), 0U);
}

}  // namespace
}  // namespace isotouch::core
