/// Which Falcons are plugged in.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "firmware/falcon/link_error.h"

namespace isotouch::falcon {

/// One Falcon on the bus.
struct FoundFalcon {
  int bus = 0, address = 0;
  std::string name, serial;          ///< empty where it cannot be opened
  std::optional<LinkError> trouble;  ///< why it cannot
};

struct UsbListing {
  std::vector<FoundFalcon> falcons;
  std::optional<LinkError> trouble;  ///< why none can be listed
};

/// Every Falcon on the bus, in its order. Opens each for a moment to read its serial.
UsbListing list_falcons();

/// One line for each, or one sentence why there is none.
std::string explain(const UsbListing& listing);

}  // namespace isotouch::falcon
