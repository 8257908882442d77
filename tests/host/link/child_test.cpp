#include "host/link/child.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <pthread.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <string>
#include <vector>

#include "host/error.h"

namespace isotouch::link {
namespace {

using testing::HasSubstr;

std::string complaint(const std::string& program) {
  pid_t child = -1;
  try {
    ::close(run_child({program}, "here", child));
  } catch (const InputError& error) {
    EXPECT_EQ(child, -1);
    return error.what();
  }
  ::waitpid(child, nullptr, 0);
  return "it has become a program";
}

/// What another thread forks in the moment in which the pipe's end is open, without becoming a program.
struct Copy {
  inline static bool is_wanted = false;
  inline static pid_t process = -1;

  static void make() {
    if (!is_wanted) return;
    is_wanted = false;
    process = static_cast<pid_t>(::syscall(SYS_clone, SIGCHLD, nullptr, nullptr, nullptr, nullptr));
    if (process != 0) return;
    (void)::poll(nullptr, 0, 20'000);
    ::_exit(0);
  }
};

TEST(Child, WhatAnotherThreadForksHoldsNobodyUp) {
  ASSERT_EQ(::pthread_atfork(&Copy::make, nullptr, nullptr), 0);
  Copy::is_wanted = true;
  const auto begin = std::chrono::steady_clock::now();
  pid_t child = -1;
  const int end = run_child({"cat"}, "here", child);
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(10));
  ASSERT_GT(Copy::process, 0);
  EXPECT_EQ(::write(end, "x", 1), 1);
  char answer = 0;
  EXPECT_EQ(::read(end, &answer, 1), 1) << "the program runs";
  ::kill(Copy::process, SIGKILL);
  ::kill(child, SIGTERM);
  ::waitpid(Copy::process, nullptr, 0);
  ::waitpid(child, nullptr, 0);
  ::close(end);
}

TEST(Child, OnlyAProgramThatIsNotThereIsToBeInstalled) {
  EXPECT_EQ(complaint("/nowhere/ssh"), "here: /nowhere/ssh cannot be run (No such file or directory); install it, or correct the PATH");
  EXPECT_THAT(complaint("/"), HasSubstr("/ cannot be run (Permission denied); install it"));
  rlimit before{};
  ASSERT_EQ(::getrlimit(RLIMIT_NOFILE, &before), 0);
  std::vector<int> open;
  for (int left = 3; left >= 0; --left) {  // a pair of sockets takes two, and the pipe two more
    open.push_back(::open("/dev/null", O_RDONLY | O_CLOEXEC));
    const rlimit few{static_cast<rlim_t>(open.back() + 1 + left), before.rlim_max};
    ASSERT_EQ(::setrlimit(RLIMIT_NOFILE, &few), 0);
    const std::string said = complaint("cat");
    ASSERT_EQ(::setrlimit(RLIMIT_NOFILE, &before), 0);
    EXPECT_EQ(said, "here: no program can be started (Too many open files); close files or programs, or free memory") << left;
  }
  for (const int file : open) ::close(file);
}

}  // namespace
}  // namespace isotouch::link
