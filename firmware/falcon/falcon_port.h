/// A Falcon over any link as the loop's port: found, booted, run, and found again after an unplug.
#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
#include <string_view>

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
  std::uint64_t found = 0;        ///< devices so far, the one in use among them; the same one counts anew after an unplug
  std::array<char, 24> serial{};  ///< of the device in use, ends with 0
};

class FalconPort final : public loop::Port {
 public:
  /// session   lives longer
  /// link      the session's
  FalconPort(FalconSession& session, const FalconLink& link) : session_(session), link_(link) {}

  loop::Answer exchange(const FalconCommand& command, FalconPacket& reply) override {
    const SessionState before = session_.state();
    const bool known = is_known();
    const Exchange exchange = session_.step(known ? command : FalconCommand{{}, command.flags});
    if (before == SessionState::kBooting) ++report_.boots;
    if (before == SessionState::kSearching && session_.state() != before) ++report_.found;
    if (session_.state() != before || before == SessionState::kSearching) tell();
    if (before != SessionState::kRunning) return loop::Answer::kAbsent;
    if (!known) return loop::Answer::kSilent;
    if (exchange.fresh) reply = exchange.packet;
    return exchange.fresh ? loop::Answer::kReply : loop::Answer::kSilent;
  }

  void rest() override { session_.stop(); }

  /// From now on a device counts, with its packets and its motors, only if it is the one of this serial, or once it is trusted. Before the first exchange.
  void expect(std::string_view serial) {
    asks_ = true;
    expected_ = serial_array(serial);
    expects_ = expected_[0] != 0;
  }
  /// found     of the report of the device that counts. Any thread
  void trust(std::uint64_t found) { trusted_ = found; }
  /// From now on no device counts before it is trusted, not even the expected one. Any thread
  ///
  /// in_use    nor the one in use
  void distrust(bool in_use = true) {
    expects_ = false;
    if (in_use) trusted_ = 0;
  }

  /// Changes of the session's state; for one reader on another thread.
  loop::Latest<PortReport>& shown() { return shown_; }

 private:
  void tell() {
    report_.state = session_.state();
    report_.troubled = session_.trouble().has_value();
    if (report_.troubled) report_.trouble = *session_.trouble();
    report_.boot = session_.last_boot();
    report_.serial = serial_array(link_.identity().serial);
    shown_.put(report_);
  }

  bool is_known() const { return !asks_ || (expects_ && report_.serial == expected_) || trusted_ == report_.found; }

  static std::array<char, 24> serial_array(std::string_view serial) {
    std::array<char, 24> text{};
    std::copy_n(serial.begin(), std::min(serial.size(), text.size() - 1), text.begin());
    return text;
  }

  FalconSession& session_;
  const FalconLink& link_;
  PortReport report_;
  bool asks_ = false;
  std::array<char, 24> expected_{};
  std::atomic<bool> expects_{false};
  std::atomic<std::uint64_t> trusted_{0};  ///< 0: none
  loop::Latest<PortReport> shown_;
};

}  // namespace isotouch::falcon
