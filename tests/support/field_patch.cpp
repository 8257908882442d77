#include "tests/support/field_patch.h"

#include "host/field_file/make_patch.h"

namespace isotouch::test {

std::vector<std::uint8_t> make_patch(const FieldView& before, const FieldView& after) { return field_file::make_patch(before, after); }

}  // namespace isotouch::test
