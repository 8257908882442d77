#include "firmware/daemon/crash.h"

#include <gtest/gtest.h>
#include <signal.h>  // NOLINT(modernize-deprecated-headers): raise
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <thread>

namespace isotouch::daemon {
namespace {

TEST(RestOnCrash, TheDevicesThreadRestsItBeforeTheProgramEndsAsItWouldHave) {
  for (const int signal : {SIGSEGV, SIGABRT, SIGFPE}) {
    int ends[2];
    ASSERT_EQ(pipe(ends), 0);
    const pid_t child = fork();
    if (child == 0) {
      static std::atomic<bool> stop{false};
      rest_on_crash(stop);
      std::thread device([&] {
        while (!stop) usleep(100);
        [[maybe_unused]] const auto rested = write(ends[1], "0", 1);
      });
      device.detach();
      raise(signal);
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
}

}  // namespace
}  // namespace isotouch::daemon
