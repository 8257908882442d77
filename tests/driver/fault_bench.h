/// The whole controller around the simulated Falcon in a time of its own: driver, loop, tick, watch and lines, with the exchange thread's behaviour
/// but without threads. A run is the same every time. Faults come by the model's script, and by what is pulled at here.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "firmware/falcon/falcon_port.h"
#include "firmware/falcon/firmware_image.h"
#include "firmware/guard/device_guard.h"
#include "firmware/loop/loop.h"
#include "firmware/loop/memory_check.h"
#include "firmware/loop/watchdog.h"
#include "tests/driver/model_link.h"
#include "tests/support/fake_lines.h"

namespace isotouch::test {

/// A clock that can be set back, too.
class JumpingClock final : public loop::Clock {
 public:
  std::int64_t now_ns() override { return now; }
  void sleep_until_ns(std::int64_t when_ns) override {
    if (when_ns <= now) return;
    passed += when_ns - now;
    now = when_ns;
  }
  std::int64_t now = 1'000'000'000'000;
  std::int64_t passed = 0;  ///< whatever it was set to
};

/// A ball of this radius in the middle of the workspace, up to 35 mm, 0.8 N/mm.
std::vector<std::uint8_t> ball_image(double radius_mm);

/// A hand that presses 3 mm into a ball of 25 mm from the front, with a tremor.
falcon_model::Path pressing_hand();

class FaultBench final : public loop::Device {
 public:
  static constexpr std::int64_t kPeriod = 1'000'000;

  struct Options {
    falcon_model::Path path = pressing_hand();
    std::string faults;  ///< a script, see hil/falcon_model/faults.h
    DeviceModel device = libnifalcon_model();
    TickSettings tick = {};
  };
  explicit FaultBench(const Options& options);

  /// One tick with all that belongs to it; what it saw and said.
  const loop::TickRecord& tick();
  /// returns   loaded, by the next generation; false: the tick has not taken over the one before
  bool load(const std::vector<std::uint8_t>& image);
  /// Ticks until the hand has pressed for a while; false: it never did.
  bool begin();

  SupervisorState state() const { return static_cast<SupervisorState>(last.out.state); }
  bool has_words() const { return !is_zero(last.out.commands); }
  /// What stands at the device's seam.
  const FalconCommand& last_left() const { return command_.falcon; }
  falcon_model::SimulatedFalcon& falcon() { return link.falcon; }
  /// The newest reply, as it arrived.
  const loop::Sample& arrived() const { return arrived_; }

  // What a test pulls at, for the next tick.
  std::int64_t late_ns = 0;                    ///< it begins so much too late
  std::int64_t set_back_ns = 0;                ///< before it the clock is set back by so much
  std::function<void(loop::Command&)> tamper;  ///< with what the tick says, as if the core were broken
  std::function<void(loop::Sample&)> garble;   ///< with a reply before the tick reads it
  loop::CommandGuard* judge = &guard;          ///< who stands between tick and device
  FalconCommand sent;                          ///< what the device was told last
  std::uint64_t packets_with_force = 0;        ///< that it was told

  JumpingClock clock;
  ModelClock link_clock;
  ModelLink link;
  std::array<std::uint8_t, 34> firmware = falcon::synthetic_image();
  falcon::FalconSession session;
  falcon::FalconPort port;
  loop::FieldSlots fields{1 << 22};
  loop::Requests commands;
  loop::TraceRing trace{1 << 12};
  loop::Latest<loop::TickRecord> shown;
  loop::TickStats stats;
  FakeLines lines{clock};
  loop::LineState line_state;
  loop::Watchdog watch;
  loop::LoopSettings settings;
  guard::DeviceGuard guard;
  loop::Loop loop;
  loop::MemoryCheck memory_check;
  loop::TickRecord last;
  std::uint64_t allocations_of_driver = 0;  ///< in a program that counts them: the exchange thread may
  std::int64_t longest_gap_ns = 0;          ///< between two ticks, by the time that really passed

  // The device as the loop sees it.
  loop::Wake wait(std::int64_t until_ns) override;
  loop::Sample newest() override;
  void leave(const loop::Command& command) override;

 private:
  void begin_exchange();
  bool end_exchange();
  void pass_without_ticks(std::int64_t until_ns);

  loop::Command command_;
  loop::Sample sample_, arrived_;
  FalconPacket arriving_{};
  bool busy_ = false, replies_ = false, unseen_ = false;
  std::int64_t sent_ns_ = 0, ends_ns_ = 0, ticked_ns_ = 0, gap_began_ = 0, checked_ = 0;
};

}  // namespace isotouch::test
