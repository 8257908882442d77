#include "host/server/tick_words.h"

#include <array>
#include <string_view>

namespace isotouch::server {

namespace {

struct Limit {
  std::uint32_t bit;
  std::string_view sentence;
};

/// What a limit did, and the next step.
constexpr std::array<Limit, 9> kLimits = {{
    {kForceLimited, "the force was shortened to its limit; press less, or raise force_limit_n with 'isotouch set'"},
    {kCommandsLimited, "the motor commands were shortened to their limit; press less"},
    {kSlewLimited, "the motor commands change as fast as they may; move more gently"},
    {kHeatLimited, "the motors are warm, so less force is allowed; let go for a minute"},
    {kNearSingular, "the arms are nearly stretched; move the grip towards the middle"},
    {kInputClamped, "the hand is outside the range of positions; move it towards the middle"},
    {kHeldInside, "the hand began inside the object; move it out, then there is force"},
    {kLagging, "the surface has moved by itself, and the force follows it gently"},
    {kDamped, "the passivity controller adds damping, because the stiffness is near what the device bears"},
}};

constexpr std::uint32_t kWaited = kPoseUncertain | kTooFast | kStale | kBadReply;  ///< what a hold names as its cause

constexpr std::uint32_t limits() {
  std::uint32_t all = 0;
  for (const Limit& limit : kLimits) all |= limit.bit;
  return all;
}

}  // namespace

TickWords words_of(const files::Condition& condition, bool of_device, protocol::OtherAngles others) {
  const auto state = static_cast<SupervisorState>(condition.state);
  const bool waits = state == SupervisorState::kIdle || state == SupervisorState::kHold;
  TickWords words{condition, of_device, others};
  words.condition.status &= limits() | (waits ? kWaited : 0U);
  return words;
}

nlohmann::ordered_json to_json(const TickWords& words, std::uint64_t tick) {
  const files::Condition& condition = words.condition;
  nlohmann::ordered_json sentences = nlohmann::ordered_json::array();
  for (const Limit& limit : kLimits) {
    if ((condition.status & limit.bit) != 0) sentences.push_back(limit.sentence);
  }
  return {{"topic", "state"},
          {"tick", tick},
          {"state", words.of_device ? files::state_name(condition.state) : "none"},
          {"sentence", words.of_device ? files::state_text(condition, words.others) : "a hand without a device"},
          {"fault", condition.faults != 0},
          {"limits", std::move(sentences)}};
}

}  // namespace isotouch::server
