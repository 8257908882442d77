/// A program that was run to its end.
#pragma once

#include <string>
#include <vector>

namespace isotouch::farm {

struct EndedProgram {
  int code = 0;                     ///< its exit code; 128 and the signal that ended it
  std::string printed, complained;  ///< standard output and standard error
};

/// Starts words[0], found as a shell finds it, without standard input, and waits for its end.
///
/// fails     InputError: it cannot be started
EndedProgram run_program(std::vector<std::string> words);

}  // namespace isotouch::farm
