#include "host/link/connection.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <string>

#include "tests/support/scratch_folder.h"

namespace isotouch::link {
namespace {

/// Runs this instead of ssh.
class Ssh {
 public:
  explicit Ssh(const std::string& script) {
    const std::filesystem::path ssh = folder_.write("ssh", "#!/bin/sh\n" + script);
    std::filesystem::permissions(ssh, std::filesystem::perms::owner_all);
    ::setenv("ISOTOUCH_SSH", ssh.c_str(), 1);
  }
  Ssh(const Ssh&) = delete;
  Ssh& operator=(const Ssh&) = delete;
  ~Ssh() { ::unsetenv("ISOTOUCH_SSH"); }

 private:
  ScratchFolder folder_;
};

/// Python programs fork, and what the copy forgets must not end what the original uses.
TEST(Connection, AForkThatEndsLeavesTheSshAlone) {
  const Ssh ssh("exec cat\n");
  auto connection = std::make_unique<Connection>(read_address("ssh://user@host"));
  const pid_t copy = ::fork();
  if (copy == 0) {
    connection.reset();
    ::_exit(0);
  }
  ASSERT_EQ(::waitpid(copy, nullptr, 0), copy);
  EXPECT_FALSE(connection->has_input(300)) << "it has ended";
}

/// OpenSSH keeps ignoring what it ignores when it begins, so what is asked after Ctrl-C still reaches the controller.
TEST(Connection, OnlyWhoeverSaysWhenItIsOverKeepsTheSshFromWhatATerminalSends) {
  for (const char* sent : {"INT", "HUP"}) {
    ::signal(SIGINT, SIG_DFL);  // a shell's background ignores it, and nohup the other
    ::signal(SIGHUP, SIG_DFL);
    const Ssh ssh("exec sh -c 'kill -" + std::string(sent) + " $$; exec cat'\n");
    Connection with(read_address("ssh://user@host"), 0, [] { return false; }), without(read_address("ssh://user@host"));
    EXPECT_TRUE(without.has_input(60'000)) << sent << " has not ended it";
    EXPECT_FALSE(with.has_input(500)) << sent << " has ended it";
  }
}

}  // namespace
}  // namespace isotouch::link
