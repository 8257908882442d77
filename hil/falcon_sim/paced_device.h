/// When the simulated device answers: on USB's frames, or at once. The device itself knows no time; what time it is, is told.
#pragma once

#include <chrono>
#include <optional>
#include <utility>

#include "hil/falcon_model/simulated_falcon.h"

namespace isotouch::falcon_sim {

using Time = std::chrono::steady_clock::time_point;

enum class Pace {
  kReal,      ///< replies and status pairs fall due on a grid of 1 ms, as full-speed USB has it
  kLockstep,  ///< at once: a run is a pure function of what was sent
};

class PacedDevice {
 public:
  PacedDevice(falcon_model::SimulatedFalcon falcon, Pace pace) : falcon_(std::move(falcon)), pace_(pace) {}

  falcon_model::SimulatedFalcon& falcon() { return falcon_; }

  /// Bulk out. In real pace the device first hears how long the host was silent.
  std::size_t write(std::span<const std::uint8_t> bytes, Time now);

  /// Bulk in, at a time that `ready` named or later: the latency timer begins anew.
  falcon_model::Bytes read(std::size_t capacity, Time now);

  /// When a read that was asked for at `asked` is answered: with the next frame when a full packet is there by then, or some bytes and the latency timer
  /// has run out; without data when the timer has run out since it was asked for. May come earlier after a write.
  Time ready(Time asked) const;

 private:
  falcon_model::SimulatedFalcon falcon_;
  Pace pace_;
  std::optional<Time> written_, taken_;
};

}  // namespace isotouch::falcon_sim
