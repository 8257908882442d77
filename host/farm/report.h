/// All answers of a farm together, and what they say.
///
/// real time   no
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "host/farm/answer.h"
#include "host/farm/task.h"

namespace isotouch::farm {

/// One task.
struct Row {
  const Recording* recording;
  const Program* program;
  std::optional<Answer> answer;  ///< none: nobody has replayed it yet
};

/// A row for each task: recording by recording, and for each recording program by program, in the order of the tables.
///
/// recordings, programs   must live as long as the rows, which point into them
/// fails                  InputError: an answer's file is there and cannot be read
std::vector<Row> merge(const std::vector<Recording>& recordings, const std::vector<Program>& programs,
                       const std::filesystem::path& answers);

/// Numbers of rows. Answers that contradict count as different.
struct Counts {
  std::size_t equal = 0, differs = 0, failed = 0, missing = 0;
  std::size_t all() const { return equal + differs + failed + missing; }
};
Counts count(const std::vector<Row>& rows);

/// Where a recording begins to differ. Programs are compared that have the same processor, compiler and rung, in the order of the table.
struct Change {
  const Recording* recording;
  const Program* since;               ///< the first that is known to differ
  std::optional<std::uint64_t> tick;  ///< the first tick that differs, from 0; none: the program names no tick
  const Program* before = nullptr;    ///< the last that is known to be equal; nullptr: none is
  std::size_t unknown = 0;            ///< programs between these two without an answer: the change may have come with any of them
  const Program* again = nullptr;     ///< the first that is equal again; nullptr: none is
};
std::vector<Change> changes(const std::vector<Row>& rows);

/// For example "since 3 on armhf (gcc 12, rung 1), first in tick 7; equal at 1, not known at 1 commit before; equal again at 5".
std::string in_words(const Change& change);

/// How much was replayed on one processor, and how long that took, as the programs measured it.
struct Speed {
  std::string processor;
  double ticks = 0;
  double seconds = 0;  ///< s
};
/// One for each processor that has answers, in the order of their names.
std::vector<Speed> speeds(const std::vector<Row>& rows);

/// A table with one line a row. It leaves out what differs from run to run (time, host, kernel), so two farms with the same answers give the same bytes.
std::string to_csv(const std::vector<Row>& rows);

/// One page for a browser, complete in itself.
std::string to_html(const std::vector<Row>& rows);

}  // namespace isotouch::farm
