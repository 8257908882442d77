/// A program that was run to its end.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace isotouch::farm {

/// How long a program may run, and how much it may print.
struct Patience {
  double seconds = 0;  ///< 0: as long as it wants
  std::function<bool()> may_go_on = [] { return true; };
};

struct EndedProgram {
  int code = 0;                     ///< its exit code; 128 and the signal that ended it
  std::string printed, complained;  ///< standard output and standard error
  std::string stopped;              ///< why it was not waited for, in words; empty: it ended by itself
};

/// Starts words[0], found as a shell finds it, without standard input, and waits for its end. When patience ends, or when it prints more than 16 MB, it is
/// killed with all that it has started.
///
/// fails     InputError: it cannot be started
EndedProgram run_program(std::vector<std::string> words, const Patience& patience = {});

}  // namespace isotouch::farm
