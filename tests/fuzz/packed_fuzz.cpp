/// The door for uploads: a packed field is refused, or unpacks to an image that its own door then judges.
#include <zstd.h>

#include "shared/crc32.h"
#include "shared/field_view.h"
#include "shared/packed_field.h"
#include "tests/fuzz/input.h"

using namespace isotouch;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size < packed_layout::kHeaderBytes) return 0;
  fuzz::Copy copy(data, size);
  const auto bytes = copy.bytes();
  store_le(bytes.data() + packed_layout::kTotalBytesAt, std::uint64_t{size});
  store_le(bytes.data() + packed_layout::kChecksumAt,
           crc32(bytes.data() + packed_layout::kTotalBytesAt, size - packed_layout::kTotalBytesAt));
  const Result<PackedField> packed = PackedField::parse(bytes);
  if (!packed || packed->image_bytes > (1U << 24)) return 0;  // larger ones are the allocator's business
  std::vector<std::uint8_t> residuals(packed->residual_bytes());
  std::vector<std::uint64_t> words((packed->image_bytes + 7) / 8);
  const std::span<std::uint8_t> image(reinterpret_cast<std::uint8_t*>(words.data()), packed->image_bytes);
  const auto unpacked = unpack(*packed, residuals, image, [](std::span<const std::uint8_t> frame, std::span<std::uint8_t> out) {
    return ZSTD_decompress(out.data(), out.size(), frame.data(), frame.size());
  });
  if (unpacked) static_cast<void>(FieldView::parse(image));
  return 0;
}
