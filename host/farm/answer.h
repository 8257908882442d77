/// What a program said of a recording, and where that is kept: one JSON object in ANSWERS/ab/cdef0123456789.json for the address abcdef0123456789.
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
    kEqual,    ///< to what was recorded and to the table, every bit
    kDiffers,  ///< from one of them
    kFailed,   ///< it gave no answer; a later run tries again
  };
  Outcome outcome = Outcome::kFailed;
  std::uint64_t ticks = 0;
  double seconds = 0;                            ///< of the replay alone, as the program measured it
  std::string hash;                              ///< empty: it failed
  std::optional<std::uint64_t> first_different;  ///< tick
  std::string said;                              ///< one line; empty: nothing
};

const char* name_of(Answer::Outcome outcome);

/// Runs a program over a recording, whose files are compared with their hashes before.
///
/// fails     never: what goes wrong is the answer
Answer ask(const Recording& recording, const Program& program, const Patience& patience = {});

/// Keeps an answer with host and kernel: the whole of it or nothing. A failure does not take the place of an answer.
///
/// fails     InputError naming the file
void keep(const std::filesystem::path& answers, const Recording& recording, const Program& program, const Answer& answer);

/// The kept answer of a task. A file that is no answer counts as none.
std::optional<Answer> kept_answer(const std::filesystem::path& answers, const std::string& address);

}  // namespace isotouch::farm
