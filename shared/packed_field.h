/// A packed field, the form for socket and disk (SPEC.md, section 4): what its header says, checked before anything is unpacked.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "shared/envelope.h"
#include "shared/field_view.h"
#include "shared/hash64.h"
#include "shared/residuals.h"
#include "shared/result.h"

namespace isotouch {

/// Byte offsets of the header's fields, in the order of SPEC.md 4.1.
namespace packed_layout {
using namespace envelope_layout;
inline constexpr std::size_t kImageBytesAt = 24;
inline constexpr std::size_t kImageHashAt = 32;
inline constexpr std::size_t kStreamSizesAt = 40;
inline constexpr std::size_t kMarkBytesAt = 56;
inline constexpr std::size_t kImageHeaderAt = 64;
inline constexpr std::size_t kHeaderBytes = 320;
inline constexpr Envelope kForm = {{'I', 'T', 'F', 'P'}, 1, 0, kHeaderBytes};
inline constexpr int kWindowShift = 17;    ///< of the frame: a reader may hold so little of it at a time
inline constexpr int kMaxRatioShift = 15;  ///< no frame expands further
}  // namespace packed_layout

/// A checked packed field. Borrows the bytes.
struct PackedField {
  std::uint64_t image_bytes = 0;
  std::uint64_t image_hash = 0;
  StreamSizes stream_sizes{};
  std::span<const std::uint8_t> image_header;  ///< the first 256 bytes of the image
  std::span<const std::uint8_t> frame;         ///< zstd; unpacks to the residuals
  std::span<const std::uint8_t> marks;         ///< a bit for each brick: its surface was invented (SPEC.md 4.4); empty = none was

  std::uint64_t residual_bytes() const { return image_bytes - image_header.size(); }

  /// Checks everything that can be checked without unpacking.
  ///
  /// fails     kBadMagic, kTruncated, kBadVersion, kBadHeader (of the image, too), kBadSize (sizes that contradict each other, or an image larger than the
  ///           frame can hold), kBadChecksum, kBadFrame (not one frame as SPEC.md 4.1 wants it), kBadMarks (not as SPEC.md 4.4 wants them)
  /// tick      no: it reads all bytes
  static Result<PackedField> parse(std::span<const std::uint8_t> bytes);

  /// True when the bytes begin like a packed field.
  static bool has_magic(std::span<const std::uint8_t> bytes);
};

/// Writes the header in front of a frame that stands at `packed_layout::kHeaderBytes` of `packed` already.
///
/// image       a checked one
/// sizes       what `predict` returned for it; the frame holds the residuals
/// packed      header, frame and marks, nothing behind
/// mark_bytes  how many of them are marks
void seal_packed(const FieldView& image, const StreamSizes& sizes, std::span<std::uint8_t> packed, std::size_t mark_bytes = 0);

/// Unpacks the image and checks its hash. Whether the image is a valid field is for FieldView::parse to say.
///
/// residuals   memory to work in, `packed.residual_bytes()`
/// image       8-byte aligned, `packed.image_bytes`; written
/// decompress  unpacks a zstd frame: (frame, out) → bytes written, another number than the size of `out` when it fails
/// fails       kBadFrame, kBadChecksum (the image is not the one that was packed), and as `restore`
template <class Decompress>
Result<std::span<const std::uint8_t>> unpack(const PackedField& packed, std::span<std::uint8_t> residuals, std::span<std::uint8_t> image,
                                             Decompress&& decompress) {
  if (decompress(packed.frame, residuals) != residuals.size()) return Error::kBadFrame;
  std::copy(packed.image_header.begin(), packed.image_header.end(), image.begin());
  const auto restored = restore(residuals, packed.stream_sizes, image);
  if (restored && hash64(image.data(), image.size()) != packed.image_hash) return Error::kBadChecksum;
  return restored;
}

}  // namespace isotouch
