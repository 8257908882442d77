#include "firmware/loop/realtime.h"

#include <malloc.h>
#include <pthread.h>
#include <sched.h>
#include <signal.h>  // NOLINT(modernize-deprecated-headers): sigaltstack
#include <sys/mman.h>
#include <sys/resource.h>

#include <array>
#include <cstddef>

namespace isotouch::loop {

thread_local std::uint64_t allocations_of_thread = 0;

unsigned become_realtime(int priority, int core) {
  unsigned refused = 0;
  if (core >= 0) {
    cpu_set_t cores;
    CPU_ZERO(&cores);
    if (core < CPU_SETSIZE) CPU_SET(static_cast<std::size_t>(core), &cores);
    if (pthread_setaffinity_np(pthread_self(), sizeof cores, &cores) != 0) refused |= kRefusedCore;
  }
  if (priority > 0) {
    sched_param wish{};
    wish.sched_priority = priority;
    if (pthread_setschedparam(pthread_self(), SCHED_FIFO, &wish) != 0) refused |= kRefusedPriority;
  }
  return refused;
}

void limit_stacks() {
  pthread_attr_t attributes;
  pthread_attr_init(&attributes);
  pthread_attr_setstacksize(&attributes, kThreadStackBytes);
  pthread_setattr_default_np(&attributes);
  pthread_attr_destroy(&attributes);
}

unsigned lock_memory() {
  mallopt(M_TRIM_THRESHOLD, -1);
  mallopt(M_MMAP_MAX, 0);
  return mlockall(MCL_CURRENT) == 0 ? 0U : unsigned{kRefusedMemory};
}

void touch_stack() {
  volatile unsigned char stack[kTouchedStack];
  for (std::size_t i = 0; i < sizeof stack; i += 1024) stack[i] = 0;
}

void keep_crash_stack() {
  constexpr std::size_t kBytes = 32 * 1024;  // registers of the widest vectors take a third of it
  stack_t second{};
  if (sigaltstack(nullptr, &second) != 0 || (second.ss_flags & SS_DISABLE) == 0) return;  // it has one: a sanitizer's
  alignas(16) thread_local std::array<std::byte, kBytes> stack;
  second = {};
  second.ss_sp = stack.data();
  second.ss_size = stack.size();
  sigaltstack(&second, nullptr);
}

std::uint64_t page_faults_of_thread() {
  rusage usage{};
  getrusage(RUSAGE_THREAD, &usage);
  return static_cast<std::uint64_t>(usage.ru_minflt) + static_cast<std::uint64_t>(usage.ru_majflt);
}

}  // namespace isotouch::loop
