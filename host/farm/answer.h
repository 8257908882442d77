/// What came out when a program replayed a recording, and the file that keeps it: one JSON object in ANSWERS/ab/cdef0123456789.json for the
/// address abcdef0123456789.
///
/// real time   no: these functions read files and wait for programs
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "host/farm/ended_program.h"
#include "host/farm/task.h"

namespace isotouch::farm {

struct Answer {
  enum class Outcome : std::uint8_t {
    kEqual,    ///< every bit is as recorded, and the hash is that of the table
    kDiffers,  ///< a bit differs from the recording, or the hash from the table
    kFailed,   ///< the program gave no answer; a later run tries again
  };
  Outcome outcome = Outcome::kFailed;
  std::uint64_t ticks = 0;
  double seconds = 0;                            ///< s, of the replay alone, as the program measured it
  std::string hash;                              ///< the replay hash, 16 hexadecimal digits; empty: failed
  std::optional<std::uint64_t> first_different;  ///< the first tick that differs, from 0; none: equal, failed, or the program names no tick
  std::string said;                              ///< why it failed, one printable line of at most 300 bytes; else empty
};

/// "equal", "differs" or "failed", as files and tables have it.
const char* name_of(Answer::Outcome outcome);

/// Lets a program replay a recording, and waits for it. The recording's files are compared with their hashes first.
///
/// patience  how long the program may take
/// fails     never: a failure is returned as kFailed, with its reason in `said`
Answer ask(const Recording& recording, const Program& program, const Patience& patience = {});

/// Writes an answer to its file below `answers`, with the names of host and kernel. The file is written whole or not at all, also if other machines keep
/// the same answer at the same time. A failure never replaces an answer.
///
/// fails     InputError naming the file or folder that cannot be written
void keep(const std::filesystem::path& answers, const Recording& recording, const Program& program, const Answer& answer);

/// The kept answer of a task; none: there is no file, or what it holds is no answer.
///
/// address   of address_of (task.h)
/// fails     InputError: the file is there and cannot be read
std::optional<Answer> kept_answer(const std::filesystem::path& answers, const std::string& address);

}  // namespace isotouch::farm
