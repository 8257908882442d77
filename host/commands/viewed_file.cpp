#include "host/commands/viewed_file.h"

#include <algorithm>
#include <string>

#include "host/error.h"
#include "host/files/whole_file.h"
#include "shared/field_view.h"
#include "shared/packed_field.h"
#include "shared/trace.h"

namespace isotouch::commands {

Viewed viewed_file(const std::filesystem::path& file) {
  if (is_standard(file)) return Viewed::kSource;
  if (!std::filesystem::exists(file) || std::filesystem::is_directory(file))
    throw InputError(file.string() + ": cannot be read; name a field, a scan or a recording");
  const auto first = first_bytes(file);
  const auto begins_with = [&first](const auto& magic) { return std::equal(magic.begin(), magic.end(), first.begin()); };
  if (begins_with(trace_layout::kMagic)) return Viewed::kTrace;
  return begins_with(image_layout::kMagic) || begins_with(packed_layout::kForm.magic) ? Viewed::kField : Viewed::kSource;
}

}  // namespace isotouch::commands
