/// The patches of a recording (SPEC.md, section 3.2): a field, and what becomes of it patch by patch, in memory of the caller's.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "shared/field_patch.h"
#include "shared/field_view.h"
#include "shared/result.h"

namespace isotouch {

/// What a file of patches holds.
struct Patches {
  std::size_t count = 0;
  std::size_t largest_image = 0;  ///< bytes, of all the images after
};

/// Checks each patch by itself, and that each follows the one before.
///
/// bytes     of the file; none is a file without patches
/// field     that the first patch is for. No image is then larger than this one and what the patches so far can add: a node for each cell that they name
///           and a brick for each that they store
/// fails     as FieldPatch::parse; kTruncated also for a last patch that is cut; kOtherField: a patch does not follow, or is for another grid; kBadSize: the
///           header of an image after counts more nodes or bricks than its patch can lead to
/// tick      no
Result<Patches> check_patches(std::span<const std::uint8_t> bytes, const FieldView& field);

/// The same where only the hash of the field is known: what the first patch says of the size of its image is then believed.
Result<Patches> check_patches(std::span<const std::uint8_t> bytes, std::uint64_t field);

/// The patch at the front of a file of patches, checked by itself. The next one begins behind `FieldPatch::patch_bytes()`.
///
/// fails     as FieldPatch::parse
/// tick      no
Result<FieldPatch> first_patch(std::span<const std::uint8_t> bytes);

class PatchChain {
 public:
  /// field     of the recording; lives longer
  /// bytes     of the file, as `check_patches` takes them; live longer
  /// memory    8-byte aligned, each place with `Patches::largest_image` bytes
  PatchChain(const FieldView& field, std::span<const std::uint8_t> bytes, const std::array<std::span<std::uint8_t>, 2>& memory)
      : view_(field), left_(bytes), memory_(memory) {}

  /// As it is now: the first one, or the image after the last patch that was applied.
  const FieldView& field() const { return view_; }

  /// Applies the next patch. Where none is left, a tick that leads to the field that is there needs none: a controller's file of a fault may begin with one.
  ///
  /// moved_to  Input::moved_to of the tick that takes it over
  /// fails     kNoPatches (none is left), kOtherField (it does not lead there), and as FieldPatch::parse, `apply` and FieldView::parse; the field is then
  ///           the one before
  /// tick      no: it writes a whole image. It allocates nothing
  Result<void> advance(std::uint32_t moved_to);

 private:
  FieldView view_;
  std::span<const std::uint8_t> left_;
  std::array<std::span<std::uint8_t>, 2> memory_;
  std::size_t next_ = 0;  ///< place
};

}  // namespace isotouch
