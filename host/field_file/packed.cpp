#include "host/field_file/packed.h"

#include <zstd.h>

#include <algorithm>
#include <memory>
#include <new>
#include <stdexcept>
#include <utility>

#include "host/error.h"
#include "shared/packed_field.h"
#include "shared/residuals.h"

namespace isotouch::field_file {

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

InputError refusal(const std::string& name, Error error) {
  return InputError(name + ": not usable as a packed field: " + describe(error) + "; fetch or build it again");
}

}  // namespace

std::vector<std::uint8_t> pack(const FieldView& view, const Marks& invented) {
  std::vector<std::uint8_t> residuals(view.image.size() - image_layout::kHeaderBytes);
  std::vector<std::uint32_t> codes(image_layout::kSamplesPerBrick * std::size_t{view.brick_count});
  const StreamSizes sizes = predict(view.image, codes, residuals);
  std::vector<std::uint8_t> packed(kHeaderBytes + ZSTD_compressBound(residuals.size()));
  packed.resize(kHeaderBytes + compress(residuals, std::span(packed).subspan(kHeaderBytes)));
  packed.insert(packed.end(), invented.bytes().begin(), invented.bytes().end());
  seal_packed(view, sizes, packed, invented.bytes().size());
  return packed;
}

PackedField checked_packed(std::span<const std::uint8_t> bytes, const std::string& name) {
  const Result<PackedField> packed = PackedField::parse(bytes);
  if (!packed) throw refusal(name, packed.error());
  return *packed;
}

StoredField unpack(std::span<const std::uint8_t> bytes, const std::string& name) {
  const PackedField packed = checked_packed(bytes, name);
  const auto residual_bytes = static_cast<std::size_t>(packed.residual_bytes());
  const auto residuals = std::make_unique_for_overwrite<std::uint8_t[]>(residual_bytes);
  Image image(static_cast<std::size_t>(packed.image_bytes));
  const auto unpacked = isotouch::unpack(packed, {residuals.get(), residual_bytes}, {image.data(), image.size()}, [](auto frame, auto out) {
    return ZSTD_decompress(out.data(), out.size(), frame.data(), frame.size());
  });
  if (!unpacked) throw refusal(name, unpacked.error());
  return {std::move(image), Marks(packed.marks)};
}

}  // namespace isotouch::field_file
