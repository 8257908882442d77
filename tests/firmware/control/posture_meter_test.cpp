#include "firmware/control/posture_meter.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>

#include "shared/falcon_packet.h"

namespace isotouch::control {
namespace {

using testing::HasSubstr;

loop::TickRecord tick(std::uint64_t number, const std::array<std::int16_t, 3>& counts) {
  loop::TickRecord record;
  record.number = number;
  record.in.packet = encode(FalconReply{counts, 0, 7});
  record.in.fresh = true;
  record.out.state = static_cast<std::uint16_t>(SupervisorState::kIdle);
  return record;
}

/// The refusal of a second in which tick 500 is as `change` makes it.
std::string refusal_of(const std::function<void(loop::TickRecord&)>& change, bool all = false) {
  PostureMeter meter;
  meter.begin(1000, 0);
  for (std::uint64_t number = 1; number <= 1000 && !meter.has_ended(); ++number) {
    loop::TickRecord record = tick(number, {-200, 100, 3});
    if (all || number == 500) change(record);
    meter.take(record);
  }
  EXPECT_TRUE(meter.has_ended());
  return meter.refusal().sentence();
}

void set_state(loop::TickRecord& record, SupervisorState state) { record.out.state = static_cast<std::uint16_t>(state); }

TEST(PostureMeter, TellsTheMeanOfTheCounts) {
  PostureMeter meter;
  meter.begin(4, 10);
  meter.take(tick(10, {500, 500, 500}));  // before the measurement
  meter.take(tick(11, {-200, 100, 7}));
  meter.take(tick(12, {-201, 100, 7}));
  meter.take(tick(13, {-201, 103, 7}));
  EXPECT_FALSE(meter.has_ended());
  meter.take(tick(14, {-201, 100, 7}));
  ASSERT_TRUE(meter.has_ended());
  EXPECT_EQ(meter.refusal().sentence(), "");
  EXPECT_EQ(meter.counts(), (std::array<std::int32_t, 3>{-200 * 256 - 192, 100 * 256 + 192, 7 * 256}));
  meter.take(tick(15, {0, 0, 0}));
  EXPECT_EQ(meter.counts()[2], 7 * 256) << "what comes later changes nothing";
}

TEST(PostureMeter, IsIdleUntilItBegins) {
  PostureMeter meter;
  EXPECT_TRUE(meter.has_ended());
  meter.take(tick(1, {1, 1, 1}));
  EXPECT_EQ(meter.counts(), (std::array<std::int32_t, 3>{}));
}

TEST(PostureMeter, OneTickWithForceIsTooMuch) {
  EXPECT_THAT(refusal_of([](auto& t) { set_state(t, SupervisorState::kActive); }), HasSubstr("force is active; "));
  EXPECT_THAT(refusal_of([](auto& t) { set_state(t, SupervisorState::kReady); }), HasSubstr("force is active; "));
  EXPECT_THAT(refusal_of([](auto& t) { set_state(t, SupervisorState::kHold); }), HasSubstr("force is active; ")) << "it returns by itself";
  EXPECT_THAT(refusal_of([](auto& t) { t.out.commands[1] = 1; }), HasSubstr("the motors push; "));
}

TEST(PostureMeter, AHandThatMovesIsRefusedAndOneThatTremblesALittleIsNot) {
  const auto moved = [](int counts) {
    return [counts](loop::TickRecord& t) {
      const auto by = static_cast<std::int16_t>(counts);
      t.in.packet = encode(FalconReply{{-200, static_cast<std::int16_t>(100 + by), 3}, 0, 7});
    };
  };
  EXPECT_EQ(refusal_of(moved(PostureMeter::kStill)), "");
  EXPECT_EQ(refusal_of(moved(-PostureMeter::kStill)), "");
  EXPECT_THAT(refusal_of(moved(PostureMeter::kStill + 1)), HasSubstr("the hand moves; "));
  EXPECT_THAT(refusal_of(moved(-PostureMeter::kStill - 1)), HasSubstr("the hand moves; "));
}

TEST(PostureMeter, OnlyAHomedDeviceIsMeasured) {
  const auto unhomed = [](loop::TickRecord& t) { t.in.packet = encode(FalconReply{{-200, 100, 3}, 0, 5}); };
  EXPECT_EQ(refusal_of(unhomed), "") << "the tick remembers that it was homed";
  EXPECT_THAT(refusal_of([&](auto& t) { unhomed(t), set_state(t, SupervisorState::kHoming); }), HasSubstr("not homed; "));
  EXPECT_THAT(refusal_of([&](auto& t) { unhomed(t), set_state(t, SupervisorState::kFault); }), HasSubstr("not homed; "));
  EXPECT_EQ(refusal_of([&](auto& t) { set_state(t, SupervisorState::kHoming); }, true), "") << "homed, but no angles explain the pose yet";
  EXPECT_EQ(refusal_of([&](auto& t) { set_state(t, SupervisorState::kFault); }, true), "") << "stopped by a person";
}

TEST(PostureMeter, WithoutPacketsNothingIsMeasured) {
  EXPECT_THAT(refusal_of([](auto& t) { set_state(t, SupervisorState::kBoot); }), HasSubstr("no device answers; "));
  EXPECT_THAT(refusal_of([](auto& t) { t.in.fresh = false; }, true), HasSubstr("does not answer; "));
  EXPECT_EQ(refusal_of([](auto& t) { t.in.packet[0] = 0; }), "") << "a broken packet counts as none";
}

}  // namespace
}  // namespace isotouch::control
