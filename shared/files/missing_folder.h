/// Why no file can be made where its folder is missing: in one sentence, wherever a file or a socket is named.
#pragma once

#include <filesystem>
#include <string>
#include <system_error>

#include "shared/files/refusal.h"

namespace isotouch::files {

/// returns   why no file of this name can be made; none: its folder is there, or nobody may look, and then the system says so when the file is opened
inline Refusal refusal_of_missing_folder(const std::filesystem::path& file) {
  const std::filesystem::path folder = file.parent_path();
  std::error_code failed;
  if (folder.empty() || std::filesystem::is_directory(folder, failed)) return {};
  if (failed && failed != std::errc::no_such_file_or_directory && failed != std::errc::not_a_directory) return {};
  return file.string() + ": there is no folder " + folder.string() + "; make it, or name another one";
}

}  // namespace isotouch::files
