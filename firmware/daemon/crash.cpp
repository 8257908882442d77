#include "firmware/daemon/crash.h"

#include <signal.h>  // NOLINT(modernize-deprecated-headers): sigaction
#include <time.h>    // NOLINT(modernize-deprecated-headers): nanosleep

#include <initializer_list>

namespace isotouch::daemon {

namespace {

std::atomic<bool>* device_must_rest = nullptr;

void on_crash(int signal) {
  device_must_rest->store(true);
  const timespec moment{0, 50'000'000};
  nanosleep(&moment, nullptr);
  raise(signal);  // with what the system does by default, see SA_RESETHAND
}

}  // namespace

void rest_on_crash(std::atomic<bool>& stop) {
  device_must_rest = &stop;
  struct sigaction action {};
  action.sa_handler = on_crash;
  action.sa_flags = static_cast<int>(SA_RESETHAND | SA_ONSTACK);
  for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT}) sigaction(signal, &action, nullptr);
}

}  // namespace isotouch::daemon
