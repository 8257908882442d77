/// Ctrl-C, SIGTERM, or the end of the terminal, as the wish to end well.
#pragma once

#include <array>
#include <csignal>
#include <cstddef>

namespace isotouch::commands {

/// As long as this lives the first signal is only noted, and the second one ends the program at once. One at a time.
class Interruption {
 public:
  Interruption() {
    came_ = 0;
    struct sigaction note {};
    note.sa_handler = [](int) { came_ = 1; };
    note.sa_flags = static_cast<int>(SA_RESETHAND);
    for (std::size_t i = 0; i < kSignals.size(); ++i) {
      sigaction(kSignals[i], nullptr, &before_[i]);
      if (before_[i].sa_handler != SIG_IGN) sigaction(kSignals[i], &note, nullptr);  // nohup, and a shell's background: it stays ignored
    }
  }
  Interruption(const Interruption&) = delete;
  Interruption& operator=(const Interruption&) = delete;
  ~Interruption() {
    for (std::size_t i = 0; i < kSignals.size(); ++i) sigaction(kSignals[i], &before_[i], nullptr);
  }

  bool has_come() const { return came_ != 0; }

 private:
  static constexpr std::array<int, 3> kSignals = {SIGINT, SIGTERM, SIGHUP};
  inline static volatile std::sig_atomic_t came_ = 0;
  std::array<struct sigaction, kSignals.size()> before_{};
};

}  // namespace isotouch::commands
