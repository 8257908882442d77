#include "shared/patch_chain.h"

#include <algorithm>

#include "shared/bytes.h"

namespace isotouch {

Result<FieldPatch> first_patch(std::span<const std::uint8_t> bytes) {
  using namespace patch_layout;
  if (bytes.size() < kHeaderBytes)
    return FieldPatch::has_magic(bytes) || bytes.size() < kForm.magic.size() ? Error::kTruncated : Error::kBadMagic;
  const auto size = load_le<std::uint64_t>(bytes.data() + kTotalBytesAt);
  return FieldPatch::parse(bytes.first(static_cast<std::size_t>(std::min<std::uint64_t>(size, bytes.size()))));
}

namespace {

/// What is known of an image: its hash, and maybe its header and what this says.
struct Known {
  std::uint64_t hash = 0;
  std::span<const std::uint8_t> header;
  std::uint64_t nodes = 0, bricks = 0;
};

Result<void> check_step(const Known& before, const FieldPatch& patch) {
  if (patch.hash_before != before.hash) return Error::kOtherField;
  if (before.header.empty()) return {};
  if (!on_one_grid(before.header, patch.image_header)) return Error::kOtherField;
  const std::uint64_t nodes = patch.cells.size() / 4, bricks = patch.bricks.size() / patch_layout::kBrickBytes;
  if (patch.after.node_count > before.nodes + nodes || patch.after.brick_count > before.bricks + bricks) return Error::kBadSize;
  return {};
}

Result<Patches> check_all(std::span<const std::uint8_t> bytes, Known before) {
  Patches found;
  for (std::span<const std::uint8_t> left = bytes; !left.empty();) {
    const Result<FieldPatch> patch = first_patch(left);
    if (!patch) return patch.error();
    if (const auto step = check_step(before, *patch); !step) return step.error();
    before = {patch->hash_after, patch->image_header, patch->after.node_count, patch->after.brick_count};
    ++found.count;
    found.largest_image = std::max(found.largest_image, patch->image_bytes());
    left = left.subspan(patch->patch_bytes());
  }
  return found;
}

}  // namespace

Result<Patches> check_patches(std::span<const std::uint8_t> bytes, const FieldView& field) {
  return check_all(bytes, {field.hash(), field.image, field.node_count, field.brick_count});
}

Result<Patches> check_patches(std::span<const std::uint8_t> bytes, std::uint64_t field) { return check_all(bytes, {field, {}}); }

Result<void> PatchChain::advance(std::uint32_t moved_to) {
  if (left_.empty()) {
    if (static_cast<std::uint32_t>(view_.hash()) == moved_to) return {};
    return Error::kNoPatches;
  }
  const Result<FieldPatch> patch = first_patch(left_);
  if (!patch) return patch.error();
  if (static_cast<std::uint32_t>(patch->hash_after) != moved_to) return Error::kOtherField;
  if (patch->image_bytes() > memory_[next_].size()) return Error::kBadSize;
  const auto image = apply(*patch, view_, memory_[next_].first(patch->image_bytes()));
  if (!image) return image.error();
  const Result<FieldView> view = FieldView::parse(*image);
  if (!view) return view.error();
  view_ = *view;
  left_ = left_.subspan(patch->patch_bytes());
  next_ = 1 - next_;
  return {};
}

}  // namespace isotouch
