#include "host/vdb/trial.h"

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

namespace isotouch::vdb {

namespace {

/// Never returns; what the call threw goes into the pipe.
[[noreturn]] void be_the_copy(const std::function<void()>& call, int pipe_end) {
  const rlimit no_core = {0, 0};
  setrlimit(RLIMIT_CORE, &no_core);
  const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
  dup2(nowhere, STDOUT_FILENO);
  dup2(nowhere, STDERR_FILENO);
  std::string thrown;
  try {
    call();
  } catch (const std::exception& e) {
    thrown = e.what();
  } catch (...) {
    thrown = "an error without a text";
  }
  const ssize_t written = write(pipe_end, thrown.data(), thrown.size());
  _exit(written == static_cast<ssize_t>(thrown.size()) ? EXIT_SUCCESS : EXIT_FAILURE);
}

}  // namespace

Trial try_out(const std::function<void()>& call) {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) return {};
  std::fflush(nullptr);  // or the copy would hold the same unwritten text
  const pid_t child = fork();
  if (child == 0) be_the_copy(call, ends[1]);
  close(ends[1]);
  Trial trial;
  std::array<char, 1024> text;
  for (ssize_t size = 0; child > 0 && ((size = read(ends[0], text.data(), text.size())) > 0 || (size < 0 && errno == EINTR));) {
    if (size > 0) trial.thrown.append(text.data(), static_cast<std::size_t>(size));
  }
  close(ends[0]);
  if (child < 0) return trial;
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  trial.crashed = !WIFEXITED(status) || WEXITSTATUS(status) != EXIT_SUCCESS;
  return trial;
}

}  // namespace isotouch::vdb
