#include "host/motion/mutate_packets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <set>

#include "firmware/core/tick.h"
#include "host/error.h"
#include "host/motion/device_in_hand.h"
#include "host/motion/motion.h"
#include "host/trace/replay.h"
#include "tests/support/field_image.h"

namespace isotouch::motion {
namespace {

const FieldView& ball() {
  static const test::FieldImage image({64, 64, 64}, [](const test::Point& p) {
    return std::sqrt((p[0] - 32) * (p[0] - 32) + (p[1] - 32) * (p[1] - 32) + (p[2] - 32) * (p[2] - 32)) - 20;
  });
  return image.view();
}

Recording harmless() {
  Recording recording;
  recording.header.device = libnifalcon_model();
  DeviceInHand device(recording.header.device);
  make_motion(&ball(), {.kind = "slide", .ticks = 16'000}, [&](const Input& input) { recording.inputs.push_back(device(input)); });
  return recording;
}

std::vector<TraceRecord> answers(const Recording& recording) {
  trace::Run run(ball(), recording.header);
  std::vector<TraceRecord> records;
  for (const Input& input : recording.inputs) records.push_back(run.step(input));
  return records;
}

TEST(MutatePackets, IsTheSameForASeedAndAnotherForAnother) {
  const Recording recording = harmless();
  for (const Mutation& mutation : mutations()) {
    if (mutation.of != InputKind::kPacket) continue;
    const std::string kind(mutation.name);
    const Recording first = mutate_packets(recording, kind, 7);
    EXPECT_EQ(first.inputs, mutate_packets(recording, kind, 7).inputs) << kind;
    EXPECT_NE(first.inputs, recording.inputs) << kind;
    EXPECT_NE(first.inputs, mutate_packets(recording, kind, 8).inputs) << kind;
    ASSERT_EQ(first.inputs.size(), recording.inputs.size());
    for (const Input& in : first.inputs) {
      const TraceRecordBytes bytes = encode(TraceRecord{in, {}, 0, 0});
      ASSERT_TRUE(decode_record(bytes)) << kind;  // a trace may hold it
    }
  }
  EXPECT_THROW(mutate_packets(recording, "wave", 1), InputError);
}

TEST(MutatePackets, WrappedCountsStandForTheSamePlaceUntilTheyWrapWhichIsAFault) {
  const Recording recording = harmless();
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    const Recording mutated = mutate_packets(recording, "wrap", seed);
    const auto plain = answers(recording), turned = answers(mutated);
    std::size_t first_wrap = 0;
    for (std::size_t tick = 1; first_wrap == 0 && tick < turned.size(); ++tick) {
      const auto before = decode_reply(mutated.inputs[tick - 1].packet), now = decode_reply(mutated.inputs[tick].packet);
      for (std::size_t i = 0; i < 3; ++i) {
        if (std::abs(now->counts[i] - before->counts[i]) > 30'000) first_wrap = tick;
      }
    }
    ASSERT_GT(first_wrap, 10U);
    for (std::size_t tick = 0; tick < first_wrap; ++tick) {  // at_zero is rounded to 2^-32 of a turn
      const Vec3<Mm> off = turned[tick].output.hip - plain[tick].output.hip;
      ASSERT_LT(std::abs(off.x.raw()) + std::abs(off.y.raw()) + std::abs(off.z.raw()), 300) << tick;
    }
    EXPECT_NE(turned[first_wrap].output.status & kCountJump, 0U);
    for (std::size_t tick = first_wrap; tick < first_wrap + 2; ++tick) {
      EXPECT_EQ(turned[tick].output.commands, (std::array<std::int16_t, 3>{}));
    }
  }
}

TEST(MutatePackets, EveryFaultThatPacketsCanShowIsInTheFaults) {
  const auto records = answers(mutate_packets(harmless(), "faults", 1));
  std::uint32_t status = 0;
  std::uint16_t faults = 0;
  std::set<std::uint16_t> states;
  std::size_t active = 0, restarts = 0, without_field = 0;
  for (const TraceRecord& record : records) {
    status |= record.output.status;
    faults |= record.output.faults;
    states.insert(record.output.state);
    active += record.output.state == static_cast<std::uint16_t>(SupervisorState::kActive) ? 1U : 0U;
    restarts += (record.input.requests & kRequestRestart) != 0 ? 1U : 0U;
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

TEST(MutatePackets, AGripThatIsLetGoHasNoForces) {
  std::size_t held = 0, released = 0;
  for (const TraceRecord& record : answers(mutate_packets(harmless(), "grip", 1))) {
    const bool active = record.output.state == static_cast<std::uint16_t>(SupervisorState::kActive);
    (record.output.buttons != 0 ? held : released) += 1;
    EXPECT_FALSE(active && record.output.buttons == 0);
  }
  EXPECT_GT(held, 5000U);
  EXPECT_GT(released, 1000U);
}

TEST(MutatePackets, APersonWhoResumesEndsEveryFaultAgain) {
  const Recording wrapped = mutate_packets(harmless(), "wrap", 1);
  const auto longest_fault = [](const Recording& recording) {
    std::size_t longest = 0, now = 0;
    for (const TraceRecord& record : answers(recording)) {
      now = record.output.state == static_cast<std::uint16_t>(SupervisorState::kFault) ? now + 1 : 0;
      longest = std::max(longest, now);
    }
    return longest;
  };
  EXPECT_GT(longest_fault(wrapped), 1000U);
  const std::size_t resumed = longest_fault(mutate_packets(wrapped, "resume", 1));
  EXPECT_GT(resumed, 10U);
  EXPECT_LE(resumed, 300U);
}

TEST(MutatePackets, EverySettingThatMayChangeChanges) {
  std::set<TickSetting> changed;
  for (const Input& in : mutate_packets(harmless(), "settings", 1).inputs) changed.insert(in.change.setting);
  EXPECT_EQ(changed.size(), kLiveSettings + 1);  // and none
}

}  // namespace
}  // namespace isotouch::motion
