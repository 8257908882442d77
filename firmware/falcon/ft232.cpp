#include "firmware/falcon/ft232.h"

#include <algorithm>

namespace isotouch::falcon::ft232 {

namespace {

constexpr std::size_t kPair = 2;

void count_line_status(std::uint8_t line, LineCounts& counts) {
  counts.overruns += line >> 1 & 1U;
  counts.parity += line >> 2 & 1U;
  counts.framing += line >> 3 & 1U;
  counts.breaks += line >> 4 & 1U;
}

}  // namespace

std::size_t strip_status(std::span<std::uint8_t> transfer, LineCounts& counts) {
  std::size_t kept = 0;
  for (std::size_t at = 0; at < transfer.size(); at += kUsbPacket) {
    const std::span<std::uint8_t> packet = transfer.subspan(at, std::min(kUsbPacket, transfer.size() - at));
    if (packet.size() < kPair) {
      ++counts.runts;
      break;
    }
    ++counts.packets;
    counts.empty += packet.size() == kPair ? 1U : 0U;
    count_line_status(packet[1], counts);
    std::copy(packet.begin() + kPair, packet.end(), transfer.begin() + static_cast<std::ptrdiff_t>(kept));
    kept += packet.size() - kPair;
  }
  return kept;
}

}  // namespace isotouch::falcon::ft232
