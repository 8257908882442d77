/// Patches for tests of whoever has no host.
#pragma once

#include <cstdint>
#include <vector>

#include "shared/field_view.h"

namespace isotouch::test {

/// As field_file::make_patch.
std::vector<std::uint8_t> make_patch(const FieldView& before, const FieldView& after);

}  // namespace isotouch::test
