/// The safety lines on a GPIO chip.
///
///   stop         in: high = run. The contact of the emergency stop, closed at rest, leads the supply to it; pressed, or with a broken wire, it is low
///   enable       out: high = the motors may have power
///   enable_back  in: high = they have; a contact of the relay that enable drives
///   heartbeat    out: changes every millisecond while ticks come, for a watchdog relay
///   light        out: a light
#pragma once

#include <memory>
#include <string>

#include "firmware/lines/gpio.h"
#include "firmware/loop/clock.h"
#include "firmware/loop/safety_lines.h"
#include "shared/files/refusal.h"

namespace isotouch::lines {

/// Numbers of lines on the chip; -1 = there is none.
struct GpioSettings {
  int stop = -1, enable = -1, enable_back = -1, heartbeat = -1, light = -1;
};

class GpioLines final : public loop::SafetyLines {
 public:
  /// chip      lives longer, and so does the clock
  GpioLines(Gpio& chip, loop::Clock& clock) : chip_(chip), clock_(clock) {}
  ~GpioLines() override { set({}); }
  GpioLines(const GpioLines&) = delete;
  GpioLines& operator=(const GpioLines&) = delete;

  /// Takes the lines.
  ///
  /// returns   why not all of them are taken, with what to do
  Refusal take(const GpioSettings& settings);

  void wait(std::int64_t until_ns) override;
  loop::LineInputs read() override;
  void set(const loop::LineOutputs& outputs) override;

 private:
  using Line = std::unique_ptr<GpioLine>;

  Gpio& chip_;
  loop::Clock& clock_;
  Line stop_, enable_, enable_back_, heartbeat_, light_;
  loop::LineOutputs set_;
  bool enable_failed_ = false;  ///< the chip did not take what was last set
  std::int64_t edge_ns_ = 0;
};

}  // namespace isotouch::lines
