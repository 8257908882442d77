/// A recording of packets in the place of a device: the packets that came, and silence where none came. What it is commanded changes nothing.
#pragma once

#include <cstddef>
#include <utility>

#include "firmware/loop/clock.h"
#include "firmware/loop/device.h"
#include "shared/files/trace_file.h"

namespace isotouch::falcon {

class ReplayPort final : public loop::Port {
 public:
  /// clock     lives longer; every exchange takes a period of the recording on it
  ReplayPort(files::TraceFile trace, loop::Clock& clock) : trace_(std::move(trace)), clock_(clock), next_ns_(clock.now_ns()) {}

  loop::Answer exchange(const FalconCommand& /*command*/, FalconPacket& reply) override {
    if (at_ >= trace_.size()) return loop::Answer::kEnd;
    clock_.sleep_until_ns(next_ns_ += trace_.header().period_ns);
    const Input in = trace_.record(at_++).input;
    if (!in.fresh) return loop::Answer::kSilent;
    reply = in.packet;
    return loop::Answer::kReply;
  }

  void rest() override {}

 private:
  files::TraceFile trace_;
  loop::Clock& clock_;
  std::int64_t next_ns_;
  std::size_t at_ = 0;
};

}  // namespace isotouch::falcon
