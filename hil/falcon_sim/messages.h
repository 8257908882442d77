/// The socket's messages: one request, one answer, little-endian (hil/README.md, "The socket").
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "hil/falcon_sim/paced_device.h"

namespace isotouch::falcon_sim {

using falcon_model::Bytes;

inline constexpr std::size_t kMaxMessage = 1 + 4096;

enum Status : std::uint8_t { kOk = 0, kStalled = 1, kTimedOut = 2, kGone = 3 };

/// A bulk-in request: the one that may have to wait.
struct ReadRequest {
  std::size_t capacity = 0;      ///< bytes, a multiple of 64
  std::uint32_t timeout_ms = 0;  ///< 0: as long as it takes
};

std::optional<ReadRequest> parse_read(std::span<const std::uint8_t> message);

/// The answer to any other request; empty when the message is none.
Bytes answer(std::span<const std::uint8_t> message, PacedDevice& device, Time now);

Bytes read_answer(Status status, const Bytes& data);

/// Whether an answer says that the device is gone.
bool says_gone(const Bytes& answer);

}  // namespace isotouch::falcon_sim
