/// A program whose input and output are one end of a pair of sockets.
#pragma once

#include <sys/types.h>

#include <string>
#include <vector>

namespace isotouch::link {

/// Runs it; what it complains of goes to our standard error.
///
/// command   the program, found on the PATH, and its arguments
/// text      what it is run for, begins the sentence when it cannot be
/// child     gets its process
/// is_deaf   it ignores what a terminal sends to all of its programs: Ctrl-C, and that the terminal is gone
/// leads_group  a signal to its group reaches what it runs, and none of a terminal does; it cannot ask the terminal anything
/// returns   the other end
/// fails     InputError
int run_child(std::vector<std::string> command, const std::string& text, pid_t& child, bool is_deaf = false, bool leads_group = false);

/// The program that reaches remote machines: ISOTOUCH_SSH of the environment, or else ssh.
std::string ssh_program();

}  // namespace isotouch::link
