#include "host/touch/session.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "hil/plain_replay.h"
#include "tests/support/device_bench.h"

namespace isotouch::touch {
namespace {

using test::ball, test::kCentre;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
const Place kOutside = {kCentre[0] + 12, kCentre[1], kCentre[2]};
const Place kInside = {kCentre[0] + 6, kCentre[1], kCentre[2]};  // of a ball of 8 mm

/// A session on the ball, with room for a trace of so many ticks.
struct Bench {
  explicit Bench(std::size_t ticks = 1000) : room(trace_layout::kHeaderBytes + ticks * trace_layout::kRecordBytes) {
    EXPECT_EQ(session.load(ball().view().image), nullptr);
    session.record_into(room);
  }
  Felt stay(const Place& place, int ticks = 1) {
    Felt felt;
    for (int i = 0; i < ticks; ++i) EXPECT_EQ(session.tick(place, 0, felt), nullptr);
    return felt;
  }
  /// Does the trace so far replay to the bit?
  bool replays() {
    const auto report = replay::run(ball().view(), session.trace());
    return report && report->equal && report->ticks == session.recorded();
  }

  Session session;
  std::vector<std::uint8_t> room;
};

TEST(Session, ATraceReplaysToTheBit) {
  Bench bench;
  bench.stay(kOutside, 10);
  const Felt felt = bench.stay(kInside, 200);
  EXPECT_NEAR(felt.penetration, 2, 0.05);
  EXPECT_GT(felt.force[0], 0.5);
  EXPECT_EQ(bench.session.recorded(), 210U);
  EXPECT_TRUE(bench.replays());
}

/// The force of a tick is held until the next one: on the way in it is that of less depth, on the way out that of more. That is what makes walls tremble.
TEST(Session, SamplingGivesEnergyToAHandThatGoesInAndOut) {
  Bench bench;
  bench.stay(kOutside, 10);
  constexpr double kStep = 0.3;
  Felt felt;
  for (int i = 0; i <= 20; ++i) felt = bench.stay({kOutside[0] - kStep * i, kOutside[1], kOutside[2]});
  const double force = felt.force[0];
  for (int i = 20; i >= 0; --i) felt = bench.stay({kOutside[0] - kStep * i, kOutside[1], kOutside[2]});
  EXPECT_NEAR(felt.energy, force * kStep, 0.1 * force * kStep) << "half of the largest force times a step, twice";
}

TEST(Session, TheWorkIsThatOfTheForceAndNoneIsDoneWhileTheHandIsAway) {
  Bench bench;
  bench.stay(kOutside, 10);
  Felt felt;
  for (int i = 0; i <= 600; ++i) felt = bench.stay({kOutside[0] - 0.01 * i, kOutside[1], kOutside[2]});
  EXPECT_NEAR(felt.energy, -0.5 * felt.force[0] * felt.penetration, 0.1) << "half of k x²";
  EXPECT_LT(felt.energy, -0.5);
  const double pressed = felt.energy;
  bench.session.lift();
  EXPECT_EQ(bench.stay({kInside[0], kInside[1] + 1, kInside[2]}).energy, pressed);
  EXPECT_NE(bench.stay({kInside[0], kInside[1] + 2, kInside[2]}).energy, pressed);
  ASSERT_EQ(bench.session.load(ball().view().image), nullptr);
  EXPECT_EQ(bench.stay(kOutside).energy, 0.0);
}

TEST(Session, ATraceBeginsWhenTheHandTouchesNothing) {
  Bench bench;
  bench.stay(kOutside, 2);
  bench.stay(kInside, 200);
  bench.session.record_into(bench.room);
  const double force = bench.stay(kInside, 100).force[0];
  EXPECT_GT(force, 0.5) << "the hand notices nothing";
  EXPECT_TRUE(bench.session.waits());
  EXPECT_EQ(bench.session.recorded(), 0U);
  bench.stay(kOutside, 3);  // in the first it still leaves
  EXPECT_FALSE(bench.session.waits());
  bench.stay(kInside, 50);
  EXPECT_GE(bench.session.recorded(), 50U);
  EXPECT_TRUE(bench.replays());
}

TEST(Session, AHandInsideANewFieldFeelsNothingUntilItHasLeft) {
  Bench bench;
  EXPECT_EQ(bench.stay(kInside, 10).status, std::uint32_t{kHeldInside});
  bench.stay(kOutside);
  EXPECT_NE(bench.stay(kInside, 10).status & kContact, 0U);
  ASSERT_EQ(bench.session.load(ball().view().image), nullptr);
  EXPECT_EQ(bench.stay(kInside, 10).status, std::uint32_t{kHeldInside});
}

TEST(Session, AChangeIsFeltAtOnceAndEndsTheTrace) {
  const auto row = index_of(TickSetting::kStiffness);
  Bench bench;
  bench.stay(kOutside, 2);
  const double force = bench.stay(kInside, 300).force[0];
  ASSERT_EQ(bench.session.set(row, 0.1), nullptr);
  EXPECT_EQ(bench.session.recorded(), 0U);
  EXPECT_TRUE(bench.session.trace().empty());
  const double softer = bench.stay(kInside).force[0];
  EXPECT_LT(softer, force / 2);
  EXPECT_GT(softer, 0.1);
  EXPECT_NEAR(bench.session.setting(row), 0.1, 1e-4);
}

TEST(Session, AFullTraceEndsAndStaysWhole) {
  Bench bench(20);
  bench.stay(kOutside, 50);
  EXPECT_EQ(bench.session.recorded(), 20U);
  std::vector<std::uint8_t> more(2 * bench.room.size());
  std::copy(bench.room.begin(), bench.room.end(), more.begin());
  bench.session.extend_room(more);
  bench.stay(kOutside, 50);
  EXPECT_EQ(bench.session.recorded(), 20U) << "ticks are missing: none may follow";
  EXPECT_TRUE(bench.replays());
}

TEST(Session, WhatIsRefusedChangesNothing) {
  Bench bench;
  bench.stay(kOutside, 5);
  Felt felt;
  double mm = 0;
  EXPECT_NE(bench.session.tick({0, kNan, 0}, 0, felt), nullptr);
  EXPECT_NE(bench.session.tick({0, 0, std::numeric_limits<double>::infinity()}, 0, felt), nullptr);
  EXPECT_NE(bench.session.sample({kNan, 0, 0}, mm), nullptr);
  for (std::size_t row = 0; row < kTickSettings; ++row) {
    EXPECT_NE(bench.session.set(row, kNan), nullptr);
    EXPECT_NE(bench.session.set(row, kTickSettingRows[row]->high * 1.01 + 1), nullptr);
  }
  EXPECT_NE(bench.session.set(kTickSettings, 0), nullptr);
  EXPECT_NE(bench.session.set_period(kNan), nullptr);
  EXPECT_NE(bench.session.set_device({}), nullptr);
  EXPECT_EQ(bench.session.recorded(), 5U);
  EXPECT_TRUE(bench.replays());
  Session empty;
  EXPECT_NE(empty.tick(kOutside, 0, felt), nullptr);
  EXPECT_NE(empty.load(std::span(bench.room).first(100)), nullptr);
}

TEST(Session, ASteepFieldWithoutACertificateIsRefusedAsAControllerDoes) {
  for (const double slope : {1.9, 2.1}) {
    const test::FieldImage steep({40, 40, 40},
                                 [slope](const test::Point& p) {
                                   return slope * (test::length(p - test::Point{19.7, 20.1, 20.3}) - 11.0);
                                 },
                                 {.band = 7.0, .stiffness = 0.8});
    Session session;
    const Refused refused = session.load(steep.view().image);
    EXPECT_EQ(refused == nullptr, slope < 2) << (refused == nullptr ? "" : refused);
    EXPECT_EQ(session.field().has_value(), slope < 2);
  }
}

TEST(Session, APlaceIsTheNearestOfTheFormat) {
  Bench bench;
  constexpr double kUnit = 1.0 / (1 << 20);
  for (const double raw : {12345678.0, -12345678.0, 12345678.49, -12345678.49, -12345677.51, 0.0}) {
    EXPECT_EQ(bench.stay({kOutside[0], raw * kUnit, kOutside[2]}).hip[1], std::round(raw) * kUnit) << raw;
  }
  EXPECT_EQ(bench.stay({1e300, 0, -1e9}).hip, (Place{512, 0, -512}));
}

TEST(Session, ADistanceIsThatOfTheBall) {
  Bench bench;
  double mm = 0;
  ASSERT_EQ(bench.session.sample({kCentre[0], kCentre[1] + 7, kCentre[2]}, mm), nullptr);
  EXPECT_NEAR(mm, -1, 0.02);
}

}  // namespace
}  // namespace isotouch::touch
