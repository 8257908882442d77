/// Real-time rights of a thread, and the page faults and allocations that it has caused. Without the privilege the wish is refused and the thread runs on.
#pragma once

#include <cstddef>
#include <cstdint>

#include "shared/sanitizers.h"

namespace isotouch::loop {

/// What was refused, as bits; 0 = everything was granted.
enum Refusals : unsigned {
  kRefusedPriority = 1U << 0,
  kRefusedCore = 1U << 1,
  kRefusedMemory = 1U << 2,
};

/// The calling thread's.
///
/// priority  of SCHED_FIFO, 1 to 99; 0 = the ordinary scheduler
/// core      the one it runs on, from 0; -1 = any
/// returns   Refusals
unsigned become_realtime(int priority, int core);

/// Of the threads that begin after `limit_stacks`; a thread sanitizer's own frames need more.
#if ISOTOUCH_THREAD_SANITIZER
inline constexpr std::size_t kThreadStackBytes = 8U << 20;
#else
inline constexpr std::size_t kThreadStackBytes = 1U << 20;
#endif

/// Threads begun from now on have a stack of kThreadStackBytes, not of 8 MiB: locked memory is used up, touched or not.
void limit_stacks();

/// Locks all memory that the program has, and keeps what is freed from now on: to be called when everything of the tick is made. Memory that other
/// threads take later is not locked, because a program without the privilege would be refused it.
///
/// returns   Refusals
unsigned lock_memory();

/// Touches this much of the calling thread's stack, so that no later call is the first to use it.
void touch_stack();
inline constexpr int kTouchedStack = 256 * 1024;

/// Gives the calling thread a second stack for the handler of its crash, if it has none: one that has used up its first could not run it.
void keep_crash_stack();

/// Minor and major faults of the calling thread since it began. Asks the system; does not block.
std::uint64_t page_faults_of_thread();

/// Allocations of the calling thread since it began; counted by programs that replace malloc, else always 0.
extern thread_local std::uint64_t allocations_of_thread;

}  // namespace isotouch::loop
