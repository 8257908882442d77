/// A folder for what is made on the way, gone with its owner.
#pragma once

#include <unistd.h>

#include <filesystem>
#include <string>
#include <system_error>

#include "host/error.h"

namespace isotouch::commands {

struct TemporaryFolder {
  std::filesystem::path path = std::filesystem::temp_directory_path() / ("isotouch-" + std::to_string(::getpid()));

  /// fails     InputError when it cannot be made
  TemporaryFolder() {
    std::error_code error;
    std::filesystem::create_directories(path, error);
    if (error) throw InputError(path.string() + ": cannot be made: " + error.message() + "; set TMPDIR to a folder that can be written");
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
};

}  // namespace isotouch::commands
