/// A Falcon over any link as the loop's port: found, booted, run, and found again after an unplug.
#pragma once

#include "firmware/io/falcon_session.h"
#include "firmware/loop/device.h"

namespace isotouch::io {

class FalconPort final : public loop::Port {
 public:
  /// session   lives longer; what it knows of state and trouble is read on the same thread only
  explicit FalconPort(FalconSession& session) : session_(session) {}

  loop::Answer exchange(const FalconCommand& command, FalconPacket& reply) override {
    const bool running = session_.state() == SessionState::kRunning;
    const Exchange exchange = session_.step(command);
    if (!running) return loop::Answer::kAbsent;
    if (exchange.fresh) reply = exchange.packet;
    return exchange.fresh ? loop::Answer::kReply : loop::Answer::kSilent;
  }

  void rest() override { session_.stop(); }

 private:
  FalconSession& session_;
};

}  // namespace isotouch::io
