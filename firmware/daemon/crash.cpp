#include "firmware/daemon/crash.h"

#include <signal.h>  // NOLINT(modernize-deprecated-headers): sigaction
#include <time.h>    // NOLINT(modernize-deprecated-headers): nanosleep

#include <initializer_list>

namespace isotouch::daemon {

namespace {

std::atomic<std::atomic<bool>*> device_must_rest{nullptr};  // a signal's handler is given nothing

void on_crash(int signal) {
  if (std::atomic<bool>* stop = device_must_rest.load()) {
    stop->store(true);
    const timespec moment{0, 50'000'000};
    nanosleep(&moment, nullptr);
  }
  raise(signal);  // with what the system does by default, see SA_RESETHAND
}

}  // namespace

RestOnCrash::RestOnCrash(std::atomic<bool>& stop) {
  device_must_rest = &stop;
  struct sigaction action {};
  action.sa_handler = on_crash;
  action.sa_flags = static_cast<int>(SA_RESETHAND | SA_ONSTACK);
  for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGSYS, SIGTRAP}) sigaction(signal, &action, nullptr);
}

RestOnCrash::~RestOnCrash() { device_must_rest = nullptr; }

}  // namespace isotouch::daemon
