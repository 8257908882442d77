/// The FT232R in front of the Falcon: its vendor requests and the status pair in front of every 62 bytes. Pure.
///
/// source    libftdi's ftdi.c and Linux' ftdi_sio.h for the requests; FTDI's AN232B-04 for the framing
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "firmware/falcon/falcon_link.h"

namespace isotouch::falcon::ft232 {

/// A request from the host without data, to port "any".
constexpr UsbSetup request(std::uint8_t code, std::uint16_t value) {
  return {0x40, code, static_cast<std::uint8_t>(value & 0xFFU), static_cast<std::uint8_t>(value >> 8), 0, 0, 0, 0};
}

// The names of the two purges are told either way round; both are always sent.
inline constexpr UsbSetup kPurge1 = request(0, 1);
inline constexpr UsbSetup kPurge2 = request(0, 2);
inline constexpr UsbSetup kRtsLow = request(1, 0x0200);  // low byte: levels, DTR and RTS; high byte: which of them to change
inline constexpr UsbSetup kDtrLow = request(1, 0x0100);
inline constexpr UsbSetup kDtrHigh = request(1, 0x0101);
inline constexpr UsbSetup kNoFlowControl = request(2, 0);
inline constexpr UsbSetup kBaud9600 = request(3, 0x4138);    // 3,000,000 / 312.5
inline constexpr UsbSetup kBaudUpload = request(3, 0x0015);  // 3,000,000 / 21 = 142,857
inline constexpr UsbSetup kBaudRun = request(3, 0x0002);     // 1,500,000
inline constexpr UsbSetup k8N1 = request(4, 8);
inline constexpr UsbSetup kLatency16 = request(9, 16);  // milliseconds until a packet that is not full is sent
inline constexpr UsbSetup kLatency1 = request(9, 1);

/// What the status pairs told.
struct LineCounts {
  std::uint64_t packets = 0;  ///< status pairs seen
  std::uint64_t empty = 0;    ///< of these, with nothing behind
  std::uint64_t runts = 0;    ///< of a single byte, which the chip never sends
  std::uint64_t overruns = 0, parity = 0, framing = 0, breaks = 0;
};

/// Takes the status pair off the front of every 64 bytes and closes the gaps.
///
/// transfer  as it came, changed in place
/// returns   data bytes, now at the front
/// fails     never; real time: yes
std::size_t strip_status(std::span<std::uint8_t> transfer, LineCounts& counts);

}  // namespace isotouch::falcon::ft232
