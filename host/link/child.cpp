#include "host/link/child.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>

#include "host/error.h"

namespace isotouch::link {

namespace {

constexpr std::chrono::milliseconds kPatience{2000};

/// Why it does not become the program, if it says so in time. Silence does not count: what another thread has forked may hold the other end, too.
///
/// answer    of the pipe that closes when it becomes the program
/// returns   errno; 0: it has become the program, as far as is known
int failure(int answer) {
  const auto end = std::chrono::steady_clock::now() + kPatience;
  pollfd one{answer, POLLIN, 0};
  int ready = -1;
  do {
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(end - std::chrono::steady_clock::now()).count();
    ready = ::poll(&one, 1, static_cast<int>(std::max<std::int64_t>(left, 0)));
  } while (ready < 0 && errno == EINTR);
  int failed = 0;
  const bool says = ready > 0 && ::read(answer, &failed, sizeof failed) == sizeof failed;
  return says ? failed : 0;
}

/// What the new process does until it is the program. Nothing that a signal handler may not do, because other threads hold their locks for ever here.
///
/// mask      of signals, for the program
/// told      where errno goes if it does not become the program
[[noreturn]] void become(char* const* words, int end, bool is_deaf, bool leads_group, const sigset_t& mask, int told) {
  for (int number = 1; number < NSIG; ++number) {  // a handler of this process is none of that one
    struct sigaction action {};
    if (::sigaction(number, nullptr, &action) == 0 && action.sa_handler != SIG_IGN) ::signal(number, SIG_DFL);
  }
  if (leads_group) ::setpgid(0, 0);
  for (const int of_terminal : {SIGINT, SIGHUP}) {
    if (is_deaf) ::signal(of_terminal, SIG_IGN);
  }
  ::pthread_sigmask(SIG_SETMASK, &mask, nullptr);
  const bool is_led = ::dup2(end, 0) == 0 && ::dup2(end, 1) == 1;
  if (end < 2) (void)::fcntl(end, F_SETFD, 0);  // a process without an input of its own got the end there
  if (is_led) ::execvp(words[0], words);
  const int failed = errno;
  (void)!::write(told, &failed, sizeof failed);
  ::_exit(1);
}

/// Starts it with `end` as its input and output. Not by posix_spawn, which lets a program ignore a signal only if this one does, too.
///
/// returns   0, or errno of what failed
int start(char* const* words, int end, bool is_deaf, bool leads_group, pid_t& child) {
  int answer[2];
  if (::pipe2(answer, O_CLOEXEC) != 0) return errno;
  sigset_t all, before;
  ::sigfillset(&all);
  ::pthread_sigmask(SIG_BLOCK, &all, &before);  // none of our handlers runs in the new process
  child = ::fork();
  if (child == 0) become(words, end, is_deaf, leads_group, before, answer[1]);
  int failed = child < 0 ? errno : 0;
  ::pthread_sigmask(SIG_SETMASK, &before, nullptr);
  ::close(answer[1]);
  if (child > 0 && (failed = failure(answer[0])) != 0) ::waitpid(child, nullptr, 0);
  ::close(answer[0]);
  return failed;
}

/// fails     InputError, always
[[noreturn]] void complain(const std::string& text, const std::string& program, int error) {
  const std::string why = std::strerror(error);
  for (const int lack : {EMFILE, ENFILE, EAGAIN, ENOMEM, ENOBUFS}) {
    if (error == lack) throw InputError(text + ": no program can be started (" + why + "); close files or programs, or free memory");
  }
  throw InputError(text + ": " + program + " cannot be run (" + why + "); install it, or correct the PATH");
}

}  // namespace

int run_child(std::vector<std::string> command, const std::string& text, pid_t& child, bool is_deaf, bool leads_group) {
  std::vector<char*> words;
  for (std::string& word : command) words.push_back(word.data());
  words.push_back(nullptr);
  int ends[2];
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) complain(text, command[0], errno);
  const int failed = start(words.data(), ends[1], is_deaf, leads_group, child);
  ::close(ends[1]);
  if (failed == 0) return ends[0];
  child = -1;
  ::close(ends[0]);
  complain(text, command[0], failed);
}

std::string ssh_program() {
  const char* chosen = std::getenv("ISOTOUCH_SSH");
  return chosen != nullptr && *chosen != 0 ? chosen : "ssh";
}

}  // namespace isotouch::link
