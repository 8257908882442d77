/// The places of the running controller in which a bit may flip: each with the name that a table shows and the bytes that belong to it.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "tests/driver/fault_bench.h"

namespace isotouch::test {

struct FlipPlace {
  /// Where the bytes are.
  enum class Where : std::uint8_t {
    kMemory,       ///< `bytes`
    kGuardMemory,  ///< behind a file descriptor, see `guard_memory_file`
    kNextCommand,  ///< between tick and guard
    kNextPacket,   ///< between exchange and tick
  };
  std::string name;
  std::vector<std::span<std::uint8_t>> bytes = {};
  Where where = Where::kMemory;
};

/// As they lie in this bench now, with a field of a stiffness table; "felt" bricks are those around the proxy.
std::vector<FlipPlace> flip_places(FaultBench& bench);

/// The file of the guard's memory; -1: there is none.
int guard_memory_file();

/// Changes one bit of a place.
///
/// number    of the bit; its remainder counts
void flip(FaultBench& bench, const FlipPlace& place, std::uint64_t number);

}  // namespace isotouch::test
