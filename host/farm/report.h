/// All answers of a farm together.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "host/farm/answer.h"
#include "host/farm/task.h"

namespace isotouch::farm {

struct Row {
  const Recording* recording;
  const Program* program;
  std::optional<Answer> answer;  ///< none: nobody asked yet
};

/// Recording by recording, and in each program by program, as the tables have them. The tables stay alive as long as the rows.
std::vector<Row> merge(const std::vector<Recording>& recordings, const std::vector<Program>& programs,
                       const std::filesystem::path& answers);

struct Counts {
  std::size_t equal = 0, differs = 0, failed = 0, missing = 0;
  std::size_t all() const { return equal + differs + failed + missing; }
};
Counts count(const std::vector<Row>& rows);

/// Where a recording begins to differ, among the programs that differ in nothing but the commit, in the table's order.
struct Change {
  const Recording* recording;
  const Program* since;               ///< the first that is known to differ
  std::optional<std::uint64_t> tick;  ///< the first that differs; none where a program names no tick
  const Program* before = nullptr;    ///< the last that is known to be equal; nullptr: none is
  std::size_t unknown = 0;            ///< programs between these two without an answer: each of them may be the one
  const Program* again = nullptr;     ///< the first that is equal again; nullptr: none is
};
std::vector<Change> changes(const std::vector<Row>& rows);

/// "since 3 on armhf (gcc 12, rung 1), first in tick 7; equal at 1, not known at 1 commit between; equal again at 5"
std::string in_words(const Change& change);

/// What a processor replayed, and the time that its programs measured for it.
struct Speed {
  std::string processor;
  double ticks = 0;
  double seconds = 0;
};
std::vector<Speed> speeds(const std::vector<Row>& rows);

/// One line a row, without what another run would give otherwise (time, host, kernel): two farms with the same answers have the same bytes.
std::string to_csv(const std::vector<Row>& rows);

/// One page for a browser, that needs nothing else.
std::string to_html(const std::vector<Row>& rows);

}  // namespace isotouch::farm
