/// What goes wrong with the link to a controller, and not with what it or anybody says.
#pragma once

#include "host/error.h"

namespace isotouch::link {

/// The controller is gone or silent, its ssh ended, or nobody waits for its answer any more. Ctrl-C interrupts an ssh, too: whoever was told to end
/// takes this for its consequence.
class LinkError : public InputError {
 public:
  using InputError::InputError;
};

}  // namespace isotouch::link
