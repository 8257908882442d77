/// A patch: what turns the image of one field into that of another on the same grid (SPEC.md, section 7).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "shared/envelope.h"
#include "shared/field_view.h"
#include "shared/result.h"

namespace isotouch {

/// Byte offsets of the header's fields, in the order of SPEC.md 7.1.
namespace patch_layout {
using namespace envelope_layout;
inline constexpr std::size_t kHashBeforeAt = 24;
inline constexpr std::size_t kHashAfterAt = 32;
inline constexpr std::size_t kCellsAt = 40;
inline constexpr std::size_t kStoredAt = 44;
inline constexpr std::size_t kImageHeaderAt = 64;
inline constexpr std::size_t kHeaderBytes = 320;
inline constexpr Envelope kForm = {{'I', 'T', 'F', 'D'}, 1, 0, kHeaderBytes};

inline constexpr std::uint32_t kKindBits = 2;  ///< the lowest of a cell's word
inline constexpr std::uint32_t kStored =
    2;  ///< the kind of a cell with a brick of its own; the others are image_layout::kOutside and kInside
inline constexpr std::size_t kBrickBytes = 2 * image_layout::kSamplesPerBrick;
}  // namespace patch_layout

/// A checked patch. Borrows the bytes.
struct FieldPatch {
  std::uint64_t hash_before = 0;
  std::uint64_t hash_after = 0;
  FieldView after;                             ///< what the header of the image after says; no tables and no bricks
  std::span<const std::uint8_t> image_header;  ///< the first 256 bytes of the image after
  std::span<const std::uint8_t> cells;         ///< u32 each
  std::span<const std::uint8_t> bricks;        ///< 64 i16 for each stored cell
  std::span<const std::uint8_t> stiffness;     ///< u8 for each stored cell; empty without a table

  /// Of the patch itself.
  std::size_t patch_bytes() const;

  /// Of the image after: its size, and the offset of its stiffness table, 0 = none.
  std::size_t image_bytes() const;
  std::uint32_t stiffness_at() const;

  /// Checks everything that can be checked without the image before.
  ///
  /// fails     kBadMagic, kTruncated, kBadVersion, kBadHeader (of the image after, too; also the published method), kBadSize, kBadChecksum,
  ///           kBadPatch (a cell out of order, outside the tree, of an unknown kind, or stored though it is constant; both hashes are one)
  /// tick      no: it reads all bytes
  static Result<FieldPatch> parse(std::span<const std::uint8_t> bytes);

  /// True when the bytes begin like a patch.
  static bool has_magic(std::span<const std::uint8_t> bytes);
};

/// Whether two headers describe one grid, so that a patch may lead from one to the other (SPEC.md 7.1).
///
/// before, after     the first 256 bytes of two images
bool on_one_grid(std::span<const std::uint8_t> before, std::span<const std::uint8_t> after);

/// Writes the image after. Whether it is a valid field is for FieldView::parse to say.
///
/// before    a checked field
/// image     8-byte aligned, `patch.image_bytes()`; written, also where it fails. Not the memory of `before`
/// fails     kOtherField (`before` is not the field of this patch), kBadPatch (a cell does not change), kBadSize (the header of the image after counts
///           other nodes or bricks), kBadChecksum (the image after is not the one of this patch)
/// tick      no: it reads and writes whole images, but allocates nothing
Result<std::span<const std::uint8_t>> apply(const FieldPatch& patch, const FieldView& before, std::span<std::uint8_t> image);

}  // namespace isotouch
