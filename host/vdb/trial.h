/// A dangerous call, tried in a process of its own first.
#pragma once

#include <functional>
#include <string>

namespace isotouch::vdb {

struct Trial {
  bool crashed = false;  ///< the process did not come to the end of the call
  std::string thrown;    ///< what() of what the call threw; empty when it returned
};

/// Makes the call in a copy of this process, so that what crashes or leaks there does not here. What it does to memory is lost, what it prints
/// is not seen.
///
/// call      must not need other threads: the copy has none of them
/// returns   how it ended; as if it had returned where no process can be started
Trial try_out(const std::function<void()>& call);

}  // namespace isotouch::vdb
