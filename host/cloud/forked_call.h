/// A call made in a process of its own: because it may crash, or because its memory is to be told from ours.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

namespace isotouch::cloud {

struct ForkedCall {
  bool crashed = false;          ///< the process did not come to the end of the call
  std::string thrown;            ///< what() of what the call threw; empty when it returned
  std::string answer;            ///< what the call returned
  std::uint64_t peak_bytes = 0;  ///< most memory that was resident at once; begins with what this process held
  double cpu_seconds = 0;        ///< of all threads of the copy
};

/// What a process may take from here on; 0 = as much as it likes.
struct ProcessLimits {
  std::uint64_t more_bytes = 0;  ///< of address space beyond what it holds: an allocation beyond it throws std::bad_alloc
  unsigned cpu_seconds = 0;      ///< then it is killed
  unsigned wall_seconds = 0;     ///< then it is killed, too, though it may only be waiting
};

/// Limits this process for good: for a call in a fork, once it has loaded what it needs.
void limit_this_process(const ProcessLimits& limits);

/// Makes the call in a copy of this process, so that what crashes or leaks there does not here. What it does to memory is lost, what it prints
/// is not seen.
///
/// call      must not need this process's other threads: the copy has none of them, and a lock that one of them held stays locked.
///           A library that starts threads when it is loaded is therefore to be loaded in the call
/// returns   how it ended; as if it had returned nothing where no process can be started
ForkedCall call_in_fork(const std::function<std::string()>& call);

}  // namespace isotouch::cloud
