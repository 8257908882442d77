#include "firmware/loop/linux_clock.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sched.h>
#include <sys/wait.h>
#include <unistd.h>

#include <string_view>

namespace isotouch::loop {
namespace {

/// As a machine sees it that has slept for a thousand seconds: in a time namespace, which only root may make.
TEST(LinuxClock, KnowsHowLongTheMachineHasSlept) {
  constexpr int kSeen = 0, kNotSeen = 1, kNotAllowed = 77;
  LinuxClock before;
  const std::int64_t already = before.suspended_ns();
  const pid_t child = ::fork();
  if (child == 0) {
    constexpr int kNewTime = 0x80;
    constexpr std::string_view kSlept = "boottime 1000 0";
    if (::unshare(kNewTime) != 0) ::_exit(kNotAllowed);
    const int offsets = ::open("/proc/self/timens_offsets", O_WRONLY | O_CLOEXEC);
    if (offsets < 0 || ::write(offsets, kSlept.data(), kSlept.size()) != static_cast<ssize_t>(kSlept.size())) ::_exit(kNotAllowed);
    const pid_t inside = ::fork();
    if (inside == 0) {
      LinuxClock clock;
      const std::int64_t more = clock.suspended_ns() - already;
      ::_exit(more > 999'000'000'000 && more < 1'001'000'000'000 ? kSeen : kNotSeen);
    }
    int status = 0;
    ::waitpid(inside, &status, 0);
    ::_exit(WIFEXITED(status) ? WEXITSTATUS(status) : kNotSeen);
  }
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  ASSERT_TRUE(WIFEXITED(status));
  if (WEXITSTATUS(status) == kNotAllowed) GTEST_SKIP() << "this machine makes no time namespace";
  EXPECT_EQ(WEXITSTATUS(status), kSeen);
}

}  // namespace
}  // namespace isotouch::loop
