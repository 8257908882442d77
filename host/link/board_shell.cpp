#include "host/link/board_shell.h"

#include <poll.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <string_view>
#include <utility>
#include <vector>

#include "host/error.h"
#include "host/link/child.h"

namespace isotouch::link {

namespace {

constexpr std::string_view kEnded = "\nisotouch: ended ";  ///< a line that no command of ours prints: of which command, and its status

}  // namespace

BoardShell::BoardShell(const Address& address, std::function<bool()> is_over)
    : text_(address.text), is_remote_(address.is_remote()), is_over_(std::move(is_over)) {
  std::vector<std::string> command = {"sh"};
  if (is_remote_) command = ssh_command(address, ssh_program(), "sh");
  // A group of its own only here: ssh must be able to ask the terminal for a password.
  stream_ = run_child(std::move(command), text_, child_, static_cast<bool>(is_over_), leads_group());
}

BoardShell::~BoardShell() {
  ::close(stream_);
  ::kill(leads_group() ? -child_ : child_, SIGTERM);  // with the command that it may still wait for
  ::waitpid(child_, nullptr, 0);
}

void BoardShell::send(const std::string& lines) {
  for (std::size_t sent = 0; sent < lines.size();) {
    const ssize_t taken = ::send(stream_, lines.data() + sent, lines.size() - sent, MSG_NOSIGNAL);
    if (taken < 0 && errno == EINTR) continue;
    if (taken < 0) complain_of_the_end();
    sent += static_cast<std::size_t>(taken);
  }
}

void BoardShell::complain_of_the_end() const {
  throw InputError(text_ + ": " + (is_remote_ && !has_answered_ ? "no shell could be started there" : "the shell there has ended") +
                   (is_remote_ ? "; see the messages of ssh" : "; check what ends programs here, and try again"));
}

void BoardShell::at_end(const std::string& command) {
  // Each signal does it by itself, because one may come while another is served; PIPE is what an answer nobody hears any more brings.
  std::string quoted;
  for (const char c : command) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  send("trap '" + quoted + "' EXIT\ntrap '" + quoted + "\nexit 1' HUP INT PIPE TERM\n");
}

BoardShell::Answer BoardShell::run(const std::string& command, double patience_s) {
  using Clock = std::chrono::steady_clock;
  // A command that is ended ends by itself: of one that a signal ends, the shell would complain at our terminal.
  send("(\ntrap 'exit 1' TERM\n" + command + "\n) </dev/null 2>&1; printf '\\nisotouch: ended " + std::to_string(++commands_) +
       " %d\\n' $?\n");
  const auto end = Clock::now() + std::chrono::duration<double>(patience_s);
  for (;;) {
    const auto mark = unread_.find(kEnded);
    const auto last = mark == std::string::npos ? mark : unread_.find('\n', mark + kEnded.size());
    if (last != std::string::npos) {
      char* after = nullptr;
      const bool is_late = std::strtoull(unread_.c_str() + mark + kEnded.size(), &after, 10) != commands_;  // nobody waits for it any more
      const Answer answer{std::atoi(after), unread_.substr(0, mark)};
      unread_.erase(0, last + 1);
      has_answered_ = true;
      if (is_late) continue;
      return answer;
    }
    if (is_over_ && is_over_()) throw InputError(text_ + ": nobody waits any more for what a command there finds");
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end - Clock::now()).count();
    pollfd one{stream_, POLLIN, 0};
    // Not for all that is left: a signal may come just before.
    const int ready = left <= 0 ? 0 : ::poll(&one, 1, static_cast<int>(std::min<std::int64_t>(left, 100)));
    if ((ready == 0 && left > 0) || (ready < 0 && errno == EINTR)) continue;
    if (ready <= 0) throw InputError(text_ + ": a command there has not ended in time; see how busy the board is");
    char more[4096];
    const ssize_t size = ::recv(stream_, more, sizeof more, 0);
    if (size < 0 && errno == EINTR) continue;
    if (size <= 0) complain_of_the_end();
    unread_.append(more, static_cast<std::size_t>(size));
  }
}

}  // namespace isotouch::link
