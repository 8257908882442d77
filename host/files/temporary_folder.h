/// A folder for what is made on the way, gone with its owner.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <string>
#include <system_error>

#include "host/error.h"

namespace isotouch {

/// Makes a folder that nobody else has, below TMPDIR.
///
/// fails     InputError when it cannot be made
inline std::filesystem::path make_temporary_folder() {
  std::string pattern = (std::filesystem::temp_directory_path() / "isotouch-XXXXXX").string();
  if (::mkdtemp(pattern.data()) == nullptr) throw InputError(pattern + ": no folder can be made there; free space, or set TMPDIR");
  return pattern;
}

struct TemporaryFolder {
  std::filesystem::path path = make_temporary_folder();

  TemporaryFolder() = default;
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
};

}  // namespace isotouch
