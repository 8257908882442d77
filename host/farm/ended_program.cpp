#include "host/farm/ended_program.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>

#include "host/error.h"
#include "shared/files/scoped_file.h"

namespace isotouch::farm {
namespace {

/// What was written to it since; files in memory take any amount, so nobody waits for a reader.
std::string text_of(int file) {
  std::string text;
  ::lseek(file, 0, SEEK_SET);
  std::array<char, 4096> part;
  for (ssize_t size = 0; (size = ::read(file, part.data(), part.size())) > 0;) text.append(part.data(), static_cast<std::size_t>(size));
  return text;
}

}  // namespace

EndedProgram run_program(std::vector<std::string> words) {
  std::vector<char*> pointers;
  pointers.reserve(words.size() + 1);
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  const ScopedFile printed(::memfd_create("printed", MFD_CLOEXEC)), complained(::memfd_create("complained", MFD_CLOEXEC));
  if (printed.number < 0 || complained.number < 0) throw InputError(words[0] + ": no memory for what it prints: " + std::strerror(errno));
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, 0, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_adddup2(&actions, printed.number, 1);
  posix_spawn_file_actions_adddup2(&actions, complained.number, 2);
  pid_t child = -1;
  const int failed = ::posix_spawnp(&child, pointers[0], &actions, nullptr, pointers.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (failed != 0) throw InputError(words[0] + " cannot be started: " + std::strerror(failed));
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), text_of(printed.number), text_of(complained.number)};
}

}  // namespace isotouch::farm
