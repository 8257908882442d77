#include "hil/falcon_model/descriptors.h"

#include <cstddef>

namespace isotouch::falcon_model {

namespace {

constexpr std::uint8_t kAttributes = 0xA0, kHalfMilliampere = 45;

constexpr std::uint8_t low(std::uint16_t word) { return static_cast<std::uint8_t>(word & 0xFF); }
constexpr std::uint8_t high(std::uint16_t word) { return static_cast<std::uint8_t>(word >> 8); }

}  // namespace

Bytes device_descriptor() {
  return {18, 1, 0x00, 0x02, 0, 0, 0, 8, low(kVendor), high(kVendor), low(kProduct), high(kProduct), low(kRelease), high(kRelease),
          1,  2, 3,    1};
}

Bytes configuration_descriptor() {
  return {9,
          2,
          32,
          0,
          1,
          1,
          0,
          kAttributes,
          kHalfMilliampere,  // one interface, configuration 1
          9,
          4,
          0,
          0,
          2,
          0xFF,
          0xFF,
          0xFF,
          2,  // interface 0: two endpoints, vendor class
          7,
          5,
          kEndpointIn,
          2,
          kUsbPacketBytes,
          0,
          0,  //
          7,
          5,
          kEndpointOut,
          2,
          kUsbPacketBytes,
          0,
          0};
}

Bytes string_descriptor(const Strings& strings, unsigned number) {
  if (number == 0) return {4, 3, 0x09, 0x04};  // English (United States)
  if (number > 3) return {};
  const std::string& text = number == 1 ? strings.manufacturer : number == 2 ? strings.product : strings.serial;
  Bytes bytes{static_cast<std::uint8_t>(2 + 2 * text.size()), 3};
  for (const char c : text) {
    bytes.push_back(static_cast<std::uint8_t>(c));
    bytes.push_back(0);
  }
  return bytes;
}

std::array<std::uint16_t, 64> memory_words(const Strings& strings) {
  std::array<std::uint8_t, 128> bytes{};
  const std::array<std::uint8_t, 11> head = {
      0,   0x40, low(kVendor), high(kVendor), low(kProduct), high(kProduct), low(kRelease), high(kRelease), kAttributes, kHalfMilliampere,
      0x08 /* a serial number is used */};
  std::size_t at = 0;
  for (const std::uint8_t b : head) bytes[at++] = b;
  at = 0x18;
  for (unsigned number = 1; number <= 3; ++number) {
    const Bytes text = string_descriptor(strings, number);
    if (at + text.size() > bytes.size() - 2) break;
    bytes[12 + 2 * number] = static_cast<std::uint8_t>(at | 0x80);
    bytes[13 + 2 * number] = static_cast<std::uint8_t>(text.size());
    for (const std::uint8_t b : text) bytes[at++] = b;
  }
  std::array<std::uint16_t, 64> words{};
  std::uint16_t checksum = 0xAAAA;
  for (std::size_t i = 0; i < 63; ++i) {
    words[i] = static_cast<std::uint16_t>(bytes[2 * i] | bytes[2 * i + 1] << 8);
    checksum = static_cast<std::uint16_t>(checksum ^ words[i]);
    checksum = static_cast<std::uint16_t>(checksum << 1 | checksum >> 15);
  }
  words[63] = checksum;
  return words;
}

}  // namespace isotouch::falcon_model
