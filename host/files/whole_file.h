/// Whole files in and out.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <vector>

namespace isotouch {

/// All bytes of a regular file.
///
/// fails     InputError naming the file: missing, a folder, not readable
std::vector<std::uint8_t> read_file(const std::filesystem::path& file);

/// Writes to a temporary beside `file`, then renames: the old file or the new one, never half of one.
///
/// fails     InputError naming the file
void write_file(const std::filesystem::path& file, const std::uint8_t* data, std::size_t size);

}  // namespace isotouch
