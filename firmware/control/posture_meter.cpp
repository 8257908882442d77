#include "firmware/control/posture_meter.h"

#include <algorithm>
#include <cstddef>

#include "shared/falcon_packet.h"

namespace isotouch::control {

namespace {

constexpr std::uint8_t kAllHomed = 7;
constexpr std::int64_t kCountFraction = 256;

/// Why this tick is none to measure in; nullptr: it is.
const char* objection(const loop::TickRecord& tick) {
  const auto& words = tick.out.commands;
  if (std::any_of(words.begin(), words.end(), [](std::int16_t word) { return word != 0; }))
    return "the motors push; run isotouch stop first";
  switch (static_cast<SupervisorState>(tick.out.state)) {
    case SupervisorState::kReady:
    case SupervisorState::kHold:  // from where the force returns by itself
    case SupervisorState::kActive: return "force is active; run isotouch stop first";
    case SupervisorState::kBoot: return "no device answers; plug it in, and see what isotouchd prints";
    default: return nullptr;
  }
}

}  // namespace

void PostureMeter::begin(std::uint32_t ticks, std::uint64_t after) {
  *this = {};
  left_ = std::max(ticks, 1U);
  after_ = after;
}

void PostureMeter::take(const loop::TickRecord& tick) {
  if (has_ended() || tick.number <= after_) return;
  if (const char* wrong = objection(tick)) return end(wrong);
  const Result<FalconReply> reply = decode_reply(tick.in.packet);
  if (reply && tick.in.fresh) {
    // A pose that no angles explain leaves the state at homing: there the packet itself tells. In idle the tick knows better, see keep_homing_flag.
    const bool homed = reply->homed == kAllHomed || tick.out.state == static_cast<std::uint16_t>(SupervisorState::kIdle);
    if (!homed) return end("the device is not homed; pull the grip out as far as it goes, push it in, and measure again");
    for (std::size_t i = 0; i < sum_.size(); ++i) {
      const std::int16_t count = reply->counts[i];
      least_[i] = fresh_ == 0 ? count : std::min(least_[i], count);
      most_[i] = fresh_ == 0 ? count : std::max(most_[i], count);
      sum_[i] += count;
      if (most_[i] - least_[i] > kStill) return end("the hand moves; rest the grip against something and measure again");
    }
    ++fresh_;
  }
  if (--left_ == 0 && fresh_ == 0) end("the device does not answer; check its cable");
}

std::array<std::int32_t, 3> PostureMeter::counts() const {
  std::array<std::int32_t, 3> mean{};
  for (std::size_t i = 0; i < mean.size() && fresh_ > 0; ++i) {
    const std::int64_t scaled = sum_[i] * kCountFraction, half = scaled < 0 ? -std::int64_t{fresh_ / 2} : std::int64_t{fresh_ / 2};
    mean[i] = static_cast<std::int32_t>((scaled + half) / fresh_);
  }
  return mean;
}

void PostureMeter::end(const char* refusal) {
  refusal_ = refusal;
  left_ = 0;
}

}  // namespace isotouch::control
