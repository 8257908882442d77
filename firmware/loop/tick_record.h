/// One tick as the loop saw it, for recordings and for clients that follow the ticks.
#pragma once

#include <cstdint>

#include "firmware/loop/ring.h"
#include "shared/tick_io.h"

namespace isotouch::loop {

struct TickRecord {
  std::uint64_t number = 0;  ///< of the tick, from 1; 0 = none yet
  std::int64_t start_ns = 0;
  std::int64_t arrival_ns = 0;  ///< of the newest packet; 0 = none yet
  Input in;
  Output out;
  std::uint16_t faults = 0;   ///< all that no person has resumed after, those before a restart of the tick or the controller among them
  std::uint32_t wake_ns = 0;  ///< from when it should have begun to its begin
  std::uint32_t tick_ns = 0;  ///< from its begin to its commands being handed over
};

/// From the tick to the recorder.
using TraceRing = Ring<TickRecord>;

}  // namespace isotouch::loop
