/// The patch between two images on one grid (SPEC.md, section 7).
#pragma once

#include <cstdint>
#include <vector>

#include "shared/field_view.h"

namespace isotouch::field_file {

/// The cells in which two images differ, rising, as section 7 of SPEC.md counts them.
///
/// before, after     on one grid
std::vector<std::uint32_t> changed_cells(const FieldView& before, const FieldView& after);

/// The patch from one image to the other.
///
/// after     canonical, as every image that this program builds
/// fails     InputError when the images are equal, not on one grid or built by the published method, or `after` is not canonical
std::vector<std::uint8_t> make_patch(const FieldView& before, const FieldView& after);

/// The same for whoever knows already what has changed.
///
/// hash_before   of the image before, which is on the grid of `after`
/// hash_after    of `after`
/// cells         rising; exactly those in which the images differ
std::vector<std::uint8_t> write_patch(std::uint64_t hash_before, std::uint64_t hash_after, const FieldView& after,
                                      const std::vector<std::uint32_t>& cells);

}  // namespace isotouch::field_file
