/// What an image holds beyond what its samples' neighbours tell (SPEC.md 4.2 and 4.3): as many bytes, of which zstd leaves a third. And back.
///
/// tick      no: time grows with the image. No allocation
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "shared/result.h"

namespace isotouch {

/// Samples that were predicted by corner, by planes, by lines, by nothing.
using StreamSizes = std::array<std::uint32_t, 4>;

/// Image → residuals.
///
/// image     8-byte aligned, accepted by FieldView::parse
/// codes     room to work in, one a sample: 64 times the brick count
/// residuals as many bytes as the image has behind its header
/// returns   the lengths of the four streams in place of the bricks
StreamSizes predict(std::span<const std::uint8_t> image, std::span<std::uint32_t> codes, std::span<std::uint8_t> residuals);

/// Residuals → image, the inverse of `predict`.
///
/// sizes     what `predict` returned
/// image     8-byte aligned; its header is there, the rest is written
/// returns   the image. It is restored, not checked: FieldView::parse does that
/// fails     kMisaligned, and for bytes that `predict` did not make: those of ImageParts::of, kBadIndex (a table entry outside its table), kBadSize
///           (a stream ends too early)
Result<std::span<const std::uint8_t>> restore(std::span<const std::uint8_t> residuals, const StreamSizes& sizes,
                                              std::span<std::uint8_t> image);

}  // namespace isotouch
