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

/// Where a recording begins to differ: of the programs that differ in nothing but the commit, the first in the table's order.
struct Change {
  const Recording* recording;
  const Program* since;
  std::optional<std::uint64_t> tick;  ///< the first that differs; none where a program names no tick
};
std::vector<Change> changes(const std::vector<Row>& rows);

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
