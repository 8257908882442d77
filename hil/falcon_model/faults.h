/// Faults on order: what happens at which packet. A script has one fault a line, `at PACKET FAULT [ARGUMENTS]`; '#' begins a comment.
///
/// Packets are counted from 1, whole command packets at the run-time rate, whatever the board makes of them; `at 0` is before anything is sent.
#pragma once

#include <array>
#include <cstdint>
#include <iosfwd>
#include <string>
#include <vector>

namespace isotouch::falcon_model {

enum class FaultKind {
  kShort,         ///< the reply has 14 bytes
  kMerged,        ///< the reply comes together with the next one
  kLate,          ///< PACKETS: the reply comes so many packets later, with all those between
  kCorrupt,       ///< [BYTE [XOR]]: one byte of the reply is changed; default byte 5 by 20 hex, no nibble any more
  kRepeated,      ///< the reply before comes again in place of this one
  kSplit,         ///< BYTES: the reply comes in two USB packets, the first with so many bytes
  kModemOnly,     ///< READS: so many reads find a bare status pair although the reply waits
  kStall,         ///< PACKETS: so many packets, this one among them, are not heard; 1 ms each unless the step is set otherwise
  kButtons,       ///< MASK PACKETS: buttons are shown pressed
  kUnplug,        ///< [REFUSALS]: USB is gone; it is back after so many openings were refused
  kFirmwareLost,  ///< the board is cold
  kHomingLost,    ///< every axis counts from where it stands
  kEncoderJump,   ///< AXIS COUNTS: one axis, 0 top, 1 right, 2 left, counts so many more
  kEncoderStuck,  ///< MASK PACKETS: axes of the mask, bit 0 top, 1 right, 2 left, report the same count for so many packets
  kNoWallPower,   ///< nobody answers behind the chip
  kWallPower,     ///< the supply is back, the board cold
};

struct Fault {
  std::uint64_t packet = 0;
  FaultKind kind = FaultKind::kStall;
  std::array<int, 2> arguments{};

  friend bool operator==(const Fault&, const Fault&) = default;
};

/// Reads a script; the faults come ordered by packet, those of one packet as they stand.
///
/// name      of the file, for complaints
/// fails     std::runtime_error, a sentence with file, line, what is wrong and what to write
std::vector<Fault> read_faults(std::istream& in, const std::string& name);

/// The line that orders it, arguments that are as they would be otherwise left out.
std::string line_of(const Fault& fault);

}  // namespace isotouch::falcon_model
