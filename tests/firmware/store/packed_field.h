/// Small fields in their packed form, made without the host.
#pragma once

#include <zstd.h>

#include <cstdint>
#include <span>
#include <vector>

#include "shared/field_view.h"
#include "shared/packed_field.h"
#include "shared/protocol_messages.h"
#include "shared/residuals.h"
#include "tests/support/field_image.h"

namespace isotouch::store {

struct PackedField {
  std::vector<std::uint8_t> bytes;
  protocol::Begin promise;
};

/// Balls in a box of so many samples a side; each `which` is another one.
inline test::FieldImage ball_image(int which, std::uint32_t side = 16) {
  const double middle = side / 2.0, radius = middle - 6 + 0.3 * (which % 10);
  return test::FieldImage({side, side, side},
                          [&](const test::Point& p) {
                            return test::length(p - test::Point{middle, middle, middle}) - radius;
                          },
                          {.band = 2.0});
}

/// The same, packed.
inline PackedField packed_ball(int which, std::uint32_t side = 16) {
  const test::FieldImage image = ball_image(which, side);
  const FieldView& view = image.view();
  std::vector<std::uint8_t> residuals(view.image.size() - image_layout::kHeaderBytes);
  std::vector<std::uint32_t> codes(image_layout::kSamplesPerBrick * std::size_t{view.brick_count});
  const StreamSizes sizes = predict(view.image, codes, residuals);
  PackedField field;
  field.bytes.resize(packed_layout::kHeaderBytes + ZSTD_compressBound(residuals.size()));
  ZSTD_CCtx* context = ZSTD_createCCtx();
  ZSTD_CCtx_setParameter(context, ZSTD_c_windowLog, packed_layout::kWindowShift);
  const auto frame = std::span(field.bytes).subspan(packed_layout::kHeaderBytes);
  field.bytes.resize(packed_layout::kHeaderBytes + ZSTD_compress2(context, frame.data(), frame.size(), residuals.data(), residuals.size()));
  ZSTD_freeCCtx(context);
  seal_packed(view, sizes, field.bytes);
  field.promise = {field.bytes.size(), view.image.size(), view.hash(), protocol::Text::of("ball")};
  return field;
}

}  // namespace isotouch::store
