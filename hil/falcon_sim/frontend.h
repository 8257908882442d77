/// One way into the simulated device. The program waits for what a frontend waits for, then lets it serve; no frontend ever blocks.
#pragma once

#include <poll.h>

#include <optional>
#include <vector>

#include "hil/falcon_sim/paced_device.h"

namespace isotouch::falcon_sim {

class Frontend {
 public:
  virtual ~Frontend() = default;

  /// Adds what it waits for.
  virtual void wait_for(std::vector<pollfd>& wanted) const = 0;
  /// When it wants to serve in any case; nothing: only when something arrives.
  virtual std::optional<Time> due() const = 0;
  /// Does what can be done now.
  virtual void serve(Time now) = 0;
};

}  // namespace isotouch::falcon_sim
