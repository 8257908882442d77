/// A Falcon over any link as the loop's port: found, booted, run, and found again after an unplug.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "firmware/falcon/falcon_session.h"
#include "firmware/loop/device.h"
#include "firmware/loop/latest.h"

namespace isotouch::falcon {

/// What the port's thread tells others of its device.
struct PortReport {
  SessionState state = SessionState::kSearching;
  bool troubled = false;
  LinkError trouble{};            ///< when `troubled`: why the last search found nothing, or how the device was lost
  std::uint64_t boots = 0;        ///< ended so far
  BootReport boot;                ///< the last one's end, when there was one
  std::array<char, 24> serial{};  ///< of the device in use, ends with 0
};

class FalconPort final : public loop::Port {
 public:
  /// session   lives longer
  /// link      the session's
  FalconPort(FalconSession& session, const FalconLink& link) : session_(session), link_(link) {}

  loop::Answer exchange(const FalconCommand& command, FalconPacket& reply) override {
    const SessionState before = session_.state();
    const Exchange exchange = session_.step(command);
    if (before == SessionState::kBooting) ++report_.boots;
    if (session_.state() != before || before == SessionState::kSearching) tell();
    if (before != SessionState::kRunning) return loop::Answer::kAbsent;
    if (exchange.fresh) reply = exchange.packet;
    return exchange.fresh ? loop::Answer::kReply : loop::Answer::kSilent;
  }

  void rest() override { session_.stop(); }

  /// Changes of the session's state; for one reader on another thread.
  loop::Latest<PortReport>& shown() { return shown_; }

 private:
  void tell() {
    report_.state = session_.state();
    report_.troubled = session_.trouble().has_value();
    if (report_.troubled) report_.trouble = *session_.trouble();
    report_.boot = session_.last_boot();
    const auto& serial = link_.identity().serial;
    report_.serial = {};
    std::copy_n(serial.begin(), std::min(serial.size(), report_.serial.size() - 1), report_.serial.begin());
    shown_.put(report_);
  }

  FalconSession& session_;
  const FalconLink& link_;
  PortReport report_;
  loop::Latest<PortReport> shown_;
};

}  // namespace isotouch::falcon
