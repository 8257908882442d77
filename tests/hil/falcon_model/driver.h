/// A small driver for tests: the requests of a host in their order, written from the device's sheet.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>
#include <vector>

#include "hil/falcon_model/simulated_falcon.h"

namespace isotouch::falcon_model::driver {

using Request = std::array<std::uint8_t, 8>;

constexpr Request vendor(std::uint8_t request, std::uint16_t value, std::uint16_t index = 0) {
  return {0x40,
          request,
          static_cast<std::uint8_t>(value & 0xFF),
          static_cast<std::uint8_t>(value >> 8),
          static_cast<std::uint8_t>(index & 0xFF),
          static_cast<std::uint8_t>(index >> 8),
          0,
          0};
}

inline constexpr Request kPurge1 = vendor(0, 1), kPurge2 = vendor(0, 2), kRtsLow = vendor(1, 0x0200), kDtrLow = vendor(1, 0x0100),
                         kDtrHigh = vendor(1, 0x0101), kNoFlowControl = vendor(2, 0), kBaud9600 = vendor(3, 0x4138),
                         kBaudUpload = vendor(3, 0x0015), kBaudRun = vendor(3, 0x0002), kEightNoneOne = vendor(4, 8),
                         kLatency16 = vendor(9, 16), kLatency1 = vendor(9, 1);

/// False when one of the requests stalls.
inline bool request(SimulatedFalcon& falcon, std::initializer_list<Request> setups) {
  return std::all_of(setups.begin(), setups.end(), [&](const Request& setup) { return !falcon.control(setup).stalled; });
}

inline void send(SimulatedFalcon& falcon, const Bytes& bytes) { falcon.write(bytes); }

inline Bytes text(const std::string& letters) { return {letters.begin(), letters.end()}; }

/// The data bytes of a transfer, without status pairs.
inline Bytes data_of(const Bytes& transfer) {
  Bytes data;
  for (std::size_t i = 0; i < transfer.size(); ++i) {
    if (i % 64 >= 2) data.push_back(transfer[i]);
  }
  return data;
}

/// An image with blocks of so many words, for no processor at all.
inline Bytes image_of(std::initializer_list<unsigned> blocks) {
  Bytes image{0xAA, 0x08, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0x3F, 0x00, 0x02, 0x80};
  const auto put = [&image](unsigned byte) { image.push_back(static_cast<std::uint8_t>(byte & 0xFF)); };
  for (const unsigned words : blocks) {
    for (const unsigned byte : {words, words >> 8, 0x3FU, 0U, 0U, 0x80U}) put(byte);
    for (unsigned i = 0; i < 2 * words; ++i) put(i * 7 + 1);
  }
  put(0);
  put(0);
  return image;
}

/// The smallest image that starts: 34 bytes, one block of two words.
inline Bytes small_image() {
  return {0xAA, 0x08, 0,    0,    0,    0,    0, 0,    0, 0, 0,    0,    0,    0,    0,    0, 0,
          0,    0x3F, 0x00, 0x02, 0x80, 0x02, 0, 0x3F, 0, 0, 0x80, 0x34, 0x12, 0x78, 0x56, 0, 0};
}

inline void firmware_mode(SimulatedFalcon& falcon) {
  request(falcon, {kPurge1, kPurge2, kLatency16, kBaud9600, kEightNoneOne, kNoFlowControl, kRtsLow, kDtrLow, kDtrHigh});
}

inline void run_mode(SimulatedFalcon& falcon) { request(falcon, {kLatency1, kBaudRun, kPurge1, kPurge2}); }

/// Uploads in chunks of 62 bytes; false at the first echo that differs.
inline bool upload(SimulatedFalcon& falcon, const Bytes& image) {
  for (std::size_t at = 0; at < image.size(); at += 62) {
    const auto begin = image.begin() + static_cast<std::ptrdiff_t>(at);
    const Bytes chunk(begin, begin + static_cast<std::ptrdiff_t>(std::min<std::size_t>(62, image.size() - at)));
    send(falcon, chunk);
    if (data_of(falcon.read(64)) != chunk) return false;
  }
  return true;
}

/// The whole order of a boot, with the expected answers; false at the first that differs.
inline bool boot(SimulatedFalcon& falcon) {
  firmware_mode(falcon);
  send(falcon, {0x0A, 0x43, 0x0D});
  if (data_of(falcon.read(512)) != Bytes{0x0A, 0x44, 0x2C, 0x0D}) return false;
  request(falcon, {kDtrLow, kBaudUpload});
  send(falcon, {0x41});
  if (data_of(falcon.read(512)) != Bytes{0x41}) return false;
  if (!upload(falcon, small_image())) return false;
  run_mode(falcon);
  return true;
}

inline Bytes command(const Commands& motors, bool homing = true, unsigned leds = 0) {
  Bytes bytes{'<'};
  for (const int motor : motors) {
    for (unsigned k = 0; k < 4; ++k) bytes.push_back(static_cast<std::uint8_t>('A' + (static_cast<unsigned>(motor) >> 4 * k & 15)));
  }
  bytes.push_back(static_cast<std::uint8_t>('A' + (homing ? 1U : 0U) + 2 * leds));
  bytes.push_back('A');
  bytes.push_back('>');
  return bytes;
}

/// A reply of 16 bytes as numbers; nothing when it is no whole one.
inline std::optional<ReplyPacket> decode(const Bytes& data) {
  if (data.size() != 16 || data.front() != '<' || data.back() != '>') return std::nullopt;
  ReplyPacket reply;
  for (std::size_t i = 0; i < 3; ++i) {
    unsigned value = 0;
    for (std::size_t k = 0; k < 4; ++k) {
      if (data[1 + 4 * i + k] < 'A' || data[1 + 4 * i + k] > 'P') return std::nullopt;
      value |= static_cast<unsigned>(data[1 + 4 * i + k] - 'A') << 4 * k;
    }
    reply.encoders[i] = static_cast<std::int16_t>(value);
  }
  reply.buttons = static_cast<std::uint8_t>((data[13] - 'A') & 15);
  reply.homed = static_cast<std::uint8_t>((data[13] - 'A') >> 4);
  return reply;
}

/// One packet and what is read after it.
inline std::optional<ReplyPacket> exchange(SimulatedFalcon& falcon, const Commands& motors = {}, bool homing = true) {
  send(falcon, command(motors, homing));
  return decode(data_of(falcon.read(64)));
}

/// Packets without force until the hand follows its path; false when it takes more than 10,000.
inline bool until_homed(SimulatedFalcon& falcon) {
  for (int i = 0; i < 10000; ++i) {
    exchange(falcon);
    if (falcon.hand().follows_path()) return true;
  }
  return false;
}

/// A device that runs already, without the boot.
inline SimulatedFalcon running(Settings settings) {
  settings.quirks.firmware_loaded = true;
  SimulatedFalcon falcon(std::move(settings));
  run_mode(falcon);
  return falcon;
}

}  // namespace isotouch::falcon_model::driver
