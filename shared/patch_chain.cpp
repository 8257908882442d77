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

Result<Patches> check_patches(std::span<const std::uint8_t> bytes, std::uint64_t field) {
  Patches found;
  for (std::span<const std::uint8_t> left = bytes; !left.empty();) {
    const Result<FieldPatch> patch = first_patch(left);
    if (!patch) return patch.error();
    if (patch->hash_before != field) return Error::kOtherField;
    field = patch->hash_after;
    ++found.count;
    found.largest_image = std::max(found.largest_image, patch->image_bytes());
    left = left.subspan(patch->patch_bytes());
  }
  return found;
}

Result<void> PatchChain::advance(std::uint32_t moved_to) {
  if (left_.empty()) return Error::kNoPatches;
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
