#include "host/field_file/marks.h"

#include <algorithm>
#include <cstdlib>

namespace isotouch::field_file {

using namespace image_layout;

namespace {

/// Voxels of surface in a brick, times the raw value of one: a coefficient stands for as much as it is below a voxel.
std::int64_t area_raw(const FieldView& view, std::uint32_t brick) {
  const std::span coefficients(view.bricks + std::size_t{brick} * kSamplesPerBrick, kSamplesPerBrick);
  constexpr int kVoxel = 1 << Distance::kFractionBits;
  std::int64_t area = 0;
  for (const std::int16_t c : coefficients) area += std::max(0, kVoxel - std::abs(c));
  return area;
}

}  // namespace

void Marks::mark(const FieldView& view, std::int32_t i, std::int32_t j, std::int32_t k) {
  const std::uint32_t brick = view.brick_number(i, j, k);
  if (brick == kOutside || brick == kInside) return;
  bytes_.resize((std::size_t{view.brick_count} + 7) / 8);
  bytes_[brick / 8] = static_cast<std::uint8_t>(bytes_[brick / 8] | 1U << brick % 8);
}

bool is_crossed(const FieldView& view, std::uint32_t brick) { return area_raw(view, brick) > 0; }

double share_of(const Marks& marks, const FieldView& view) {
  std::int64_t all = 0, marked = 0;
  for (std::uint32_t brick = 2; brick < view.brick_count; ++brick) {
    const std::int64_t area = area_raw(view, brick);
    all += area;
    if (marks.has(brick)) marked += area;
  }
  return all > 0 ? static_cast<double>(marked) / static_cast<double>(all) : 0.0;
}

}  // namespace isotouch::field_file
