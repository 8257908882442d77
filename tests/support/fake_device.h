/// A device that answers, loses, repeats and delays on order, in a time that only it and the loop move.
#pragma once

#include <cstdint>
#include <functional>

#include "firmware/loop/device.h"
#include "firmware/loop/virtual_clock.h"

namespace isotouch::test {

class FakeDevice final : public loop::Device {
 public:
  explicit FakeDevice(loop::VirtualClock& clock) : clock_(clock) { ask(); }

  std::int64_t latency_ns = 500'000;     ///< from a command to its reply
  std::int64_t grid_ns = 1'000'000;      ///< replies come at its multiples; 1 = at any time
  std::int64_t stall_ns = 0;             ///< by so much the next wait ends too late; once
  bool keeps_asking = false;             ///< the next command follows a reply at once, without the tick's commands
  int mute = 0;                          ///< so many commands stay without an answer
  std::uint64_t end_after = UINT64_MAX;  ///< replies
  std::function<FalconPacket(const loop::Command&)> answer = [](const loop::Command&) { return encode(FalconReply{}); };

  loop::Command last;  ///< what was left most recently
  std::uint64_t commands = 0;

  loop::Wake wait(std::int64_t until_ns) override {
    if (sample_.number >= end_after) return loop::Wake::kEnd;
    deliver(clock_.now_ns());
    if (!unseen_ && arrival_ <= until_ns) {
      clock_.sleep_until_ns(arrival_);
      deliver(arrival_);
    }
    if (!unseen_) clock_.sleep_until_ns(until_ns);
    clock_.sleep_until_ns(clock_.now_ns() + stall_ns);
    stall_ns = 0;
    return unseen_ ? loop::Wake::kReply : loop::Wake::kDue;
  }

  loop::Sample newest() override {
    deliver(clock_.now_ns());
    unseen_ = false;
    return sample_;
  }

  void leave(const loop::Command& command) override {
    last = command;
    ++commands;
    if (arrival_ == loop::kNever) ask();  // else the device is still busy with the one before
  }

 private:
  void ask() {
    if (mute > 0 && mute-- > 0) return;
    sent_ = clock_.now_ns();
    arrival_ = (sent_ + latency_ns + grid_ns - 1) / grid_ns * grid_ns;
  }

  void deliver(std::int64_t now) {
    while (arrival_ <= now) {
      sample_ = {answer(last), sample_.number + 1, sent_, arrival_, -1};
      unseen_ = true;
      sent_ = arrival_;
      arrival_ = keeps_asking ? (sent_ + latency_ns + grid_ns - 1) / grid_ns * grid_ns : loop::kNever;
    }
  }

  loop::VirtualClock& clock_;
  loop::Sample sample_;
  std::int64_t sent_ = 0, arrival_ = loop::kNever;
  bool unseen_ = false;
};

}  // namespace isotouch::test
