#include "host/field_file/marks.h"

#include <algorithm>
#include <cstdlib>

namespace isotouch::field_file {

using namespace image_layout;

namespace {

std::size_t beside_surface(const FieldView& view, std::uint32_t brick) {
  const std::span coefficients(view.bricks + std::size_t{brick} * kSamplesPerBrick, kSamplesPerBrick);
  constexpr int kHalfVoxel = 1 << (Distance::kFractionBits - 1);
  return static_cast<std::size_t>(
      std::count_if(coefficients.begin(), coefficients.end(), [](std::int16_t c) { return std::abs(c) < kHalfVoxel; }));
}

}  // namespace

void Marks::mark(const FieldView& view, std::int32_t i, std::int32_t j, std::int32_t k) {
  const std::uint32_t brick = view.brick_number(i, j, k);
  if (brick == kOutside || brick == kInside) return;
  bytes_.resize((std::size_t{view.brick_count} + 7) / 8);
  bytes_[brick / 8] = static_cast<std::uint8_t>(bytes_[brick / 8] | 1U << brick % 8);
}

bool is_crossed(const FieldView& view, std::uint32_t brick) { return beside_surface(view, brick) > 0; }

double share_of(const Marks& marks, const FieldView& view) {
  std::size_t all = 0, marked = 0;
  for (std::uint32_t brick = 2; brick < view.brick_count; ++brick) {
    const std::size_t samples = beside_surface(view, brick);
    all += samples;
    if (marks.has(brick)) marked += samples;
  }
  return all > 0 ? static_cast<double>(marked) / static_cast<double>(all) : 0.0;
}

}  // namespace isotouch::field_file
