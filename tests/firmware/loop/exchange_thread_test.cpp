#include "firmware/loop/exchange_thread.h"

#include <gtest/gtest.h>

#include <time.h>  // NOLINT(modernize-deprecated-headers): clock_gettime

#include <algorithm>
#include <atomic>
#include <thread>
#include <utility>
#include <vector>

#include "firmware/loop/virtual_clock.h"

namespace isotouch::loop {
namespace {

constexpr std::int64_t kSilence = 20'000'000;

class Monotonic final : public Clock {
 public:
  std::int64_t now_ns() override {
    timespec now{};
    clock_gettime(CLOCK_MONOTONIC, &now);
    return std::int64_t{now.tv_sec} * 1'000'000'000 + now.tv_nsec;
  }
  void sleep_until_ns(std::int64_t when_ns) override {
    while (now_ns() < when_ns) std::this_thread::yield();
  }
};

/// Answers at once, so many times.
class QuickPort final : public Port {
 public:
  explicit QuickPort(int replies) : left_(replies) {}
  Answer exchange(const FalconCommand& command, FalconPacket& reply) override {
    if (left_-- == 0) return Answer::kEnd;
    commands.push_back(command);
    reply = encode(FalconReply{{static_cast<std::int16_t>(commands.size()), 0, 0}, 0, 0});
    return Answer::kReply;
  }
  void rest() override { ++rests; }
  std::vector<FalconCommand> commands;
  int rests = 0;

 private:
  int left_;
};

constexpr std::int64_t kLong = 60'000'000'000;  // a minute: longer than a busy machine pauses

TEST(ExchangeThread, EveryReplyMeetsItsTickAndEveryWordIsSentOnce) {
  QuickPort port(2000);
  Monotonic clock;
  ExchangeThread device(port, clock, kLong, kLong);
  const std::atomic<bool> stop{false};
  std::thread thread([&] { device.serve(stop); });
  std::int16_t tick = 0;
  while (device.wait(kNever) == Wake::kReply) {
    const Sample sample = device.newest();
    ++tick;
    ASSERT_EQ(sample.number, static_cast<std::uint64_t>(tick));
    ASSERT_EQ(decode_reply(sample.packet)->counts[0], tick);
    EXPECT_EQ(sample.word_delay_ns >= 0, tick > 1);
    EXPECT_GE(sample.arrival_ns, sample.sent_ns);
    device.leave({{{tick, 0, 0}, 0}, static_cast<std::uint64_t>(tick), sample.number, sample.arrival_ns});
  }
  thread.join();
  EXPECT_EQ(tick, 2000);
  ASSERT_EQ(port.commands.size(), 2000U);
  for (std::size_t i = 0; i < port.commands.size(); ++i) ASSERT_EQ(port.commands[i].words[0], static_cast<std::int16_t>(i));
  EXPECT_EQ(port.rests, 1);
}

TEST(ExchangeThread, ASilentTickDoesNotStopThePackets) {
  QuickPort port(50);
  Monotonic clock;
  ExchangeThread device(port, clock, 100'000, kLong);
  const std::atomic<bool> stop{false};
  device.leave({{{7, 7, 7}, 1}, 1, 0, -1});
  device.serve(stop);
  ASSERT_EQ(port.commands.size(), 50U);
  for (const FalconCommand& command : port.commands) EXPECT_EQ(command, (FalconCommand{{7, 7, 7}, 1}));
  EXPECT_EQ(device.newest().number, 50U);
}

TEST(ExchangeThread, WithoutATickForTooLongPacketsCarryNoForce) {
  QuickPort port(50);
  Monotonic clock;
  ExchangeThread device(port, clock, 100'000, 1'000'000);
  const std::atomic<bool> stop{false};
  device.leave({{{7, 7, 7}, 1}, 1, 0, -1});
  device.serve(stop);
  ASSERT_EQ(port.commands.size(), 50U);
  EXPECT_EQ(port.commands.front(), (FalconCommand{{7, 7, 7}, 1}));
  EXPECT_EQ(port.commands.back(), (FalconCommand{{}, 1}));
}

/// Passes by itself: every look takes 10 us.
class SteppingClock final : public Clock {
 public:
  std::int64_t now_ns() override { return now_ns_ += 10'000; }
  void sleep_until_ns(std::int64_t when_ns) override { now_ns_ = std::max(now_ns_, when_ns); }

 private:
  std::int64_t now_ns_ = 0;
};

/// Answers after 0.8 ms; remembers when a packet went out first that carries no force.
class SteppingPort final : public Port {
 public:
  explicit SteppingPort(SteppingClock& clock) : clock_(clock) {}
  Answer exchange(const FalconCommand& command, FalconPacket& reply) override {
    const std::int64_t now = clock_.now_ns();
    if (packets++ == 20) return Answer::kEnd;
    if (command.words == MotorCommands{} && rested_ns == 0) rested_ns = now;
    clock_.sleep_until_ns(now + 800'000);
    reply = encode(FalconReply{});
    return Answer::kReply;
  }
  void rest() override {}
  std::int64_t rested_ns = 0;
  int packets = 0;

 private:
  SteppingClock& clock_;
};

TEST(ExchangeThread, TheForceOfATickThatStopsEndsInTimeWhateverTheRefresh) {
  constexpr std::int64_t kMs = 1'000'000;
  for (const std::int64_t refresh : {kMs / 2, 5 * kMs / 2, 20 * kMs}) {
    SteppingClock clock;
    SteppingPort port(clock);
    ExchangeThread device(port, clock, refresh, 3 * kMs);
    const std::atomic<bool> stop{false};
    device.leave({{{7, 7, 7}, 1}, 1, 0, -1});
    device.serve(stop);
    EXPECT_GE(port.rested_ns, 3 * kMs) << refresh;
    EXPECT_LE(port.rested_ns, refresh < kMs ? 3 * kMs + kMs : 3 * kMs + kMs / 2) << refresh << ": a packet that is under way is waited for";
    EXPECT_GE(clock.now_ns(), 18 * std::max(kMs * 8 / 10, refresh)) << "then packets come no faster than before";
  }
}

/// Answers as a script says, each after some time. Before each answer the tick leaves a command made of the newest sample.
class ScriptedPort final : public Port {
 public:
  struct Step {
    Answer answer;
    std::int64_t takes_ns;
  };
  ScriptedPort(VirtualClock& clock, std::vector<Step> script) : clock_(clock), script_(std::move(script)) {}
  Answer exchange(const FalconCommand& /*command*/, FalconPacket& reply) override {
    if (at_ == script_.size()) return Answer::kEnd;
    const Sample sample = device->newest();
    if (sample.number > 0) device->leave({{}, ++tick_, sample.number, sample.arrival_ns});
    const Step step = script_[at_++];
    clock_.sleep_until_ns(clock_.now_ns() + step.takes_ns);
    reply = encode(FalconReply{});
    return step.answer;
  }
  void rest() override {}
  ExchangeThread* device = nullptr;

 private:
  VirtualClock& clock_;
  std::vector<Step> script_;
  std::size_t at_ = 0;
  std::uint64_t tick_ = 0;
};

/// Of the last reply of a script.
std::int64_t word_delay(std::vector<ScriptedPort::Step> script) {
  VirtualClock clock;
  ScriptedPort port(clock, std::move(script));
  ExchangeThread device(port, clock, 0, kSilence);
  port.device = &device;
  const std::atomic<bool> stop{false};
  device.serve(stop);
  return device.newest().word_delay_ns;
}

TEST(ExchangeThread, TheSilenceOfADeviceIsNoDelayOfItsCommands) {
  using enum Answer;
  constexpr std::int64_t kUs = 1000, kMs = 1'000'000;
  EXPECT_EQ(word_delay({{kReply, kMs}, {kSilent, 100 * kUs}, {kReply, kMs}}), 100 * kUs);
  EXPECT_EQ(word_delay({{kReply, kMs}, {kSilent, 100 * kUs}, {kSilent, 20 * kMs}, {kSilent, 20 * kMs}, {kSilent, 20 * kMs}, {kReply, kMs}}),
            100 * kUs);
  EXPECT_EQ(word_delay({{kReply, kMs}, {kSilent, 100 * kUs}, {kAbsent, 5000 * kMs}, {kReply, kMs}}), -1)
      << "a device that is gone gets no command";
}

TEST(ExchangeThread, TheTicksWaitEndsAtItsDueTime) {
  QuickPort port(0);
  Monotonic clock;
  ExchangeThread device(port, clock, 0, kSilence);
  const std::int64_t due = clock.now_ns() + 2'000'000;
  EXPECT_EQ(device.wait(due), Wake::kDue);
  EXPECT_GE(clock.now_ns(), due);
}

TEST(ExchangeThread, LeavesTheDeviceWithoutForceWhenToldToStop) {
  QuickPort port(1 << 30);
  Monotonic clock;
  ExchangeThread device(port, clock, 0, kSilence);
  std::atomic<bool> stop{true};
  device.serve(stop);
  EXPECT_EQ(port.rests, 1);
  EXPECT_EQ(device.wait(kNever), Wake::kEnd);
}

}  // namespace
}  // namespace isotouch::loop
