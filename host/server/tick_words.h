/// What one tick says to a person: the controller's own sentence, and the limits that were at work.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>

#include "shared/files/state_text.h"

namespace isotouch::server {

struct TickWords {
  files::Condition condition;  ///< with the status bits that change a sentence alone
  bool of_device = true;       ///< else a hand without one, which has no state
  protocol::OtherAngles others = protocol::OtherAngles::kNone;
  bool operator==(const TickWords&) const = default;
};

/// others    as `files::state_text`
TickWords words_of(const files::Condition& condition, bool of_device, protocol::OtherAngles others = protocol::OtherAngles::kNone);

/// topic, tick, state, sentence, whether it is a fault, and a sentence for each limit.
nlohmann::ordered_json to_json(const TickWords& words, std::uint64_t tick);

}  // namespace isotouch::server
