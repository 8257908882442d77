#include "hil/falcon_sim/event_loop.h"

#include <algorithm>
#include <csignal>
#include <cstdint>
#include <optional>

namespace isotouch::falcon_sim {

namespace {

volatile std::sig_atomic_t end_asked = 0;

void ask_end(int) { end_asked = 1; }

sigset_t end_signals() {
  sigset_t set;
  sigemptyset(&set);
  sigaddset(&set, SIGINT);
  sigaddset(&set, SIGTERM);
  return set;
}

}  // namespace

void catch_end_signals() {
  struct sigaction action {};
  action.sa_handler = ask_end;
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  const sigset_t set = end_signals();  // let in only while waiting, so that none slips in between
  sigprocmask(SIG_BLOCK, &set, nullptr);
}

void serve_frontends(const std::vector<std::unique_ptr<Frontend>>& frontends) {
  sigset_t waiting;
  sigprocmask(SIG_BLOCK, nullptr, &waiting);
  sigdelset(&waiting, SIGINT);
  sigdelset(&waiting, SIGTERM);
  std::vector<pollfd> wanted;
  while (end_asked == 0) {
    wanted.clear();
    std::optional<Time> due;
    for (const auto& frontend : frontends) {
      frontend->wait_for(wanted);
      const auto time = frontend->due();
      if (time && (!due || *time < *due)) due = time;
    }
    timespec left{};
    if (due) {
      const auto ns = std::max<std::int64_t>(0, std::chrono::nanoseconds(*due - std::chrono::steady_clock::now()).count());
      left.tv_sec = static_cast<time_t>(ns / 1'000'000'000);
      left.tv_nsec = static_cast<long>(ns % 1'000'000'000);
    }
    ppoll(wanted.data(), wanted.size(), due ? &left : nullptr, &waiting);
    for (const auto& frontend : frontends) frontend->serve(std::chrono::steady_clock::now());
  }
}

}  // namespace isotouch::falcon_sim
