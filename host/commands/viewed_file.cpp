#include "host/commands/viewed_file.h"

#include <string>

#include "host/error.h"
#include "host/files/file_nature.h"
#include "host/files/whole_file.h"

namespace isotouch::commands {

Viewed viewed_file(const std::filesystem::path& file) {
  if (is_standard(file)) return Viewed::kSource;
  if (!std::filesystem::exists(file) || std::filesystem::is_directory(file))
    throw InputError(file.string() + ": cannot be read; name a field, a scan or a recording");
  const FileNature nature = nature_of(file);
  if (nature == FileNature::kTrace) return Viewed::kTrace;
  return nature == FileNature::kField ? Viewed::kField : Viewed::kSource;
}

}  // namespace isotouch::commands
