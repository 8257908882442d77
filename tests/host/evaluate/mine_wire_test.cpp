#include "host/evaluate/mine_wire.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <set>

#include "firmware/core/device_tick.h"
#include "host/error.h"
#include "host/evaluate/motion.h"
#include "host/evaluate/replay.h"
#include "host/evaluate/wire_hand.h"
#include "tests/support/field_image.h"

namespace isotouch::evaluate {
namespace {

const BlobView& ball() {
  static const test::FieldImage image({64, 64, 64}, [](const test::Point& p) {
    return std::sqrt((p[0] - 32) * (p[0] - 32) + (p[1] - 32) * (p[1] - 32) + (p[2] - 32) * (p[2] - 32)) - 20;
  });
  return image.view();
}

WireRecording harmless() {
  WireRecording recording;
  recording.header.device = libnifalcon_model();
  recording.header.run.model_hash = hash(recording.header.device);
  WireHand wire(recording.header.device);
  make_motion(&ball(), {.kind = "slide", .ticks = 16'000}, [&](const TickInput& input) { recording.inputs.push_back(wire(input, 1)); });
  return recording;
}

std::vector<DeviceTraceRecord> answers(const WireRecording& recording) {
  DeviceRun run(ball(), recording.header);
  std::vector<DeviceTraceRecord> records;
  for (const DeviceInput& input : recording.inputs) records.push_back(run.step(input));
  return records;
}

TEST(MinedWire, IsTheSameForASeedAndAnotherForAnother) {
  const WireRecording recording = harmless();
  for (const std::string& kind : mined_wires()) {
    const WireRecording first = mine_wire(recording, kind, 7);
    EXPECT_EQ(first.inputs, mine_wire(recording, kind, 7).inputs) << kind;
    EXPECT_NE(first.inputs, recording.inputs) << kind;
    EXPECT_NE(first.inputs, mine_wire(recording, kind, 8).inputs) << kind;
    ASSERT_EQ(first.inputs.size(), recording.inputs.size());
    for (const DeviceInput& in : first.inputs) {
      const DeviceTraceRecordBytes bytes = encode(DeviceTraceRecord{in, {}, 0, 0});
      ASSERT_TRUE(decode_device_record(bytes)) << kind;  // a trace may hold it
    }
  }
  EXPECT_THROW(mine_wire(recording, "wave", 1), InputError);
}

TEST(MinedWire, WrappedCountsStandForTheSamePlaceUntilTheyWrapWhichIsAFault) {
  const WireRecording recording = harmless();
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    const WireRecording mined = mine_wire(recording, "wrap", seed);
    EXPECT_EQ(mined.header.run.model_hash, hash(mined.header.device));
    const auto plain = answers(recording), turned = answers(mined);
    std::size_t first_wrap = 0;
    for (std::size_t tick = 1; first_wrap == 0 && tick < turned.size(); ++tick) {
      const auto before = decode_reply(mined.inputs[tick - 1].packet), now = decode_reply(mined.inputs[tick].packet);
      for (std::size_t i = 0; i < 3; ++i) {
        if (std::abs(now->counts[i] - before->counts[i]) > 30'000) first_wrap = tick;
      }
    }
    ASSERT_GT(first_wrap, 10U);
    for (std::size_t tick = 0; tick < first_wrap; ++tick) {  // at_zero is rounded to 2^-32 of a turn
      const Vec3<Mm> off = turned[tick].output.hip - plain[tick].output.hip;
      ASSERT_LT(std::abs(off.x.raw()) + std::abs(off.y.raw()) + std::abs(off.z.raw()), 300) << tick;
    }
    EXPECT_NE(turned[first_wrap].output.tick.status & kCountJump, 0U);
    for (std::size_t tick = first_wrap; tick < first_wrap + 2; ++tick) {
      EXPECT_EQ(turned[tick].output.tick.words, (std::array<std::int16_t, 3>{}));
    }
  }
}

TEST(MinedWire, EveryFaultThatAWireCanShowIsInTheFaults) {
  const auto records = answers(mine_wire(harmless(), "faults", 1));
  std::uint32_t status = 0;
  std::uint16_t faults = 0;
  std::set<std::uint16_t> states;
  std::size_t active = 0, restarts = 0, without_field = 0;
  for (const DeviceTraceRecord& record : records) {
    status |= record.output.tick.status;
    faults |= record.output.faults;
    states.insert(record.output.tick.state);
    active += record.output.tick.state == static_cast<std::uint16_t>(SupervisorState::kActive) ? 1U : 0U;
    restarts += (record.input.commands & kCommandRestart) != 0 ? 1U : 0U;
    without_field += record.input.field_generation == 0 ? 1U : 0U;
  }
  EXPECT_EQ(status & (kStale | kBadReply | kCountJump | kLate), kStale | kBadReply | kCountJump | kLate);
  const std::uint16_t expected = kFaultStopped | kFaultSilent | kFaultLate | kFaultEmergency | kFaultEnable;
  EXPECT_EQ(faults & expected, expected);
  EXPECT_EQ(states.size(), 7U);  // each of the supervisor's
  EXPECT_GT(active, records.size() / 4);
  EXPECT_GT(restarts, 0U);
  EXPECT_GT(without_field, 0U);
}

TEST(MinedWire, AGripThatIsLetGoHasNoForces) {
  std::size_t held = 0, released = 0;
  for (const DeviceTraceRecord& record : answers(mine_wire(harmless(), "grip", 1))) {
    const bool active = record.output.tick.state == static_cast<std::uint16_t>(SupervisorState::kActive);
    (record.output.buttons != 0 ? held : released) += 1;
    EXPECT_FALSE(active && record.output.buttons == 0);
  }
  EXPECT_GT(held, 5000U);
  EXPECT_GT(released, 1000U);
}

TEST(MinedWire, APersonWhoResumesEndsEveryFaultAgain) {
  const WireRecording wrapped = mine_wire(harmless(), "wrap", 1);
  const auto longest_fault = [](const WireRecording& recording) {
    std::size_t longest = 0, now = 0;
    for (const DeviceTraceRecord& record : answers(recording)) {
      now = record.output.tick.state == static_cast<std::uint16_t>(SupervisorState::kFault) ? now + 1 : 0;
      longest = std::max(longest, now);
    }
    return longest;
  };
  EXPECT_GT(longest_fault(wrapped), 1000U);
  const std::size_t resumed = longest_fault(mine_wire(wrapped, "resume", 1));
  EXPECT_GT(resumed, 10U);
  EXPECT_LE(resumed, 300U);
}

TEST(MinedWire, EverySettingThatMayChangeChanges) {
  std::set<TickSetting> changed;
  for (const DeviceInput& in : mine_wire(harmless(), "settings", 1).inputs) changed.insert(in.change.setting);
  EXPECT_EQ(changed.size(), kTickSettings + 1);  // and none
}

}  // namespace
}  // namespace isotouch::evaluate
