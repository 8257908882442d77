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

/// What the copy may take; 0 = as much as this process may.
struct ForkLimits {
  std::uint64_t more_bytes = 0;  ///< of address space beyond what this process holds: an allocation beyond it throws std::bad_alloc
  unsigned cpu_seconds = 0;      ///< then the copy is killed, and the call counts as crashed
};

/// Makes the call in a copy of this process, so that what crashes or leaks there does not here. What it does to memory is lost, what it prints
/// is not seen.
///
/// call      must not need this process's other threads: the copy has none of them
/// returns   how it ended; as if it had returned nothing where no process can be started
ForkedCall call_in_fork(const std::function<std::string()>& call, const ForkLimits& limits = {});

}  // namespace isotouch::cloud
