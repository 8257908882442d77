/// A farm's tasks: every recording, replayed by every program. A recording names a field, a trace, and the replay hash that they give. A program is the core
/// of one commit, built by one compiler for one processor; it may run here, or under an emulator that is started like a program. Both tables have one JSON
/// object a line; docs/run-a-farm.md lists their keys.
///
/// real time   no
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "host/error.h"

namespace isotouch::farm {

/// A file or a folder, as it was when the table was made or read.
struct NamedFile {
  std::filesystem::path path;
  std::string hash;  ///< of hash_of
};

struct Recording {
  std::string name;        ///< unique in the table
  NamedFile field, trace;  ///< as seen from the current folder
  NamedFile patches;       ///< of a field that was patched meanwhile; no path: it was not
  std::string expected;    ///< the replay hash, 16 hexadecimal digits
  std::string device;      ///< the hash of the device's model
  std::string origin;      ///< who or what moved the hand
};

/// What a program is given: field, trace, and patches if there are any.
std::vector<NamedFile> files_of(const Recording& recording);

struct Program {
  std::string processor, commit, compiler, rung;
  std::vector<std::string> command;  ///< words; the names of the recording's files are added behind them
  std::string content;               ///< XXH64 over the words of the table and the hashes of `files`
  std::vector<NamedFile> files;      ///< files and folders that a word beginning with ./ names
};

/// Reads a table of recordings.
///
/// fails     InputError naming file and line: a value is missing or wrong, a name stands twice; or the table is empty or cannot be read
std::vector<Recording> read_recordings(const std::filesystem::path& file);

/// Reads a table of programs. No two may have the same processor, commit, compiler and rung. The table lists the oldest commit first, because the order
/// says since when something differs.
///
/// fails     InputError as read_recordings; also if a file of the command is not there, or if none of its words names a file by ./
std::vector<Program> read_programs(const std::filesystem::path& file);

/// Replays a trace in this program, and adds it to a table, with the hash that it gives. The table is made if there is none.
///
/// recording   name, origin and the paths of field and trace; the rest is found here, also the patches beside the trace
/// fails       InputError, and the table stays as it was: name or origin is missing or no UTF-8; a file cannot be read or does not fit, as in
///             `isotouch replay --check`; the replay differs from the recorded outputs; the name is in the table already; the table cannot be written
void add_recording(const std::filesystem::path& table, const Recording& recording);

/// The address under which the answer of a task is kept: an XXH64, 16 hexadecimal digits, over the hashes of the recording's files and of the program, the
/// expected hash, and processor, commit, compiler and rung. So a new build gets a new address. Files that the program opens, and an emulator that is not
/// beside the table, do not change it.
std::string address_of(const Recording& recording, const Program& program);

/// A recording that is in no table, with its hashes, the patches beside its trace, and the replay hash that the trace's own outputs have.
///
/// recording   the paths of field and trace
/// fails     InputError naming the file: it cannot be read, is cut off or damaged, the trace has no outputs, no ticks or no beginning, or another field
Recording as_recorded(Recording recording);

/// fails     InputError naming the file: it cannot be read, or is not the one that was added to the table
void require_same(const NamedFile& file);

/// XXH64 of a file's bytes, or of the names and bytes of all files below a folder, 16 hexadecimal digits.
///
/// fails     InputError naming the file: it cannot be read
std::string hash_of(const std::filesystem::path& file);

}  // namespace isotouch::farm
