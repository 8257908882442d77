#include "host/link/connection.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <memory>

#include "tests/support/scratch_folder.h"

namespace isotouch::link {
namespace {

/// Python programs fork, and what the copy forgets must not end what the original uses.
TEST(Connection, AForkThatEndsLeavesTheSshAlone) {
  const ScratchFolder folder;
  const std::filesystem::path ssh = folder.write("ssh", "#!/bin/sh\nexec cat\n");
  std::filesystem::permissions(ssh, std::filesystem::perms::owner_all);
  ::setenv("ISOTOUCH_SSH", ssh.c_str(), 1);
  auto connection = std::make_unique<Connection>(read_address("ssh://user@host"));
  ::unsetenv("ISOTOUCH_SSH");
  const pid_t copy = ::fork();
  if (copy == 0) {
    connection.reset();
    ::_exit(0);
  }
  ASSERT_EQ(::waitpid(copy, nullptr, 0), copy);
  EXPECT_FALSE(connection->has_input(300)) << "it has ended";
}

}  // namespace
}  // namespace isotouch::link
