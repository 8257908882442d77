#include "hil/falcon_sim/paced_device.h"

#include <algorithm>

namespace isotouch::falcon_sim {

namespace {

using namespace std::chrono_literals;

constexpr auto kFrame = 1ms;
constexpr auto kTurnaround = 250us;  // 16 bytes out and 16 in take 107 microseconds each; the board's own 36 are assumed

Time frame_at_or_after(Time t) {
  const auto frames = (t.time_since_epoch() + kFrame - 1ns) / kFrame;
  return Time(frames * kFrame);
}

}  // namespace

std::size_t PacedDevice::write(std::span<const std::uint8_t> bytes, Time now) {
  if (pace_ == Pace::kReal && written_) {
    const std::chrono::duration<double, std::milli> silent = now - *written_;
    if (silent > 2 * kFrame) falcon_.silence(silent.count());
  }
  written_ = now;
  return falcon_.write(bytes);
}

Time PacedDevice::ready(Time asked) const {
  if (pace_ == Pace::kLockstep || !falcon_.present()) return asked;
  if (!falcon_.has_data()) return frame_at_or_after(asked + std::chrono::milliseconds(falcon_.chip().latency_ms()));
  return frame_at_or_after(std::max(asked, written_.value_or(asked) + kTurnaround));
}

}  // namespace isotouch::falcon_sim
