/// A link to a scripted Falcon with a clock of its own: it logs every request byte for byte and misbehaves on order.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <deque>
#include <span>
#include <string>
#include <vector>

#include "firmware/falcon/falcon_link.h"
#include "firmware/falcon/falcon_session.h"
#include "firmware/falcon/firmware_image.h"
#include "firmware/loop/clock.h"
#include "shared/falcon_packet.h"

namespace isotouch::test {

using Bytes = std::vector<std::uint8_t>;

inline std::string hex(std::span<const std::uint8_t> bytes) {
  std::string text;
  for (const std::uint8_t byte : bytes) {
    char pair[4];
    std::snprintf(pair, sizeof pair, "%02x", byte);
    if (!text.empty()) text += ' ';
    text += pair;
  }
  return text;
}

class FakeClock final : public loop::Clock {
 public:
  std::int64_t now_ns() override { return now; }
  void sleep_until_ns(std::int64_t when_ns) override { now = std::max(now, when_ns); }
  std::int64_t now = 1'000'000'000;
};

inline const std::array<std::uint8_t, 34> kImage = falcon::synthetic_image();

/// What a real board was seen to do, or may do, beyond the plain order of things.
struct Faults {
  bool present = true;          ///< false: unplugged
  bool wall_power = true;       ///< false: the USB chip lives, nobody behind it does
  int mute_handshakes = 0;      ///< so many questions stay without an answer
  int mute_attempts = 0;        ///< so many attempts (rises of DTR) stay without any answer
  int wrong_echoes = 0;         ///< so many pieces come back with a changed byte
  int lost_autobauds = 0;       ///< so many times A is not answered
  Bytes before_answer;          ///< stray bytes in front of the handshake's answer
  Bytes before_autobaud;        ///< in front of the A that comes back
  Bytes before_first_echo;      ///< in front of the first piece's echo
  Bytes after_handshake;        ///< late bytes that come some milliseconds after the answer
  bool byte_by_byte = false;    ///< every answer comes in packets of one byte
  bool empty_packets = true;    ///< the latency timer's packets without data
  bool echoes_packets = false;  ///< before its firmware is loaded, its boot loader repeats run-time packets
  bool mute_firmware = false;   ///< loaded, but it never answers
  int mute_replies = 0;         ///< so many packets stay without a reply
  int late_replies = 0;         ///< so many replies come after 7 ms
  int stall_controls = 0;       ///< so many control requests are refused
  bool short_writes = false;    ///< takes at most five bytes at a time
};

class FakeFalcon final : public falcon::FalconLink {
 public:
  explicit FakeFalcon(FakeClock& clock) : clock_(clock) {}

  Faults faults;
  std::vector<std::string> log;         ///< "open", "close", "40 00 01 …" for control, "> 0a 43 0d" for bytes out
  std::vector<FalconCommand> commands;  ///< what running firmware was sent
  FalconReply reply;                    ///< what it answers
  bool running = false;
  Bytes uploaded;

  falcon::LinkResult<void> open() override {
    log.emplace_back("open");
    if (!faults.present) return falcon::LinkError::kNotFound;
    open_ = true;
    return {};
  }
  void close() override {
    log.emplace_back("close");
    open_ = false;
  }
  bool is_open() const override { return open_; }
  const falcon::FalconIdentity& identity() const override { return identity_; }

  falcon::LinkResult<std::size_t> control(const falcon::UsbSetup& setup, std::span<std::uint8_t> /*answer*/) override {
    log.push_back(hex(setup));
    if (!open_ || !faults.present) return falcon::LinkError::kGone;
    if (faults.stall_controls > 0) return --faults.stall_controls, falcon::LinkError::kStalled;
    switch (setup[1]) {
      case 0: incoming_.clear(); break;
      case 1: set_lines(setup); break;
      case 3: baud_ = setup[2] | setup[3] << 8; break;
      case 9: latency_ms_ = setup[2]; break;
      default: break;
    }
    return std::size_t{0};
  }

  falcon::LinkResult<std::size_t> write(std::span<const std::uint8_t> data, std::uint32_t /*timeout_ms*/) override {
    if (!open_ || !faults.present) return falcon::LinkError::kGone;
    if (faults.short_writes) data = data.first(std::min<std::size_t>(data.size(), 5));
    log.push_back("> " + hex(data));
    if (faults.wall_power) hear(data);
    return data.size();
  }

  falcon::LinkResult<std::size_t> read(std::span<std::uint8_t> buffer, std::uint32_t timeout_ms) override {
    if (!open_ || !faults.present) return falcon::LinkError::kGone;
    const std::int64_t until = clock_.now + std::int64_t{timeout_ms} * kMs;
    const std::int64_t tick = clock_.now + std::int64_t{latency_ms_} * kMs;
    const std::int64_t due = incoming_.empty() ? until + 1 : std::max(incoming_.front().due_ns, clock_.now);
    if (faults.empty_packets && tick <= until && tick < due) {
      clock_.now = tick;
      return give({0x01, 0x60}, buffer);
    }
    if (due > until) {
      clock_.now = until;
      return falcon::LinkError::kTimedOut;
    }
    clock_.now = due;
    const Bytes packet = incoming_.front().bytes;
    incoming_.pop_front();
    return give(packet, buffer);
  }

  /// Puts data on the wire to the host, in packets of at most 62 bytes behind their status pairs.
  void send(const Bytes& data, std::int64_t after_ms = 1) {
    const std::size_t piece = faults.byte_by_byte ? 1 : 62;
    for (std::size_t at = 0; at < data.size(); at += piece) {
      Bytes packet = {0x01, 0x60};
      packet.insert(packet.end(), data.begin() + static_cast<std::ptrdiff_t>(at),
                    data.begin() + static_cast<std::ptrdiff_t>(std::min(at + piece, data.size())));
      incoming_.push_back({clock_.now + after_ms * kMs, packet});
    }
  }

 private:
  static constexpr std::int64_t kMs = 1'000'000;
  struct Incoming {
    std::int64_t due_ns;
    Bytes bytes;
  };

  static std::size_t give(const Bytes& packet, std::span<std::uint8_t> buffer) {
    std::copy(packet.begin(), packet.end(), buffer.begin());
    return packet.size();
  }

  void set_lines(const falcon::UsbSetup& setup) {
    if ((setup[3] & 1) == 0) return;
    const bool up = (setup[2] & 1) != 0;
    if (up && !dtr_) {
      running = locked_ = false;
      uploaded.clear();
      mute_ = faults.mute_attempts > 0;
      faults.mute_attempts -= mute_ ? 1 : 0;
    }
    dtr_ = up;
  }

  void hear(std::span<const std::uint8_t> data) {
    if (running && baud_ == 0x0002) {
      packet_.insert(packet_.end(), data.begin(), data.end());
      while (packet_.size() >= kFalconPacketBytes) {
        answer_packet();
        packet_.erase(packet_.begin(), packet_.begin() + kFalconPacketBytes);
      }
    } else if (faults.echoes_packets && baud_ == 0x0002) {
      send(Bytes(data.begin(), data.end()));
    } else if (dtr_ && baud_ == 0x4138) {
      question_.insert(question_.end(), data.begin(), data.end());
      if (question_.size() < 3) return;
      if (question_ == Bytes{0x0A, 0x43, 0x0D}) answer_question();
      question_.clear();
    } else if (!dtr_ && baud_ == 0x0015 && !mute_) {
      load(data);
    }
  }

  void answer_question() {
    if (mute_ || faults.mute_handshakes-- > 0) return;
    Bytes answer = faults.before_answer;
    answer.insert(answer.end(), {0x0A, 0x44, 0x2C, 0x0D});
    send(answer, 5);
    if (!faults.after_handshake.empty()) send(faults.after_handshake, 12);
  }

  void load(std::span<const std::uint8_t> data) {
    Bytes echo;
    if (!locked_) {
      if (faults.lost_autobauds-- > 0) return;
      locked_ = true;
      echo = faults.before_autobaud;
    } else {
      if (uploaded.empty()) echo = faults.before_first_echo;
      uploaded.insert(uploaded.end(), data.begin(), data.end());
      const std::size_t size = uploaded.size();
      running = size > 22 && uploaded[size - 1] == 0 && uploaded[size - 2] == 0 && !faults.mute_firmware;
    }
    echo.insert(echo.end(), data.begin(), data.end());
    if (!uploaded.empty() && faults.wrong_echoes-- > 0) echo.back() ^= 0x10;
    send(echo, 5);
  }

  void answer_packet() {
    const Result<FalconCommand> command = decode_command(std::span(packet_).first<kFalconPacketBytes>());
    if (!command) return;
    commands.push_back(*command);
    if (faults.mute_replies > 0) {
      --faults.mute_replies;
      return;
    }
    const FalconPacket bytes = encode(reply);
    const bool late = faults.late_replies-- > 0;
    send(Bytes(bytes.begin(), bytes.end()), late ? 7 : 1);
  }

  FakeClock& clock_;
  falcon::FalconIdentity identity_{0x0403, 0xCB48, 0x0600, "isotouch", "FALCON HAPTIC", "FAKE0001"};
  std::deque<Incoming> incoming_;
  Bytes question_, packet_;
  bool open_ = false, dtr_ = false, locked_ = false, mute_ = false;
  int baud_ = 0, latency_ms_ = 16;
};

/// A session with a scripted Falcon.
struct SessionDesk {
  FakeClock clock;
  FakeFalcon falcon{clock};
  falcon::FalconSession session{falcon, clock, kImage};
};

}  // namespace isotouch::test
