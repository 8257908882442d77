#include "host/cloud/forked_call.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <fstream>

namespace isotouch::cloud {

namespace {

constexpr char kReturned = 'r';
constexpr char kThrew = 't';

/// Of this process's address space; 0 where the system does not say.
std::uint64_t held_bytes() {
  std::ifstream statm("/proc/self/statm");
  std::uint64_t pages = 0;
  statm >> pages;
  return statm ? pages * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE)) : 0;
}

/// Never returns; what the call returned or threw goes into the pipe, behind how it ended.
[[noreturn]] void be_the_copy(const std::function<std::string()>& call, int pipe_end) {
  const rlimit no_core = {0, 0};
  setrlimit(RLIMIT_CORE, &no_core);
  const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
  dup2(nowhere, STDOUT_FILENO);
  dup2(nowhere, STDERR_FILENO);
  std::string text(1, kReturned);
  try {
    text += call();
  } catch (const std::exception& e) {
    text = kThrew + std::string(e.what());
  } catch (...) {
    text = kThrew + std::string("an error without a text");
  }
  const ssize_t written = write(pipe_end, text.data(), text.size());
  _exit(written == static_cast<ssize_t>(text.size()) ? EXIT_SUCCESS : EXIT_FAILURE);
}

double seconds(const timeval& time) { return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec); }

}  // namespace

void limit_this_process(const ProcessLimits& limits) {
  if (limits.cpu_seconds > 0) {
    const rlimit time = {limits.cpu_seconds, limits.cpu_seconds};
    setrlimit(RLIMIT_CPU, &time);
  }
  if (limits.wall_seconds > 0) alarm(limits.wall_seconds);
  const std::uint64_t held = limits.more_bytes > 0 ? held_bytes() : 0;
  if (held > 0) {
    const rlimit memory = {held + limits.more_bytes, held + limits.more_bytes};
    setrlimit(RLIMIT_AS, &memory);
  }
}

ForkedCall call_in_fork(const std::function<std::string()>& call) {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) return {};
  std::fflush(nullptr);  // or the copy would hold the same unwritten text
  const pid_t child = fork();
  if (child == 0) be_the_copy(call, ends[1]);
  close(ends[1]);
  std::string text;
  std::array<char, 1024> part;
  for (ssize_t size = 0; child > 0 && ((size = read(ends[0], part.data(), part.size())) > 0 || (size < 0 && errno == EINTR));) {
    if (size > 0) text.append(part.data(), static_cast<std::size_t>(size));
  }
  close(ends[0]);
  ForkedCall trial;
  if (child < 0) return trial;
  int status = 0;
  rusage usage{};
  while (wait4(child, &status, 0, &usage) < 0 && errno == EINTR) {
  }
  trial.crashed = !WIFEXITED(status) || WEXITSTATUS(status) != EXIT_SUCCESS || text.empty();
  if (!text.empty()) (text[0] == kThrew ? trial.thrown : trial.answer) = text.substr(1);
  trial.peak_bytes = 1024 * static_cast<std::uint64_t>(usage.ru_maxrss);
  trial.cpu_seconds = seconds(usage.ru_utime) + seconds(usage.ru_stime);
  return trial;
}

}  // namespace isotouch::cloud
