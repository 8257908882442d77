#include "firmware/loop/felt_blocks.h"

#include <algorithm>

namespace isotouch::loop {

namespace {

constexpr std::int32_t kAround = 2;  // voxels: five samples in a row are in two bricks

std::int32_t to_sample(Voxel coordinate, std::int32_t size) {
  return std::clamp(coordinate.raw() >> Voxel::kFractionBits, kAround, size - 1 - kAround);
}

}  // namespace

bool FeltBlocks::Blocks::has(std::size_t number) const {
  const auto end = numbers.begin() + static_cast<std::ptrdiff_t>(count);
  return std::find(numbers.begin(), end, number) != end;
}

/// Takes the blocks of these bytes up; returns whether they are whole, as far as this call has not looked at them yet.
bool FeltBlocks::look(const FieldView& field, const BlockSums& sums, const void* at, std::size_t bytes) {
  const auto offset = static_cast<std::size_t>(static_cast<const std::uint8_t*>(at) - field.image.data());
  bool whole = true;
  for (std::size_t block = offset / BlockSums::kBytes; block <= (offset + bytes - 1) / BlockSums::kBytes; ++block) {
    if (now_.has(block)) continue;
    whole &= before_.has(block) || sums.holds(field.image, block);
    now_.numbers[now_.count++] = block;
  }
  return whole;
}

bool FeltBlocks::are_whole(const FieldView& field, const BlockSums& sums, const Vec3<Voxel>& point) {
  before_ = now_;
  now_.count = 0;
  for (std::size_t i = 0; i < before_.count; ++i) {
    if (!sums.holds(field.image, before_.numbers[i])) return false;
  }
  const std::int32_t x = to_sample(point.x, field.size[0]), y = to_sample(point.y, field.size[1]), z = to_sample(point.z, field.size[2]);
  for (unsigned corner = 0; corner < 8; ++corner) {
    const auto side = [corner](unsigned axis) { return (corner >> axis & 1U) != 0 ? kAround : -kAround; };
    const std::int32_t i = x + side(0), j = y + side(1), k = z + side(2);
    // An entry is followed only once it is known to be whole: another one leads anywhere.
    const std::uint32_t* const node = field.root + field.root_entry(i, j, k);
    if (!look(field, sums, node, sizeof *node)) return false;
    const std::uint32_t* const brick = field.nodes + FieldView::node_entry(*node, i, j, k);
    if (!look(field, sums, brick, sizeof *brick)) return false;
    const std::size_t number = *brick, bytes = image_layout::kSamplesPerBrick * sizeof *field.bricks;
    if (!look(field, sums, field.bricks + number * image_layout::kSamplesPerBrick, bytes)) return false;
    if (field.stiffness_parts != nullptr && !look(field, sums, field.stiffness_parts + number, 1)) return false;
  }
  return true;
}

}  // namespace isotouch::loop
