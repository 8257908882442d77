#include "shared/packed_field.h"

#include <algorithm>
#include <optional>

#include "shared/bytes.h"
#include "shared/field_view.h"
#include "shared/image_parts.h"
#include "shared/zstd_frame.h"

namespace isotouch {

using namespace packed_layout;

namespace {

/// One bit a brick, none for the constant bricks and beyond the last, and not all of them 0.
bool are_marks(std::span<const std::uint8_t> marks, std::uint32_t bricks) {
  if (marks.size() != (std::uint64_t{bricks} + 7) / 8) return false;
  const bool constant = (marks.front() & 3U) != 0, beyond = bricks % 8 != 0 && marks.back() >> bricks % 8 != 0;
  return !constant && !beyond && std::any_of(marks.begin(), marks.end(), [](std::uint8_t byte) { return byte != 0; });
}

}  // namespace

bool PackedField::has_magic(std::span<const std::uint8_t> bytes) { return isotouch::has_magic(kForm, bytes); }

Result<PackedField> PackedField::parse(std::span<const std::uint8_t> bytes) {
  if (const auto error = refused(kForm, bytes)) return *error;
  const std::uint8_t* at = bytes.data();

  PackedField packed;
  packed.image_bytes = load_le<std::uint64_t>(at + kImageBytesAt);
  packed.image_hash = load_le<std::uint64_t>(at + kImageHashAt);
  packed.image_header = bytes.subspan(kImageHeaderAt, image_layout::kHeaderBytes);
  const auto mark_bytes = load_le<std::uint32_t>(at + kMarkBytesAt);
  if (mark_bytes > bytes.size() - kHeaderBytes) return Error::kBadSize;
  packed.frame = bytes.subspan(kHeaderBytes, bytes.size() - kHeaderBytes - mark_bytes);
  packed.marks = bytes.last(mark_bytes);
  std::uint64_t samples = 0;
  for (std::size_t stream = 0; stream < packed.stream_sizes.size(); ++stream) {
    packed.stream_sizes[stream] = load_le<std::uint32_t>(at + kStreamSizesAt + 4 * stream);
    samples += packed.stream_sizes[stream];
  }
  const Result<ImageParts> parts = ImageParts::of(packed.image_header, packed.image_bytes);
  if (!parts) return parts.error();
  if (samples != parts->samples()) return Error::kBadSize;
  if (packed.residual_bytes() > std::uint64_t{packed.frame.size()} << kMaxRatioShift) return Error::kBadSize;
  const std::optional<ZstdFrame> frame = read_zstd_frame(packed.frame);
  if (!frame || frame->content_bytes != packed.residual_bytes() || frame->window_bytes > std::uint64_t{1} << kWindowShift ||
      frame->dictionary != 0) {
    return Error::kBadFrame;
  }
  if (mark_bytes > 0 && !are_marks(packed.marks, parts->brick_count)) return Error::kBadMarks;
  if (const auto header = FieldView::of_header(packed.image_header, packed.image_bytes); !header) return header.error();
  return packed;
}

void seal_packed(const FieldView& image, const StreamSizes& sizes, std::span<std::uint8_t> packed, std::size_t mark_bytes) {
  std::uint8_t* at = packed.data();
  std::fill_n(at, kHeaderBytes, std::uint8_t{0});
  store_le(at + kImageBytesAt, std::uint64_t{image.image.size()});
  store_le(at + kImageHashAt, image.hash());
  for (std::size_t stream = 0; stream < sizes.size(); ++stream) store_le(at + kStreamSizesAt + 4 * stream, sizes[stream]);
  store_le(at + kMarkBytesAt, static_cast<std::uint32_t>(mark_bytes));
  std::copy_n(image.image.begin(), image_layout::kHeaderBytes, at + kImageHeaderAt);
  seal(kForm, packed);
}

}  // namespace isotouch
