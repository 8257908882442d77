/// What signals do to the program. Each that would end or stop it by default ends it in order instead, and leaves motor commands of zero: a program that
/// stands still with a force on, as after Ctrl-Z, is no better than one that is gone. Not SIGKILL and SIGSTOP, which nobody can hear, and not those of
/// a crash (crash.h).
#pragma once

#include <signal.h>  // NOLINT(modernize-deprecated-headers): sigset_t

#include <initializer_list>

namespace isotouch::daemon {

/// Every thread blocks these.
inline sigset_t blocked_signals() {
  sigset_t signals;
  sigfillset(&signals);
  for (const int of_a_crash : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGSYS, SIGTRAP}) sigdelset(&signals, of_a_crash);
  return signals;
}

/// Those of them that end it. The others tell of what a call tells, too, by its error, or of nothing that ends a program by default.
inline sigset_t ending_signals() {
  sigset_t signals = blocked_signals();
  for (const int other : {SIGPIPE, SIGXFSZ, SIGTTIN, SIGTTOU, SIGCHLD, SIGCONT, SIGURG, SIGWINCH}) sigdelset(&signals, other);
  return signals;
}

/// Those by which a person or the system asks for the end. Any other one nobody sends on purpose, such as SIGXCPU at a limit of processor time.
inline bool asks_for_the_end(int signal) {
  return signal == SIGTERM || signal == SIGINT || signal == SIGHUP || signal == SIGQUIT || signal == SIGTSTP;
}

}  // namespace isotouch::daemon
