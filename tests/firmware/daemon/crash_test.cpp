#include "firmware/daemon/crash.h"

#include <gtest/gtest.h>
#include <signal.h>  // NOLINT(modernize-deprecated-headers): raise
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <thread>

#include "firmware/loop/realtime.h"

namespace isotouch::daemon {
namespace {

/// A program of its own whose device's thread says when it has rested it; `crash` must end it by that signal, and not before.
template <class Crash>
void expect_rest_before(int signal, Crash crash) {
  int ends[2];
  ASSERT_EQ(pipe(ends), 0);
  const pid_t child = fork();
  if (child == 0) {
    static std::atomic<bool> stop{false};
    const RestOnCrash rest(stop);
    std::thread device([&] {
      while (!stop) usleep(100);
      [[maybe_unused]] const auto rested = write(ends[1], "0", 1);
    });
    device.detach();
    crash();
    _exit(0);
  }
  close(ends[1]);
  char said = 0;
  EXPECT_EQ(read(ends[0], &said, 1), 1);
  EXPECT_EQ(said, '0');
  int status = 0;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  EXPECT_TRUE(WIFSIGNALED(status));
  EXPECT_EQ(WTERMSIG(status), signal);
  close(ends[0]);
}

TEST(RestOnCrash, TheDevicesThreadRestsItBeforeTheProgramEndsAsItWouldHave) {
  for (const int signal : {SIGSEGV, SIGABRT, SIGFPE, SIGSYS, SIGTRAP}) {
    expect_rest_before(signal, [signal] { raise(signal); });
  }
}

/// Uses up the stack.
int fill_stack(int depth) {
  volatile char frame[4096];
  frame[depth % 4096] = static_cast<char>(depth);
  return depth < 0 ? 0 : fill_stack(depth + 1) + frame[depth % 4096];
}

TEST(RestOnCrash, AThreadThatUsesUpItsStackLeavesTheDeviceWithoutForceToo) {
  expect_rest_before(SIGSEGV, [] {
    std::thread deep([] {
      loop::keep_crash_stack();
      _exit(fill_stack(0));
    });
    deep.join();
  });
}

}  // namespace
}  // namespace isotouch::daemon
