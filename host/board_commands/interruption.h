/// Ctrl-C, or SIGTERM, as the wish to end well.
#pragma once

#include <csignal>

namespace isotouch::commands {

/// As long as this lives the first signal is only noted, and the second one ends the program at once. One at a time.
class Interruption {
 public:
  Interruption() {
    came_ = 0;
    struct sigaction note {};
    note.sa_handler = [](int) { came_ = 1; };
    note.sa_flags = static_cast<int>(SA_RESETHAND);
    sigaction(SIGINT, &note, &interrupt_);
    sigaction(SIGTERM, &note, &terminate_);
  }
  Interruption(const Interruption&) = delete;
  Interruption& operator=(const Interruption&) = delete;
  ~Interruption() {
    sigaction(SIGINT, &interrupt_, nullptr);
    sigaction(SIGTERM, &terminate_, nullptr);
  }

  bool has_come() const { return came_ != 0; }

 private:
  inline static volatile std::sig_atomic_t came_ = 0;
  struct sigaction interrupt_ {
  }, terminate_{};
};

}  // namespace isotouch::commands
