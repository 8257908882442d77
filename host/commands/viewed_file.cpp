#include "host/commands/viewed_file.h"

#include <array>
#include <cstdint>
#include <fstream>
#include <string>

#include "host/error.h"
#include "host/files/whole_file.h"
#include "shared/field_view.h"
#include "shared/packed_field.h"
#include "shared/trace.h"

namespace isotouch::commands {

Viewed viewed_file(const std::filesystem::path& file) {
  if (is_standard(file)) return Viewed::kSource;
  std::array<std::uint8_t, 4> first{};
  std::ifstream stream(file, std::ios::binary);
  if (!stream || std::filesystem::is_directory(file))
    throw InputError(file.string() + ": cannot be read; name a field, a scan or a recording");
  stream.read(reinterpret_cast<char*>(first.data()), first.size());
  if (first == trace_layout::kMagic) return Viewed::kTrace;
  return first == image_layout::kMagic || first == packed_layout::kForm.magic ? Viewed::kField : Viewed::kSource;
}

}  // namespace isotouch::commands
