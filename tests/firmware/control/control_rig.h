/// A control server with everything behind it but the device: the tick is a thread that takes fields over, obeys commands and writes records.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "firmware/control/control_server.h"
#include "firmware/loop/linux_clock.h"
#include "tests/firmware/store/crashing_folder.h"
#include "tests/firmware/store/packed_field.h"
#include "tests/support/scratch_folder.h"

namespace isotouch::control {

/// What the loop does for the server, without a device.
class FakeTick {
 public:
  explicit FakeTick(loop::FieldSlots& slots) : ring(1024), slots_(slots), thread_([this] { run(); }) {}
  ~FakeTick() {
    stop_ = true;
    thread_.join();
  }

  loop::Requests commands;
  loop::TickStats stats;
  loop::Latest<loop::TickRecord> shown;
  loop::TraceRing ring;
  std::atomic<std::uint8_t> obeyed{0};  ///< all commands that ever came
  std::atomic<std::int16_t> count{0};   ///< of every arm, homed
  std::atomic<std::int16_t> sway{0};    ///< added to it in every other tick
  std::atomic<std::uint16_t> faults{0}, shown_faults{0};
  std::atomic<std::uint32_t> author{0};  ///< of the last request that had one
  std::atomic<std::int16_t> word{0};     ///< motor command of the next tick alone
  std::atomic<bool> rests{false};        ///< no ticks meanwhile

  /// Hash of the field of the last tick, as far as it was read there. A tick takes a field over before it reads it: one that runs is waited for.
  std::uint64_t felt() const {
    wait_for_tick();
    return felt_;
  }
  /// Its generation.
  std::uint32_t generation() const {
    wait_for_tick();
    return generation_;
  }

 private:
  void wait_for_tick() const {
    for (const std::uint64_t running = begun_; ended_ < running;) std::this_thread::yield();
  }

  void run() {
    for (std::uint64_t number = 1; !stop_; ++number) {
      while (rests && !stop_) std::this_thread::sleep_for(std::chrono::milliseconds(1));
      begun_ = number;
      const loop::ActiveField field = slots_.field();
      loop::TickRecord record;
      record.number = number;
      record.arrival_ns = static_cast<std::int64_t>(number) * 100'000;
      const auto at = static_cast<std::int16_t>(count + (number % 2 == 0 ? sway.load() : 0));
      record.in.packet = encode(FalconReply{{at, at, at}, 0, 7});
      record.in.fresh = true;
      const loop::Asked asked = commands.take();
      record.in.requests = asked.bits;
      if (field.patched_from != 0 && field.patched_from == generation_) record.in.requests |= kRequestMoved;
      record.faults = faults;
      record.in.field_generation = field.generation;
      record.out.state = static_cast<std::uint16_t>(field.view != nullptr ? SupervisorState::kActive : SupervisorState::kIdle);
      record.out.commands[0] = word.exchange(0);
      obeyed |= record.in.requests;
      if (asked.author != kNobody) author = asked.author;
      if (field.generation != generation_) felt_ = field.view->hash();
      generation_ = field.generation;
      ended_ = number;
      stats.ticks.add();
      stats.tick_time.add(static_cast<std::int64_t>(number % 1000));
      shown.put(record);
      shown_faults = record.faults;
      ring.push(record);
      std::this_thread::sleep_for(std::chrono::microseconds(100));
    }
  }

  loop::FieldSlots& slots_;
  std::atomic<std::uint64_t> begun_{0}, ended_{0};  ///< numbers of ticks
  std::atomic<std::uint32_t> generation_{0};
  std::atomic<std::uint64_t> felt_{0};
  std::atomic<bool> stop_{false};
  std::thread thread_;
};

/// The machine's, which a test may put forward.
class AdjustableClock : public loop::Clock {
 public:
  std::int64_t now_ns() override { return clock_.now_ns() + ahead_ns; }
  void sleep_until_ns(std::int64_t when_ns) override { clock_.sleep_until_ns(when_ns - ahead_ns); }

  std::atomic<std::int64_t> ahead_ns{0};

 private:
  loop::LinuxClock clock_;
};

struct ControlRig {
  explicit ControlRig(std::size_t image_limit = 1 << 20, const std::function<void(ControlSettings&)>& change = {})
      : slots(image_limit),
        store(folder, 4),
        intake(slots, &store, clock,
               [this](const FieldView&) {
                 ++checked;
                 check_is_busy.wait(true);
                 return Refusal();
               }),
        measured(folder),
        calibration(
            &measured, nullptr,
            [this](const std::string&) {
              ++looked_up;
              disk_is_busy.wait(true);
              return Calibration::Choice{libnifalcon_model()};
            },
            "A1", [](bool) {}),
        tick(slots) {
    settings.path = (scratch.path() / "control").string();
    settings.program = "a test";
    settings.recordings.device = libnifalcon_model();
    settings.recordings.period_ns = 1'000'000;
    if (change) change(settings);
    server = std::make_unique<ControlServer>(
        settings, ControlNeighbours{intake, tick.commands, tick.stats, tick.shown, clock, &tick.ring, &calibration,
                                    [this](std::string_view name, std::string_view value, std::uint32_t author, bool may_raise) {
                                      set_to = std::string(name) + "=" + std::string(value);
                                      set_by = author, set_may_raise = may_raise;
                                      return value == "no" ? Refusal("that cannot be") : Refusal();
                                    },
                                    [] { return std::string("feel.friction = 0.5\n"); },
                                    [this](const std::string& line) { logged.push_back(line); }});
    EXPECT_EQ(server->start().sentence(), "");
  }
  ~ControlRig() { let_check_end(); }
  ControlRig(const ControlRig&) = delete;
  ControlRig& operator=(const ControlRig&) = delete;

  void let_check_end() {
    check_is_busy = false;
    check_is_busy.notify_all();
  }

  ScratchFolder scratch;
  AdjustableClock clock;
  store::CrashingFolder folder;
  loop::FieldSlots slots;
  store::FieldStore store;
  std::atomic<bool> check_is_busy{false};  ///< whoever loads a field waits
  std::atomic<int> checked{0};             ///< fields that were to be loaded
  store::FieldIntake intake;
  store::CalibrationStore measured;
  std::atomic<bool> disk_is_busy{false};  ///< whoever keeps a calibration waits
  std::atomic<int> looked_up{0};          ///< angles by the settings
  Calibration calibration;
  FakeTick tick;
  ControlSettings settings;
  std::vector<std::string> logged;  ///< by the server's thread, before its answers
  std::uint32_t set_by = kNobody;
  bool set_may_raise = false;
  std::string set_to;  ///< the last setting that was asked for, written before its answer
  std::unique_ptr<ControlServer> server;
};

/// Patience with a client that does not read, on a machine so busy that ticks take their time, too.
inline constexpr std::int64_t kLong = 600'000'000'000;

struct Heard {
  protocol::Kind kind{};
  std::vector<std::uint8_t> body;

  /// The sentence of a refusal; empty for anything else.
  std::string refusal() const {
    if (kind != protocol::Kind::kRefused) return {};
    const auto said = protocol::decode<protocol::Refusal>(body);
    return said ? std::string(said->sentence.begin(), said->sentence.end()) : "a refusal that cannot be read";
  }
};

/// A connection that says what it is told to, byte by byte if need be.
class Speaker {
 public:
  explicit Speaker(const std::string& path) : socket_(connect_to_socket(path)) { EXPECT_GE(socket_, 0); }
  ~Speaker() { hang_up(); }
  Speaker(const Speaker&) = delete;
  Speaker& operator=(const Speaker&) = delete;

  void hang_up() {
    if (socket_ >= 0) ::close(socket_);
    socket_ = -1;
  }
  /// returns   false: the other side has closed
  bool send(std::span<const std::uint8_t> bytes) {
    while (!bytes.empty()) {
      const ssize_t taken = ::send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
      if (taken <= 0) return false;
      bytes = bytes.subspan(static_cast<std::size_t>(taken));
    }
    return true;
  }
  template <class Message>
  bool say(protocol::Kind kind, const Message& message) {
    std::vector<std::uint8_t> frame(protocol::kMaxFrame);
    frame.resize(protocol::encode(kind, message, frame));
    return send(frame);
  }
  bool say(protocol::Kind kind) {
    std::vector<std::uint8_t> frame(protocol::kHeaderBytes);
    protocol::seal_frame(kind, 0, frame);
    return send(frame);
  }
  /// The next frame; kind 0 when the other side has closed, or says nothing for a minute.
  Heard hear() {
    for (;;) {
      const auto frame = protocol::read_frame(bytes_);
      if (!frame) return {};
      if (frame->size > 0) {
        Heard heard{frame->kind, {frame->body.begin(), frame->body.end()}};
        bytes_.erase(bytes_.begin(), bytes_.begin() + static_cast<std::ptrdiff_t>(frame->size));
        return heard;
      }
      pollfd one{socket_, POLLIN, 0};
      std::vector<std::uint8_t> more(1 << 16);
      const ssize_t got = ::poll(&one, 1, 60'000) > 0 ? ::recv(socket_, more.data(), more.size(), 0) : 0;
      if (got <= 0) return {};
      bytes_.insert(bytes_.end(), more.begin(), more.begin() + got);
    }
  }
  Heard greet(std::uint16_t major = protocol::kMajor) {
    say(protocol::Kind::kHello, protocol::Hello{major, protocol::kMinor});
    return hear();
  }
  int socket() const { return socket_; }

 private:
  int socket_;
  std::vector<std::uint8_t> bytes_;
};

/// The frames of one upload, in order.
inline std::vector<std::vector<std::uint8_t>> frames_of(const store::PackedField& field, std::size_t chunk) {
  std::vector<std::vector<std::uint8_t>> frames;
  const auto add = [&](auto write) {
    std::vector<std::uint8_t> frame(protocol::kMaxFrame);
    frame.resize(write(std::span(frame)));
    frames.push_back(frame);
  };
  add([](auto out) { return protocol::encode(protocol::Kind::kHello, protocol::Hello{}, out); });
  add([&](auto out) { return protocol::encode(protocol::Kind::kBegin, field.promise, out); });
  for (std::size_t at = 0; at < field.bytes.size(); at += chunk) {
    const protocol::Chunk piece{at, std::span(field.bytes).subspan(at, std::min(chunk, field.bytes.size() - at))};
    add([&](auto out) { return protocol::encode(protocol::Kind::kChunk, piece, out); });
  }
  add([](auto out) { return protocol::seal_frame(protocol::Kind::kCommit, 0, out); });
  return frames;
}

/// Says one thing and returns the answer.
template <class... Message>
Heard ask(Speaker& speaker, protocol::Kind kind, const Message&... message) {
  speaker.say(kind, message...);
  return speaker.hear();
}

/// Sends a field and returns the last answer.
inline Heard upload(Speaker& speaker, const store::PackedField& field, std::size_t chunk = 4096) {
  Heard heard;
  const auto frames = frames_of(field, chunk);
  for (const auto& frame : frames) {
    speaker.send(frame);
    heard = speaker.hear();
    if (heard.kind == protocol::Kind::kRefused) break;
  }
  return heard;
}

inline void expect_sentence(const Heard& heard, const std::string& about) {
  EXPECT_THAT(heard.refusal(), testing::HasSubstr(about));
  EXPECT_THAT(heard.refusal(), testing::HasSubstr("; ")) << "it says what to do";
}

}  // namespace isotouch::control
