#include "host/farm/ended_program.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>

#include "host/error.h"
#include "shared/files/scoped_file.h"

namespace isotouch::farm {
namespace {

constexpr off_t kMaxPrinted = 16 << 20;
constexpr int kLookEveryMs = 100;

off_t size_of(int file) {
  struct stat now {};
  return ::fstat(file, &now) == 0 ? now.st_size : 0;
}

/// What was written to it since; files in memory take any amount, so nobody waits for a reader.
std::string text_of(int file) {
  std::string text;
  ::lseek(file, 0, SEEK_SET);
  std::array<char, 4096> part;
  for (ssize_t size = 0; (size = ::read(file, part.data(), part.size())) > 0;) text.append(part.data(), static_cast<std::size_t>(size));
  return text;
}

/// A child in a process group of its own: what it starts ends with it, and a Ctrl-C reaches it by way of this program alone.
pid_t start(std::vector<std::string>& words, int printed, int complained) {
  std::vector<char*> pointers;
  pointers.reserve(words.size() + 1);
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, 0, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_adddup2(&actions, printed, 1);
  posix_spawn_file_actions_adddup2(&actions, complained, 2);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
  pid_t child = -1;
  const int failed = ::posix_spawnp(&child, pointers[0], &actions, &attributes, pointers.data(), environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);
  if (failed != 0) throw InputError(words[0] + " cannot be started: " + std::strerror(failed));
  return child;
}

}  // namespace

EndedProgram run_program(std::vector<std::string> words, const Patience& patience) {
  const ScopedFile printed(::memfd_create("printed", MFD_CLOEXEC)), complained(::memfd_create("complained", MFD_CLOEXEC));
  if (printed.number < 0 || complained.number < 0) throw InputError(words[0] + ": no memory for what it prints: " + std::strerror(errno));
  const pid_t child = start(words, printed.number, complained.number);
  const ScopedFile end(static_cast<int>(::syscall(SYS_pidfd_open, child, 0)));  // glibc 2.36 names it only for C
  if (end.number < 0) {
    const int reason = errno;
    ::kill(-child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    throw InputError(words[0] + " cannot be waited for: " + std::strerror(reason) + "; start fewer at a time, or allow more files");
  }
  EndedProgram ended;
  const auto begin = std::chrono::steady_clock::now();
  for (pollfd wait{end.number, POLLIN, 0}; ::poll(&wait, 1, kLookEveryMs) <= 0;) {
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - begin;
    if (patience.seconds > 0 && passed.count() > patience.seconds) ended.stopped = "it gave no answer in time";
    if (size_of(printed.number) > kMaxPrinted || size_of(complained.number) > kMaxPrinted) ended.stopped = "it printed more than 16 MB";
    if (!patience.may_go_on()) ended.stopped = "interrupted";
    if (!ended.stopped.empty()) break;
  }
  ::kill(-child, SIGKILL);  // also what a program left behind that has ended: not yet waited for, it keeps the number
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  ended.code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  if (ended.stopped.empty()) ended.printed = text_of(printed.number), ended.complained = text_of(complained.number);
  return ended;
}

}  // namespace isotouch::farm
