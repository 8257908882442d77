/// Works through one share of a farm's tasks on this machine.
///
/// real time   no
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "host/farm/ended_program.h"
#include "host/farm/task.h"

namespace isotouch::farm {

/// Which tasks, and how. The tasks are counted recording by recording, and cut into groups of `shards`. A shard takes one task of each group: the one at
/// the next place in each following group. So each shard gets tasks of every program, whatever the number of programs is.
struct Share {
  std::size_t shard = 0, shards = 1;  ///< shard counts from 0, below shards; more shards than tasks leave the last ones empty
  unsigned jobs = 1;                  ///< programs at once, 1 or more
  Patience patience{};                ///< for each task; once may_go_on is false, no further task begins
};

struct ShareReport {
  std::size_t tasks = 0;   ///< worked on, of those in the share
  std::size_t kept = 0;    ///< of these, had an answer already
  std::size_t asked = 0;   ///< of these, were replayed now
  std::size_t failed = 0;  ///< of these, have no answer, or one for other files than those that are there
  std::string changed;     ///< the first file that is not the one of the table, as a sentence; empty: all are
};

/// Replays each task of the share that has no answer yet, and keeps the answer at once. So a later call continues where an interrupted one ended.
///
/// A kept answer counts only if the recording's files are still those of the table: each file of the share is read once for that. A
/// task that is replayed reads its own files once more, just before (`ask`).
///
/// answers   the folder; made if it is not there
/// fails     InputError: the folder or an answer cannot be written
ShareReport run_share(const std::vector<Recording>& recordings, const std::vector<Program>& programs, const std::filesystem::path& answers,
                      const Share& share);

}  // namespace isotouch::farm
