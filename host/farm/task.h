/// What a farm does: every recording by every program. A recording names a field, a trace, and the replay hash that they give. A program replays them: the
/// core as one commit has it, by one compiler, for one processor, here or on something that is started like a program. Both tables have one JSON object a
/// line; docs/run-a-farm.md lists their keys.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace isotouch::farm {

struct Recording {
  std::string name;  ///< no two have the same
  std::filesystem::path field, trace;
  std::string field_hash;  ///< XXH64 of the file, 16 hexadecimal digits
  std::string trace_hash;  ///< the same of the trace
  std::string expected;    ///< the replay hash
  std::string device;      ///< the device's model, in a word
  std::string origin;      ///< who or what moved the hand
};

struct Program {
  std::string processor, commit, compiler, rung;
  std::vector<std::string> command;  ///< words; FIELD and TRACE follow
  std::string content;  ///< XXH64 over its words and over the bytes of each that begins with ./, which is a file beside the table
};

/// fails     InputError naming file and line: a value that is missing or wrong, a name that stands twice; no line at all
std::vector<Recording> read_recordings(const std::filesystem::path& file);

/// The same; of two programs at least processor, commit, compiler or rung differ. Oldest commit first: the order says since when something differs.
///
/// fails     also InputError: a program that is not there, or that no word beginning with ./ names
std::vector<Program> read_programs(const std::filesystem::path& file);

/// Replays a trace here, and adds it with the hash that it gives as a line to a table; the table is made where there is none.
///
/// recording   its hashes and device are found out; its files as seen from here
/// fails       InputError: no name or origin, or one that is no UTF-8; files as `isotouch replay --check` refuses them, a trace that does not answer as recorded, a name that stands there already
void add_recording(const std::filesystem::path& table, const Recording& recording);

/// Where the answer of a task is kept: it names the bytes of field, trace and program, so an answer is not taken for that of another build. What the
/// program calls, and an emulator that is not beside the table, do not count.
std::string address_of(const Recording& recording, const Program& program);

/// The replay hash that a trace's own outputs have.
///
/// fails     InputError naming the file: also where it has no outputs or no ticks
std::string recorded_hash(const std::filesystem::path& file);

/// XXH64 of a file's bytes, 16 hexadecimal digits.
///
/// fails     InputError naming the file
std::string hash_of_file(const std::filesystem::path& file);

}  // namespace isotouch::farm
