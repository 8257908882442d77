/// Runs another program to its end.
///
/// real time   no: it waits for the program
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace isotouch::farm {

/// How long a program may run.
struct Patience {
  double seconds = 0;                                     ///< s; 0: without a limit
  std::function<bool()> may_go_on = [] { return true; };  ///< asked every 100 ms; false: the program is ended
};

struct EndedProgram {
  int code = 0;                     ///< its exit code; 128 plus the number of the signal that ended it
  std::string printed, complained;  ///< standard output and standard error; empty if it was stopped
  std::string stopped;              ///< why it was killed, in words; empty: it ended by itself
};

/// Starts a program without standard input, and waits for its end. If it takes longer than patience allows, or prints more than 16 MB to one output, it is
/// killed. What it has started and left behind is killed in any case, unless it left the process group. If this program itself is killed by SIGKILL, nobody
/// ends them.
///
/// words     the program, searched for in PATH as a shell does, and its arguments; at least one
/// fails     InputError: the program cannot be started, or no memory or no descriptor is left for what it prints and for its end
EndedProgram run_program(std::vector<std::string> words, const Patience& patience = {});

}  // namespace isotouch::farm
