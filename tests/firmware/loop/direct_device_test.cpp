#include "firmware/loop/direct_device.h"

#include <gtest/gtest.h>

#include <atomic>
#include <vector>

#include "firmware/loop/loop.h"

namespace isotouch::loop {
namespace {

/// Answers by a script; counts of a reply tell what it was asked.
class ScriptPort final : public Port {
 public:
  explicit ScriptPort(std::vector<Answer> script) : script_(std::move(script)) {}
  Answer exchange(const FalconCommand& command, FalconPacket& reply) override {
    if (at_ >= script_.size()) return Answer::kEnd;
    const Answer answer = script_[at_++];
    commands.push_back(command);
    if (answer == Answer::kReply) reply = encode(FalconReply{{static_cast<std::int16_t>(at_), 0, 0}, command.flags, 7});
    return answer;
  }
  void rest() override {}
  std::vector<FalconCommand> commands;

 private:
  std::vector<Answer> script_;
  std::size_t at_ = 0;
};

std::vector<TickRecord> run(std::vector<Answer> script) {
  std::vector<TickRecord> records;
  ScriptPort port(std::move(script));
  VirtualClock clock;
  const std::atomic<bool> stop{false};
  DirectDevice device(port, clock, 1'000'000, stop);
  FieldSlots fields(64);
  Requests requests;
  TraceRing trace(1 << 12);
  Latest<TickRecord> shown;
  TickStats stats;
  Loop loop({.lockstep = true}, device, clock, {fields, requests, trace, shown, stats});
  loop.run(stop);
  for (TickRecord record; trace.pop(record);) records.push_back(record);
  EXPECT_EQ(stats.late.value(), 0U);
  return records;
}

TEST(DirectDevice, TheSilenceOfADeviceIsNoDelayOfItsCommands) {
  std::vector<Answer> script(200, Answer::kSilent);
  script.front() = script.back() = Answer::kReply;
  ScriptPort port(script);
  VirtualClock clock;
  const std::atomic<bool> stop{false};
  DirectDevice device(port, clock, 1'000'000, stop);
  for (std::uint64_t tick = 1; device.wait(kNever) != Wake::kEnd; ++tick) {
    const Sample sample = device.newest();
    device.leave({{}, tick, sample.number, sample.number == 0 ? -1 : sample.arrival_ns});
  }
  EXPECT_EQ(device.newest().number, 2U);
  EXPECT_EQ(device.newest().word_delay_ns, 0);
}

TEST(DirectDevice, OneExchangeIsOneTickAndOnePeriod) {
  const auto records = run(std::vector<Answer>(100, Answer::kReply));
  ASSERT_EQ(records.size(), 100U);
  for (std::size_t i = 0; i < records.size(); ++i) {
    EXPECT_EQ(records[i].start_ns, std::int64_t(i + 1) * 1'000'000);
    EXPECT_TRUE(records[i].in.fresh);
    EXPECT_EQ(decode_reply(records[i].in.packet)->counts[0], std::int16_t(i + 1));
    EXPECT_EQ(decode_reply(records[i].in.packet)->buttons, i == 0 ? 0 : records[i - 1].out.packet_flags) << "the words of the tick before";
  }
}

TEST(DirectDevice, ASilentExchangeIsATickWithAStaleSample) {
  const auto records = run({Answer::kReply, Answer::kSilent, Answer::kSilent, Answer::kReply});
  ASSERT_EQ(records.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(records[i].in.age, i % 3);
}

TEST(DirectDevice, NoTickPassesWhileThereIsNoDevice) {
  const auto records = run({Answer::kAbsent, Answer::kAbsent, Answer::kReply, Answer::kAbsent, Answer::kReply});
  ASSERT_EQ(records.size(), 2U);
  EXPECT_EQ(records[1].start_ns, 2'000'000);
}

TEST(DirectDevice, ASearchEndsWhenToldTo) {
  ScriptPort port(std::vector<Answer>(10, Answer::kAbsent));
  VirtualClock clock;
  const std::atomic<bool> stop{true};
  DirectDevice device(port, clock, 1'000'000, stop);
  EXPECT_EQ(device.wait(kNever), Wake::kEnd);
  EXPECT_TRUE(port.commands.empty());
}

}  // namespace
}  // namespace isotouch::loop
