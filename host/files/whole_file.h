/// Whole files in and out. The name `-` stands for standard input where a file is read, and for standard output where one is written; a file of that
/// name is `./-`.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string_view>
#include <vector>

namespace isotouch {

/// Is it standard input or output that is meant?
inline bool is_standard(const std::filesystem::path& file) { return file == "-"; }

/// Standard input can be read once: whoever reads it by another way than `read_file` says so.
///
/// fails     InputError when it was claimed before, or is closed
void claim_standard_input();

/// All bytes of a file, a pipe, or standard input.
///
/// fails     InputError naming the file: missing, a folder, not readable; standard input for the second time
std::vector<std::uint8_t> read_file(const std::filesystem::path& file);

/// The first bytes of a file, by which its kind is known; zeros where there are none. A pipe gives its bytes only once, so it is left alone and gives zeros,
/// and so does a file that cannot be read.
std::array<std::uint8_t, 48> first_bytes(const std::filesystem::path& file);

/// Writes to a temporary beside `file`, syncs, then renames: the old file or the new one, never half of one, whatever ends the program or the power. A
/// symbolic link stays, and what it leads to is replaced; the new file has the access rights of the old one (`shared/files/part_file.h`). What is no regular
/// file, or open in this program as /dev/stdout is, is written as it is.
///
/// fails     InputError naming the file; also where the old one may not be written
void write_file(const std::filesystem::path& file, const std::uint8_t* data, std::size_t size);
/// The same of a text.
void write_file(const std::filesystem::path& file, std::string_view text);

}  // namespace isotouch
