#include "host/link/child.h"

#include <spawn.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>

#include "host/error.h"

extern char** environ;

namespace isotouch::link {

int run_child(std::vector<std::string> command, const std::string& text, pid_t& child) {
  std::vector<char*> words;
  for (std::string& word : command) words.push_back(word.data());
  words.push_back(nullptr);
  int ends[2];
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) throw InputError(text + ": " + std::strerror(errno));
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, ends[1], 0);
  posix_spawn_file_actions_adddup2(&actions, ends[1], 1);
  const int failed = ::posix_spawnp(&child, words[0], &actions, nullptr, words.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  ::close(ends[1]);
  if (failed == 0) return ends[0];
  child = -1;
  ::close(ends[0]);
  throw InputError(text + ": " + command[0] + " cannot be run (" + std::strerror(failed) + "); install an ssh client");
}

std::string ssh_program() {
  const char* chosen = std::getenv("ISOTOUCH_SSH");
  return chosen != nullptr && *chosen != 0 ? chosen : "ssh";
}

}  // namespace isotouch::link
