/// A share of a farm's tasks, on this machine.
#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

#include "host/farm/ended_program.h"
#include "host/farm/task.h"

namespace isotouch::farm {

/// Shard `shard` of `shards`. The tasks are counted recording by recording. Of each run of `shards` tasks a shard takes one, and the next one of the next run:
/// each shard gets tasks of every program, whatever their number is.
struct Share {
  std::size_t shard = 0, shards = 1;
  unsigned jobs = 1;    ///< at once
  Patience patience{};  ///< of each task; when it may not go on, no further task is begun
};

struct ShareReport {
  std::size_t tasks = 0;   ///< in the share
  std::size_t kept = 0;    ///< of these with an answer from before
  std::size_t asked = 0;   ///< now
  std::size_t failed = 0;  ///< of these without an answer
};

/// Asks for each answer that is not kept yet, and keeps it at once: what was ended half way goes on from there.
///
/// fails       InputError: an answer cannot be kept
ShareReport run_share(const std::vector<Recording>& recordings, const std::vector<Program>& programs, const std::filesystem::path& answers,
                      const Share& share);

}  // namespace isotouch::farm
