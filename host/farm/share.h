/// A share of a farm's tasks, on this machine.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <vector>

#include "host/farm/task.h"

namespace isotouch::farm {

/// Shard `shard` of `shards`: of the tasks, counted recording by recording, each `shards`-th.
struct Share {
  std::size_t shard = 0, shards = 1;
  unsigned jobs = 1;  ///< at once
};

struct ShareReport {
  std::size_t tasks = 0;   ///< in the share
  std::size_t kept = 0;    ///< of these with an answer from before
  std::size_t asked = 0;   ///< now
  std::size_t failed = 0;  ///< of these without an answer
};

/// Asks for each answer that is not kept yet, and keeps it at once: what was ended half way goes on from there.
///
/// may_go_on   false: no further task is begun
/// fails       InputError: an answer cannot be kept
ShareReport run_share(const std::vector<Recording>& recordings, const std::vector<Program>& programs, const std::filesystem::path& answers,
                      const Share& share, const std::function<bool()>& may_go_on);

}  // namespace isotouch::farm
