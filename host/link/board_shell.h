/// A shell on the machine where a controller runs: here, or over one ssh connection that is kept, so that what is asked while ticks are measured costs
/// no new handshake.
#pragma once

#include <sys/types.h>

#include <functional>
#include <string>

#include "host/link/address.h"

namespace isotouch::link {

class BoardShell {
 public:
  /// is_over   asked while a command is waited for: nobody waits any more. Then Ctrl-C does not end the shell, either
  /// fails     InputError: what is not there and what to do
  explicit BoardShell(const Address& address, std::function<bool()> is_over = {});
  ~BoardShell();  ///< with `is_over`, a command that is still running here is ended, unless it traps SIGTERM
  BoardShell(const BoardShell&) = delete;
  BoardShell& operator=(const BoardShell&) = delete;

  struct Answer {
    int status = 0;    ///< exit status
    std::string text;  ///< what it printed, complaints too
  };

  /// Runs one command of the shell's language; its input is empty.
  ///
  /// fails     InputError: the shell is gone, the command has not ended in so many seconds, or nobody waits any more
  Answer run(const std::string& command, double patience_s);

  /// What this shell does when it ends, however it ends: also when this program is killed or the connection is cut. It may be done twice.
  ///
  /// fails     InputError: the shell is gone
  void at_end(const std::string& command);

 private:
  void send(const std::string& lines);
  [[noreturn]] void complain_of_the_end() const;
  bool leads_group() const { return is_over_ && !is_remote_; }

  std::string text_;  ///< the address, as written
  bool is_remote_;
  std::function<bool()> is_over_;
  int stream_ = -1;
  pid_t child_ = -1;
  std::string unread_;
  unsigned long long commands_ = 0;  ///< that were run
  bool has_answered_ = false;
};

}  // namespace isotouch::link
