/// From the bytes of IN transfers to the device's replies: packets that come in pieces, merged, cut or spoilt. Pure.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "firmware/falcon/ft232.h"
#include "shared/falcon_packet.h"

namespace isotouch::falcon {

/// What went by since the stream began.
struct StreamCounts {
  ft232::LineCounts line;
  std::uint64_t replies = 0;  ///< valid packets
  std::uint64_t split = 0;    ///< of these, come in more than one transfer
  std::uint64_t merged = 0;   ///< of these, not the first to end in their transfer
  std::uint64_t cut = 0;      ///< begun, but ended early by '>' or by the next '<': bytes were lost
  std::uint64_t corrupt = 0;  ///< sixteen bytes from '<' that are no packet
  std::uint64_t skipped = 0;  ///< bytes outside packets
};

/// Finds the packets in a stream of bytes. '<' never occurs within a packet, so each one begins anew there; no byte is looked at twice.
class FalconStream {
 public:
  /// transfer  one IN transfer with its status pairs, changed in place
  /// returns   how many valid replies ended in it
  /// fails     never; real time: yes, its cost is in proportion to the transfer
  std::size_t feed(std::span<std::uint8_t> transfer);

  /// The last valid reply; a default one before the first.
  const FalconReply& newest() const { return newest_; }
  /// The same as it came; all zero before the first.
  const FalconPacket& newest_packet() const { return newest_packet_; }
  const StreamCounts& counts() const { return counts_; }

  /// Forgets a packet that has begun; for a moment at which the other side lost its place too.
  void restart();

 private:
  bool take(std::uint8_t byte);

  FalconPacket packet_{};
  std::size_t size_ = 0;        ///< bytes of the packet that has begun; 0 = none has
  bool begun_earlier_ = false;  ///< in a transfer before this one
  FalconReply newest_;
  FalconPacket newest_packet_{};
  StreamCounts counts_;
};

}  // namespace isotouch::falcon
