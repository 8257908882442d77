#include "host/files/file_nature.h"

#include <algorithm>
#include <string_view>

#include "host/files/whole_file.h"
#include "shared/field_patch.h"
#include "shared/field_view.h"
#include "shared/packed_field.h"
#include "shared/trace.h"

namespace isotouch {

FileNature nature_of(std::span<const std::uint8_t> bytes) {
  const auto begins_with = [&](const auto& magic) {
    return bytes.size() >= magic.size() &&
           std::equal(magic.begin(), magic.end(), bytes.begin(), [](auto a, auto b) { return static_cast<std::uint8_t>(a) == b; });
  };
  if (begins_with(image_layout::kMagic) || PackedField::has_magic(bytes)) return FileNature::kField;
  if (FieldPatch::has_magic(bytes)) return FileNature::kPatches;
  if (begins_with(trace_layout::kMagic)) return FileNature::kTrace;
  if (begins_with(std::string_view("version https://git-lfs.github.com/spec/"))) return FileNature::kPointer;
  return FileNature::kUnknown;
}

FileNature nature_of(const std::filesystem::path& file) { return nature_of(first_bytes(file)); }

}  // namespace isotouch
