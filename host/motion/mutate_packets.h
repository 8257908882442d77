/// The mutations of a device's packets, see `mutate.h`: the same hand, but packets, lines and people misbehave.
#pragma once

#include <cstdint>
#include <string_view>

#include "host/motion/mutate.h"

namespace isotouch::motion {

/// The same for the same recording and seed on every machine.
///
/// fails     InputError: an unknown kind
Recording mutate_packets(const Recording& recording, std::string_view name, std::uint64_t seed);

}  // namespace isotouch::motion
