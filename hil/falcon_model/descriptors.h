/// What the device says about itself: descriptors of a stock FT232R under the Falcon's product number, and the chip's memory that holds the same.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace isotouch::falcon_model {

using Bytes = std::vector<std::uint8_t>;

inline constexpr std::uint16_t kVendor = 0x0403, kProduct = 0xCB48, kRelease = 0x0600;
inline constexpr std::uint8_t kEndpointIn = 0x81, kEndpointOut = 0x02;
inline constexpr std::size_t kUsbPacketBytes = 64;

/// ASCII, at most 30 characters each: more does not fit the chip's memory.
struct Strings {
  std::string manufacturer = "FTDI";
  std::string product = "FALCON HAPTIC";
  std::string serial = "SIM00001";
};

Bytes device_descriptor();         ///< 18 bytes
Bytes configuration_descriptor();  ///< 32 bytes: one vendor-class interface, two bulk endpoints

/// String descriptor `number`: 0 languages, 1 manufacturer, 2 product, 3 serial; empty for any other.
Bytes string_descriptor(const Strings& strings, unsigned number);

/// The chip's 64 words, with their checksum.
std::array<std::uint16_t, 64> memory_words(const Strings& strings);

}  // namespace isotouch::falcon_model
