/// The first 24 bytes of a field in any form: an image, a packed field and a patch begin alike (SPEC.md 2.3, 4.1 and 7.1).
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "shared/bytes.h"
#include "shared/crc32.h"
#include "shared/result.h"

namespace isotouch {

/// Byte offsets.
namespace envelope_layout {
inline constexpr std::size_t kMajorAt = 4;
inline constexpr std::size_t kMinorAt = 6;
inline constexpr std::size_t kHeaderBytesAt = 8;
inline constexpr std::size_t kChecksumAt = 12;  ///< of everything behind it
inline constexpr std::size_t kTotalBytesAt = 16;
}  // namespace envelope_layout

/// What tells one form from the others.
struct Envelope {
  std::array<std::uint8_t, 4> magic;
  std::uint16_t major, minor;
  std::uint32_t header_bytes;
};

/// True when the bytes begin with this magic.
inline bool has_magic(const Envelope& form, std::span<const std::uint8_t> bytes) {
  return bytes.size() >= form.magic.size() && std::equal(form.magic.begin(), form.magic.end(), bytes.begin());
}

inline std::uint32_t checksum_of(std::span<const std::uint8_t> bytes) {
  return crc32(bytes.data() + envelope_layout::kTotalBytesAt, bytes.size() - envelope_layout::kTotalBytesAt);
}

/// Why the bytes are no whole file of this form; nothing: they are.
///
/// returns   kBadMagic, kTruncated, kBadVersion (another major), kBadHeader (another size of the header), kBadSize (bytes behind the end), kBadChecksum
/// tick      no: it reads all bytes
inline std::optional<Error> refused(const Envelope& form, std::span<const std::uint8_t> bytes) {
  using namespace envelope_layout;
  if (!has_magic(form, bytes)) return Error::kBadMagic;
  if (bytes.size() < form.header_bytes) return Error::kTruncated;
  const std::uint8_t* at = bytes.data();
  if (load_le<std::uint16_t>(at + kMajorAt) != form.major) return Error::kBadVersion;
  if (load_le<std::uint32_t>(at + kHeaderBytesAt) != form.header_bytes) return Error::kBadHeader;
  const auto total = load_le<std::uint64_t>(at + kTotalBytesAt);
  if (total > bytes.size()) return Error::kTruncated;
  if (total != bytes.size()) return Error::kBadSize;
  if (checksum_of(bytes) != load_le<std::uint32_t>(at + kChecksumAt)) return Error::kBadChecksum;
  return std::nullopt;
}

/// Writes these 24 bytes, when everything behind them stands there.
///
/// bytes     of the whole file, at least the header
/// tick      no: it reads all bytes
inline void seal(const Envelope& form, std::span<std::uint8_t> bytes) {
  using namespace envelope_layout;
  std::uint8_t* at = bytes.data();
  std::copy(form.magic.begin(), form.magic.end(), at);
  store_le(at + kMajorAt, form.major);
  store_le(at + kMinorAt, form.minor);
  store_le(at + kHeaderBytesAt, form.header_bytes);
  store_le(at + kTotalBytesAt, std::uint64_t{bytes.size()});
  store_le(at + kChecksumAt, checksum_of(bytes));
}

}  // namespace isotouch
