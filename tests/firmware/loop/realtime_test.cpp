#include "firmware/loop/realtime.h"

#include <gtest/gtest.h>
#include <pthread.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstddef>
#include <fstream>
#include <string>
#include <thread>

namespace isotouch::loop {
namespace {

std::size_t stack_of_this_thread() {
  pthread_attr_t attributes;
  pthread_getattr_np(pthread_self(), &attributes);
  std::size_t bytes = 0;
  pthread_attr_getstacksize(&attributes, &bytes);
  pthread_attr_destroy(&attributes);
  return bytes;
}

TEST(Realtime, ThreadsBegunAfterTheLimitHaveSmallStacks) {
  limit_stacks();
  std::size_t bytes = 0;
  std::thread([&] { bytes = stack_of_this_thread(); }).join();
  EXPECT_EQ(bytes, kThreadStackBytes);
}

struct Scheduling {
  int policy = -1, priority = -1;
};

Scheduling scheduling_of_this_thread() {
  Scheduling now;
  sched_param parameters{};
  pthread_getschedparam(pthread_self(), &now.policy, &parameters);
  now.priority = parameters.sched_priority;
  return now;
}

/// Does this machine give real-time rights to this program?
bool may_be_realtime() {
  bool granted = false;
  std::thread([&] {
    sched_param wish{};
    wish.sched_priority = 3;
    granted = pthread_setschedparam(pthread_self(), SCHED_FIFO, &wish) == 0 && scheduling_of_this_thread().policy == SCHED_FIFO;
  }).join();
  return granted;
}

TEST(Realtime, AThreadHasThePriorityThatItAskedFor) {
  if (!may_be_realtime()) GTEST_SKIP() << "this machine gives no real-time rights";
  unsigned refused = ~0U;
  Scheduling scheduling;
  std::thread([&] {
    refused = become_realtime(3, -1);
    scheduling = scheduling_of_this_thread();
  }).join();
  EXPECT_EQ(refused, 0U);
  EXPECT_EQ(scheduling.policy, SCHED_FIFO);
  EXPECT_EQ(scheduling.priority, 3);
}

TEST(Realtime, WithoutAWishAThreadStaysAsItIs) {
  std::thread([] {
    const Scheduling before = scheduling_of_this_thread();
    EXPECT_EQ(become_realtime(0, -1), 0U);
    EXPECT_EQ(scheduling_of_this_thread().policy, before.policy);
  }).join();
}

TEST(Realtime, AThreadRunsOnTheCoreThatItAskedFor) {
  cpu_set_t all;
  if (sched_getaffinity(0, sizeof all, &all) != 0) GTEST_SKIP() << "the system does not tell its processors";
  int last = -1;
  for (int core = 0; core < CPU_SETSIZE; ++core) {
    if (CPU_ISSET(static_cast<std::size_t>(core), &all)) last = core;
  }
  std::thread([last] {
    EXPECT_EQ(become_realtime(0, last), 0U);
    cpu_set_t cores;
    ASSERT_EQ(pthread_getaffinity_np(pthread_self(), sizeof cores, &cores), 0);
    EXPECT_EQ(CPU_COUNT(&cores), 1);
    EXPECT_TRUE(CPU_ISSET(static_cast<std::size_t>(last), &cores));
  }).join();
  std::thread([] { EXPECT_EQ(become_realtime(0, CPU_SETSIZE + 5), unsigned{kRefusedCore}); }).join();
}

/// Of this process, kB.
long locked_memory() {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;) {
    long kilobytes = 0;
    if (word == "VmLck:" && status >> kilobytes) return kilobytes;
  }
  return -1;
}

/// Each in a program of its own, so that nothing stays locked: 0 = it is locked, 1 = it is not.
int exit_code_of_lock(bool ours) {
  const bool done = ours ? lock_memory() == 0 : mlockall(MCL_CURRENT) == 0;
  return done && locked_memory() > 500 ? 0 : 1;
}

TEST(RealtimeDeathTest, LockedMemoryIsLocked) {
  const pid_t probe = fork();
  if (probe == 0) ::_exit(exit_code_of_lock(false));
  int status = -1;
  ASSERT_EQ(waitpid(probe, &status, 0), probe);
  if (status != 0) GTEST_SKIP() << "this machine, or a sanitizer, lets this program lock nothing";
  EXPECT_EXIT(::_exit(exit_code_of_lock(true)), ::testing::ExitedWithCode(0), "");
}

}  // namespace
}  // namespace isotouch::loop
