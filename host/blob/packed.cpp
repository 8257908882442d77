#include "host/blob/packed.h"

#include <zstd.h>

#include <algorithm>
#include <memory>
#include <new>
#include <stdexcept>

#include "host/error.h"
#include "shared/bytes.h"
#include "shared/crc32.h"
#include "shared/hash64.h"
#include "shared/packed_blob.h"
#include "shared/residuals.h"

namespace isotouch::blob {

using namespace packed_layout;

namespace {

/// Of the levels measured on the project's objects the first is the quickest and packs best: residuals repeat nothing, they are only unevenly frequent.
constexpr int kLevel = 1;

/// Compresses into `out`; returns the bytes written.
std::size_t compress(std::span<const std::uint8_t> residuals, std::span<std::uint8_t> out) {
  const std::unique_ptr<ZSTD_CCtx, decltype(&ZSTD_freeCCtx)> context(ZSTD_createCCtx(), ZSTD_freeCCtx);
  if (!context) throw std::bad_alloc();
  ZSTD_CCtx_setParameter(context.get(), ZSTD_c_compressionLevel, kLevel);
  ZSTD_CCtx_setParameter(context.get(), ZSTD_c_windowLog, kWindowShift);
  const std::size_t written = ZSTD_compress2(context.get(), out.data(), out.size(), residuals.data(), residuals.size());
  if (ZSTD_isError(written) != 0) throw std::runtime_error(std::string("zstd: ") + ZSTD_getErrorName(written));
  return written;
}

/// The window that a frame asks for, bytes (RFC 8878, 3.1.1.1); the frame is known to have a complete header.
std::uint64_t window_bytes(std::span<const std::uint8_t> frame, std::uint64_t content_bytes) {
  constexpr std::size_t kDescriptorAt = 4;
  if ((frame[kDescriptorAt] & 0x20U) != 0) return content_bytes;  // a single segment is its own window
  const std::uint64_t base = std::uint64_t{1} << (10 + (frame[kDescriptorAt + 1] >> 3));
  return base + base / 8 * (frame[kDescriptorAt + 1] & 7U);
}

/// True when the bytes are one frame as SPEC.md 4.1 wants it.
bool is_good_frame(std::span<const std::uint8_t> frame, std::uint64_t content_bytes) {
  return ZSTD_getFrameContentSize(frame.data(), frame.size()) == content_bytes &&
         ZSTD_getDictID_fromFrame(frame.data(), frame.size()) == 0 &&
         window_bytes(frame, content_bytes) <= std::uint64_t{1} << kWindowShift &&
         ZSTD_findFrameCompressedSize(frame.data(), frame.size()) == frame.size();
}

}  // namespace

std::vector<std::uint8_t> pack(const BlobView& view) {
  std::vector<std::uint8_t> residuals(view.image.size() - blob_layout::kHeaderBytes);
  std::vector<std::uint32_t> codes(blob_layout::kSamplesPerBrick * std::size_t{view.brick_count});
  const StreamSizes sizes = predict(view.image, codes, residuals);
  std::vector<std::uint8_t> packed(kHeaderBytes + ZSTD_compressBound(residuals.size()));
  packed.resize(kHeaderBytes + compress(residuals, std::span(packed).subspan(kHeaderBytes)));

  std::uint8_t* at = packed.data();
  std::copy(kMagic.begin(), kMagic.end(), at);
  store_le(at + kMajorAt, kMajor);
  store_le(at + kMinorAt, kMinor);
  store_le(at + kHeaderBytesAt, static_cast<std::uint32_t>(kHeaderBytes));
  store_le(at + kTotalBytesAt, std::uint64_t{packed.size()});
  store_le(at + kImageBytesAt, std::uint64_t{view.image.size()});
  store_le(at + kImageHashAt, view.hash());
  for (std::size_t stream = 0; stream < sizes.size(); ++stream) store_le(at + kStreamSizesAt + 4 * stream, sizes[stream]);
  std::copy_n(view.image.begin(), blob_layout::kHeaderBytes, at + kImageHeaderAt);
  store_le(at + kChecksumAt, crc32(at + kTotalBytesAt, packed.size() - kTotalBytesAt));
  return packed;
}

Image unpack(std::span<const std::uint8_t> bytes, const std::string& name) {
  const auto refuse = [&](Error error) -> InputError {
    return InputError(name + ": not usable as a packed blob: " + describe(error) + "; fetch or build it again");
  };
  const Result<PackedBlob> packed = PackedBlob::parse(bytes);
  if (!packed) throw refuse(packed.error());
  if (!is_good_frame(packed->frame, packed->residual_bytes())) throw refuse(Error::kBadFrame);

  const auto residual_bytes = static_cast<std::size_t>(packed->residual_bytes());
  const auto residuals = std::make_unique_for_overwrite<std::uint8_t[]>(residual_bytes);
  const std::size_t got = ZSTD_decompress(residuals.get(), residual_bytes, packed->frame.data(), packed->frame.size());
  if (got != residual_bytes) throw refuse(Error::kBadFrame);
  Image image(static_cast<std::size_t>(packed->image_bytes));
  std::copy(packed->image_header.begin(), packed->image_header.end(), image.data());
  const auto restored = restore({residuals.get(), residual_bytes}, packed->stream_sizes, {image.data(), image.size()});
  if (!restored) throw refuse(restored.error());
  if (hash64(image.data(), image.size()) != packed->image_hash) throw refuse(Error::kBadChecksum);
  return image;
}

}  // namespace isotouch::blob
