/// Those by which a person or the system ends the program: it then leaves motor commands of zero. A terminal that is closed is one of them.
#pragma once

#include <signal.h>  // NOLINT(modernize-deprecated-headers): sigset_t

#include <initializer_list>

namespace isotouch::daemon {

inline sigset_t ending_signals() {
  sigset_t signals;
  sigemptyset(&signals);
  for (const int signal : {SIGTERM, SIGINT, SIGHUP, SIGQUIT}) sigaddset(&signals, signal);
  return signals;
}

}  // namespace isotouch::daemon
