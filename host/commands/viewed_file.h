/// What a file is for `isotouch view`, by its first bytes.
#pragma once

#include <filesystem>

namespace isotouch::commands {

enum class Viewed {
  kField,
  kTrace,
  kSource,  ///< anything else: to be built from, or refused by the build
};

/// fails     InputError naming the file: it cannot be read
Viewed viewed_file(const std::filesystem::path& file);

}  // namespace isotouch::commands
