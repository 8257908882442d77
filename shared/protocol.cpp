#include "shared/protocol.h"

#include <algorithm>
#include <cassert>

#include "shared/bytes.h"
#include "shared/crc32.h"

namespace isotouch::protocol {

namespace {

/// Kind, reserved bytes, length and body.
std::uint32_t checksum(const std::uint8_t* frame, std::size_t body_bytes) {
  return crc32(frame + kHeaderBytes, body_bytes, crc32(frame + kKindAt, kChecksumAt - kKindAt));
}

}  // namespace

Result<Frame> read_frame(std::span<const std::uint8_t> bytes) {
  const std::size_t shown = std::min(bytes.size(), kMagic.size());
  if (!std::equal(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(shown), kMagic.begin())) return Error::kBadMagic;
  if (bytes.size() < kHeaderBytes) return Frame{};
  const std::uint8_t* at = bytes.data();
  if (at[kKindAt + 1] != 0 || at[kKindAt + 2] != 0 || at[kKindAt + 3] != 0) return Error::kBadHeader;
  const auto body_bytes = load_le<std::uint32_t>(at + kLengthAt);
  if (body_bytes > kMaxBody) return Error::kBadSize;
  if (bytes.size() - kHeaderBytes < body_bytes) return Frame{};
  if (checksum(at, body_bytes) != load_le<std::uint32_t>(at + kChecksumAt)) return Error::kBadChecksum;
  return Frame{static_cast<Kind>(at[kKindAt]), bytes.subspan(kHeaderBytes, body_bytes), kHeaderBytes + body_bytes};
}

std::size_t seal_frame(Kind kind, std::size_t body_bytes, std::span<std::uint8_t> frame) {
  assert(body_bytes <= kMaxBody && frame.size() >= kHeaderBytes + body_bytes);
  std::uint8_t* at = frame.data();
  std::copy(kMagic.begin(), kMagic.end(), at);
  store_le(at + kKindAt, static_cast<std::uint32_t>(kind));
  store_le(at + kLengthAt, static_cast<std::uint32_t>(body_bytes));
  store_le(at + kChecksumAt, checksum(at, body_bytes));
  return kHeaderBytes + body_bytes;
}

}  // namespace isotouch::protocol
