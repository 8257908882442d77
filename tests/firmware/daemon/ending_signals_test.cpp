#include "firmware/daemon/ending_signals.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

namespace isotouch::daemon {
namespace {

/// What becomes of a program that blocks what it should and is sent a signal: 's' it is taken as one that ends it, 'n' nothing, 'k' it is killed, 'h' it stands
/// still.
char after(int signal) {
  const pid_t child = fork();
  if (child == 0) {
    const sigset_t blocked = blocked_signals(), ending = ending_signals();
    pthread_sigmask(SIG_SETMASK, &blocked, nullptr);
    kill(getpid(), signal);
    const timespec none{0, 0};
    _exit(sigtimedwait(&ending, nullptr, &none) == signal ? 's' : 'n');
  }
  int status = 0;
  if (waitpid(child, &status, WUNTRACED) != child) return 0;
  if (WIFSTOPPED(status)) {
    kill(child, SIGKILL);
    waitpid(child, &status, 0);
    return 'h';
  }
  return WIFEXITED(status) ? static_cast<char>(WEXITSTATUS(status)) : 'k';
}

TEST(EndingSignals, NoneButACrashEndsTheProgramOutOfOrderOrLeavesItStandingStill) {
  int ended = 0;
  for (int signal = 1; signal <= SIGRTMAX; ++signal) {
    const bool heard = signal != SIGKILL && signal != SIGSTOP && (signal <= 31 || signal >= SIGRTMIN);
    const sigset_t blocked = blocked_signals();
    if (!heard || sigismember(&blocked, signal) == 0) continue;  // the others are those of a crash, see below
    const char result = after(signal);
    EXPECT_TRUE(result == 's' || result == 'n') << signal << " " << result;
    ended += result == 's' ? 1 : 0;
  }
  EXPECT_GT(ended, 20);
  for (const int signal : {SIGTERM, SIGINT, SIGHUP, SIGQUIT, SIGTSTP, SIGUSR1, SIGUSR2, SIGALRM, SIGXCPU})
    EXPECT_EQ(after(signal), 's') << signal;
  for (const int signal : {SIGTTIN, SIGTTOU, SIGXFSZ, SIGPIPE, SIGCHLD, SIGWINCH}) EXPECT_EQ(after(signal), 'n') << signal;
}

TEST(EndingSignals, OnlyAPersonOrTheSystemAsksForTheEnd) {
  for (const int signal : {SIGTERM, SIGINT, SIGHUP, SIGQUIT, SIGTSTP}) EXPECT_TRUE(asks_for_the_end(signal)) << signal;
  for (const int signal : {SIGXCPU, SIGPWR, SIGALRM, SIGUSR1, SIGRTMIN}) EXPECT_FALSE(asks_for_the_end(signal)) << signal;
}

}  // namespace
}  // namespace isotouch::daemon
