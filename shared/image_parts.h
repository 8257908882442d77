/// Where tables and bricks lie in a field's image, for who works on an image that is not complete yet; a complete one has its FieldView.
///
/// tick      no
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "shared/result.h"

namespace isotouch {

struct ImageParts {
  std::array<std::uint32_t, 3> root_size{};  ///< nodes along x, y, z
  std::uint32_t node_count = 0;
  std::uint32_t brick_count = 0;
  std::uint32_t root_at = 0;  ///< offsets in the image, bytes
  std::uint32_t nodes_at = 0;
  std::uint32_t bricks_at = 0;
  std::int32_t band = 0;  ///< as a coefficient

  std::uint64_t root_entries() const { return std::uint64_t{root_size[0]} * root_size[1] * root_size[2]; }
  std::uint64_t node_entries() const { return std::uint64_t{64} * node_count; }
  std::uint64_t samples() const { return std::uint64_t{64} * brick_count; }

  /// Reads them from an image's header and checks that they lie within the image, in this order and without overlap. Nothing behind the
  /// header is looked at: the entries of the tables may still be anything.
  ///
  /// header    the first 256 bytes of the image
  /// fails     kBadMagic, kBadVersion, kBadHeader, kBadSize
  static Result<ImageParts> of(std::span<const std::uint8_t> header, std::uint64_t image_bytes);
};

}  // namespace isotouch
