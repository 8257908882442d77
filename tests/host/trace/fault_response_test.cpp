#include "host/trace/fault_response.h"

#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

#include "host/error.h"
#include "shared/falcon_packet.h"
#include "tests/support/chained.h"
#include "tests/support/scratch_folder.h"

namespace isotouch::trace {
namespace {

using Change = std::function<void(std::size_t tick, TraceRecord&)>;

FalconPacket packet(std::int16_t count, std::uint8_t homed = 7) { return encode(FalconReply{{count, 10, -10}, 0, homed}); }

/// A hand that presses all the time, but for what `change` does.
std::vector<FaultResponse> responses(const Change& change, std::size_t ticks = 40) {
  const ScratchFolder folder;
  TraceHeader header;
  header.device = libnifalcon_model();
  header.has_outputs = true;
  TraceWriter writer(folder.path() / "felt.trace", header);
  Chain chain(header);
  for (std::size_t tick = 0; tick < ticks; ++tick) {
    TraceRecord record;
    record.input.packet = packet(100);
    record.input.fresh = true;
    record.output.commands = {1, 0, 0};
    record.output.state = static_cast<std::uint16_t>(SupervisorState::kActive);
    change(tick, record);
    writer.append(test::chained(chain, record));
  }
  writer.finish();
  return fault_responses(read_trace(folder.path() / "felt.trace"));
}

void rest(TraceRecord& record) {
  record.output.commands = {};
  record.output.state = static_cast<std::uint16_t>(SupervisorState::kHold);
}

/// What one changed tick, the 20th, shows.
std::string shown(const std::function<void(Input&)>& change) {
  const auto all = responses([&](std::size_t tick, TraceRecord& record) {
    if (tick == 20) change(record.input);
    if (tick >= 20) rest(record);
  });
  EXPECT_LE(all.size(), 1U);
  if (all.empty()) return "";
  EXPECT_EQ(all[0].tick, 20U);
  EXPECT_EQ(all[0].ticks, 0U);
  EXPECT_EQ(all[0].state, SupervisorState::kHold);
  return all[0].condition;
}

TEST(FaultResponse, AHandThatPressesShowsNothing) {
  EXPECT_TRUE(responses([](std::size_t, TraceRecord&) {}).empty());
}

TEST(FaultResponse, WithoutAMotorCommandThereIsNothingToJudge) {
  const auto never = [](std::size_t tick, TraceRecord& record) {
    rest(record);
    if (tick == 20) record.input.requests = kRequestStop;
  };
  EXPECT_THROW((void)responses(never), InputError);
}

TEST(FaultResponse, EveryConditionHasItsName) {
  EXPECT_EQ(shown([](Input& in) { in.requests = kRequestStop; }), "stop");
  EXPECT_EQ(shown([](Input& in) { in.lines = kLineStop; }), "lines");
  EXPECT_EQ(shown([](Input& in) { in.lines = kLineEnableWrong; }), "enable");
  EXPECT_EQ(shown([](Input& in) { in.lines = kLineStop | kLineEnableWrong; }), "lines+enable");
  EXPECT_EQ(shown([](Input& in) { in.late = 3; }), "late");
  EXPECT_EQ(shown([](Input& in) { in.packet = packet(501); }), "jump");
  EXPECT_EQ(shown([](Input& in) { in.packet = packet(301); }), "leap");
  EXPECT_EQ(shown([](Input& in) { in.packet = packet(151, 3); }), "unhomed");
}

TEST(FaultResponse, WhatStaysBelowALimitShowsNothing) {
  EXPECT_EQ(shown([](Input& in) { in.late = 2; }), "");
  EXPECT_EQ(shown([](Input& in) { in.packet = packet(300); }), "");
  EXPECT_EQ(shown([](Input& in) { in.packet = packet(150, 3); }), "");  // the bits went, the reference stayed
  EXPECT_EQ(shown([](Input& in) { in.packet[0] = 0; }), "");            // one malformed packet is no silence yet
}

/// The counts that are known are older than one tick.
TEST(FaultResponse, TicksThatWereLeftOutMakeRoomForALongerWay) {
  EXPECT_EQ(shown([](Input& in) { in.late = 2, in.packet = packet(1100); }), "");
  EXPECT_EQ(shown([](Input& in) { in.late = 2, in.packet = packet(1301); }), "jump");
  EXPECT_EQ(shown([](Input& in) { in.late = 1, in.packet = packet(340); }), "");  // in one tick a leap
}

TEST(FaultResponse, AnOldPacketIsStaleInItsFirstTick) {
  EXPECT_EQ(shown([](Input& in) { in.fresh = false, in.age = 5; }), "stale");
}

TEST(FaultResponse, AfterALongPauseALegThatWasNotHomedIsAnew) {
  const auto condition = [](std::uint8_t late) {
    const auto all = responses([late](std::size_t tick, TraceRecord& record) {
      record.input.packet = packet(100, 3);
      if (tick == 20) record.input.late = late;
      if (tick >= 20) rest(record);
    });
    return all.size() == 1 ? all[0].condition : "";
  };
  EXPECT_EQ(condition(kMaxLate - 1), "late");
  EXPECT_EQ(condition(kMaxLate), "late+unhomed");
}

TEST(FaultResponse, SilenceIsShownInItsThirdTick) {
  for (const bool malformed : {false, true}) {
    const auto all = responses([&](std::size_t tick, TraceRecord& record) {
      if (tick >= 10 && tick < 20) {
        record.input.fresh = malformed;
        record.input.packet[0] = malformed ? 0 : record.input.packet[0];
        record.input.age = static_cast<std::uint16_t>(malformed ? 0 : tick - 9);
      }
      if (tick >= 13 && tick < 30) rest(record);
    });
    ASSERT_EQ(all.size(), 1U) << malformed;
    EXPECT_EQ(all[0].condition, "stale");
    EXPECT_EQ(all[0].tick, 12U);
    EXPECT_EQ(all[0].ticks, 1U);
  }
}

TEST(FaultResponse, LatenessOfThreeTicksAddsUp) {
  const auto all = responses([](std::size_t tick, TraceRecord& record) {
    if (tick >= 10 && tick < 13) record.input.late = 2;
    if (tick >= 12) rest(record);
  });
  ASSERT_EQ(all.size(), 1U);
  EXPECT_EQ(all[0].tick, 11U);
  EXPECT_EQ(all[0].ticks, 1U);
}

TEST(FaultResponse, WordsThatStayAreToldAsNeverEnding) {
  const auto all = responses([](std::size_t tick, TraceRecord& record) { record.input.lines = tick == 20 ? kLineStop : 0; });
  ASSERT_EQ(all.size(), 1U);
  EXPECT_FALSE(all[0].ticks.has_value());
  EXPECT_EQ(all[0].state, SupervisorState::kActive);
}

TEST(FaultResponse, WithoutWordsThereIsNothingToEnd) {
  EXPECT_TRUE(responses([](std::size_t tick, TraceRecord& record) {
                if (tick >= 10) rest(record);
                record.input.lines = tick >= 20 ? kLineStop : 0;
              }).empty());
}

TEST(FaultResponse, TheSameConditionCountsAgainOnceForcesHadReturned) {
  const auto all = responses([](std::size_t tick, TraceRecord& record) {
    record.input.lines = tick % 10 == 5 ? kLineStop : 0;
    if (tick % 10 == 7) rest(record);
  });
  ASSERT_EQ(all.size(), 4U);
  for (const FaultResponse& response : all) EXPECT_EQ(response.ticks, 2U);
}

}  // namespace
}  // namespace isotouch::trace
