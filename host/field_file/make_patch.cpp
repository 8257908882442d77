#include "host/field_file/make_patch.h"

#include <algorithm>
#include <cstring>
#include <span>

#include "host/error.h"
#include "shared/bytes.h"
#include "shared/field_patch.h"

namespace isotouch::field_file {

namespace {

using namespace patch_layout;
using image_layout::kBricksPerNode;
using image_layout::kInside;
using image_layout::kSamplesPerBrick;

std::size_t root_cells(const FieldView& view) {
  return static_cast<std::size_t>(view.root_size[0]) * static_cast<std::size_t>(view.root_size[1]) *
         static_cast<std::size_t>(view.root_size[2]);
}

std::uint32_t brick_of(const FieldView& view, std::uint32_t cell) {
  return view.nodes[std::size_t{view.root[cell / kBricksPerNode]} * kBricksPerNode + cell % kBricksPerNode];
}

const std::int16_t* coefficients(const FieldView& view, std::uint32_t brick) { return view.bricks + std::size_t{brick} * kSamplesPerBrick; }

/// Does a patch lead to the image that it was made for? To no other than the one that `apply` writes: nodes and bricks numbered in the order of the
/// tree, none that could be a constant one, zeros between the tables.
bool leads_to_it(std::span<const std::uint8_t> bytes, const FieldView& before) {
  const Result<FieldPatch> patch = FieldPatch::parse(bytes);
  if (!patch) return false;
  std::vector<std::uint64_t> words((patch->image_bytes() + 7) / 8);
  return apply(*patch, before, {reinterpret_cast<std::uint8_t*>(words.data()), patch->image_bytes()}).has_value();
}

}  // namespace

std::vector<std::uint32_t> changed_cells(const FieldView& before, const FieldView& after) {
  std::vector<std::uint32_t> changed;
  for (std::size_t entry = 0; entry < root_cells(after); ++entry) {
    if (before.root[entry] <= kInside && before.root[entry] == after.root[entry]) continue;
    for (std::size_t slot = 0; slot < kBricksPerNode; ++slot) {
      const auto cell = static_cast<std::uint32_t>(entry * kBricksPerNode + slot);
      const std::uint32_t a = brick_of(before, cell), b = brick_of(after, cell);
      bool same = (a <= kInside || b <= kInside) ? a == b : std::memcmp(coefficients(before, a), coefficients(after, b), kBrickBytes) == 0;
      if (same && b > kInside && after.stiffness_parts != nullptr) same = before.stiffness_parts[a] == after.stiffness_parts[b];
      if (!same) changed.push_back(cell);
    }
  }
  return changed;
}

std::vector<std::uint8_t> make_patch(const FieldView& before, const FieldView& after) {
  if (!on_one_grid(before.image, after.image)) {
    throw InputError("the fields differ in their grid, place, stiffness or method; a patch leads from a field to one on the same grid");
  }
  if (after.method != Method::kDefault) throw InputError("a field of the published method has no patches; send the whole field");
  const std::uint64_t hash_before = before.hash(), hash_after = after.hash();
  if (hash_before == hash_after) throw InputError("the fields are equal; there is nothing to patch");
  std::vector<std::uint8_t> patch = write_patch(hash_before, hash_after, after, changed_cells(before, after));
  if (!leads_to_it(patch, before)) throw InputError("the field after is not laid out as a patch needs it; build it with this program");
  return patch;
}

std::vector<std::uint8_t> write_patch(std::uint64_t hash_before, std::uint64_t hash_after, const FieldView& after,
                                      const std::vector<std::uint32_t>& cells) {
  std::vector<std::uint8_t> patch(kHeaderBytes + 4 * cells.size());
  std::vector<std::uint8_t> stiffness;
  std::uint32_t stored = 0;
  for (std::size_t n = 0; n < cells.size(); ++n) {
    const std::uint32_t brick = brick_of(after, cells[n]);
    store_le(&patch[kHeaderBytes + 4 * n], cells[n] << kKindBits | std::min(brick, kStored));
    if (brick <= kInside) continue;
    ++stored;
    const auto* bytes = reinterpret_cast<const std::uint8_t*>(coefficients(after, brick));
    patch.insert(patch.end(), bytes, bytes + kBrickBytes);
    if (after.stiffness_parts != nullptr) stiffness.push_back(after.stiffness_parts[brick]);
  }
  patch.insert(patch.end(), stiffness.begin(), stiffness.end());

  std::uint8_t* at = patch.data();
  store_le(at + kHashBeforeAt, hash_before);
  store_le(at + kHashAfterAt, hash_after);
  store_le(at + kCellsAt, static_cast<std::uint32_t>(cells.size()));
  store_le(at + kStoredAt, stored);
  std::copy_n(after.image.begin(), image_layout::kHeaderBytes, at + kImageHeaderAt);
  seal(kForm, patch);
  return patch;
}

}  // namespace isotouch::field_file
