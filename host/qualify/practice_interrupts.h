/// Two findings of `practice.h`: who is served first when the device answers, and what else is served on the tick's core.
#pragma once

#include "host/qualify/finding.h"

namespace isotouch::qualify {

/// The thread of each USB controller's interrupt must come before the thread of ours that waits for it.
Finding xhci_priority(const Board& board);

/// Which interrupts may interrupt the tick.
Finding irq_affinity(const Board& board);

}  // namespace isotouch::qualify
