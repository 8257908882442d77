/// The last resort: when a thread of the program crashes, the device is left without force before the program ends.
#pragma once

#include <atomic>

namespace isotouch::daemon {

/// As long as it lives, a crash (SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT) sets `stop` and gives the thread that serves the device 50 ms to leave it
/// without force, before the program ends as it would have. A crash of that very thread helps nobody: then the device's own time limit has to do. A
/// thread that uses up its stack gets there only with a second one, `loop::keep_crash_stack`. One at a time.
class RestOnCrash {
 public:
  /// stop      lives longer
  explicit RestOnCrash(std::atomic<bool>& stop);
  ~RestOnCrash();
  RestOnCrash(const RestOnCrash&) = delete;
  RestOnCrash& operator=(const RestOnCrash&) = delete;
};

}  // namespace isotouch::daemon
