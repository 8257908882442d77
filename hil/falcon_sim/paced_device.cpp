#include "hil/falcon_sim/paced_device.h"

#include <algorithm>

namespace isotouch::falcon_sim {

namespace {

using namespace std::chrono_literals;

constexpr auto kFrame = 1ms;
constexpr auto kTurnaround = 250us;  // 16 bytes out and 16 in take 107 microseconds each; the board's own 36 are assumed

Time frame_before(Time t) { return Time(t.time_since_epoch() / kFrame * kFrame); }

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

falcon_model::Bytes PacedDevice::read(std::size_t capacity, Time now) {
  taken_ = frame_before(now);
  return falcon_.read(capacity);
}

Time PacedDevice::ready(Time asked) const {
  if (pace_ == Pace::kLockstep || !falcon_.present()) return asked;
  const auto latency = std::chrono::milliseconds(falcon_.chip().latency_ms());
  if (!falcon_.has_data()) return frame_at_or_after(asked + latency);
  Time there = std::max(asked, written_.value_or(asked) + kTurnaround);
  if (!falcon_.chip().fills_packet() && taken_) there = std::max(there, *taken_ + latency);
  return frame_at_or_after(there);
}

}  // namespace isotouch::falcon_sim
