/// What came out when a program replayed a recording, and the file that keeps it, one JSON object. For the address abcdef0123456789 these are, below ANSWERS,
///
///     ab/cdef0123456789.json                  an answer that is equal
///     ab/cdef0123456789.differs/HASH-TICK.json    one that differs: its replay hash, and the first tick if the program names it
///     ab/cdef0123456789.failed.json           a failure
///
/// So whoever copies the answers of two machines into one folder loses none that says something else.
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
    kEqual,        ///< every bit is as recorded, and the hash is that of the table
    kDiffers,      ///< a bit differs from the recording, or the hash from the table
    kContradicts,  ///< the same program gave several answers, and `said` names the machines; only of kept answers
    kFailed,       ///< the program gave no answer; a later run tries again
  };
  Outcome outcome = Outcome::kFailed;
  std::uint64_t ticks = 0;
  double seconds = 0;                            ///< s, of the replay alone, as the program measured it
  std::string hash;                              ///< the replay hash, 16 hexadecimal digits; empty: failed, or several
  std::optional<std::uint64_t> first_different;  ///< the first tick that differs, from 0; none: equal, failed, or the program names no tick
  std::string said;                              ///< why it failed or contradicts, one printable line of at most 300 bytes; else empty
  std::string host;                              ///< the machine that kept it; empty: not kept
};

/// "equal", "differs", "contradicts" or "failed", as files and tables have it.
const char* name_of(Answer::Outcome outcome);

/// Lets a program replay a recording, and waits for it. The recording's files are compared with their hashes first, the program's files afterwards: a new
/// build that takes their place meanwhile gets no answer under the old one's name.
///
/// patience  how long the program may take
/// fails     never: a failure is returned as kFailed, with its reason in `said`
Answer ask(const Recording& recording, const Program& program, const Patience& patience = {});

/// Writes an answer to its file below `answers`, with the names of host and kernel. The file is written whole or not at all, also if other machines keep
/// the same answer at the same time. It replaces only an answer with the same outcome, hash and tick.
///
/// fails     InputError naming the file or folder that cannot be written
void keep(const std::filesystem::path& answers, const Recording& recording, const Program& program, const Answer& answer);

/// The kept answer of a task; none: there is no file, or what it holds contradicts itself or is no answer. A failure counts only without any other answer.
///
/// fails     InputError: a file is there and cannot be read, or nobody can say whether one is there; or it has the name of an answer that differs and holds
///           none, as after a copy that was interrupted, because somebody's answer differs all the same
std::optional<Answer> kept_answer(const std::filesystem::path& answers, const Recording& recording, const Program& program);

}  // namespace isotouch::farm
