/// How findings are made: a board's files, asked by what they mean, and a practice that is judged.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "host/qualify/board_files.h"
#include "host/qualify/practice.h"

namespace isotouch::qualify {

class Board {
 public:
  /// files     live longer
  explicit Board(const BoardFiles& files) : files_(files) {}

  /// nullptr: it could not be read
  const std::string* text(const std::string& path) const;
  bool is_missing(const std::string& path) const { return files_.missing.count(path) != 0; }
  /// Whatever begins and ends so, by path.
  std::vector<std::pair<std::string, std::string>> under(const std::string& begin, const std::string& end) const;

  /// Of a thread of the controller; nothing: it is not seen.
  std::optional<Scheduling> thread(const std::string& name) const;
  /// The processors that it may run on; none is nothing, too.
  std::optional<std::set<int>> cores(const std::string& name) const;
  std::optional<std::set<int>> online() const;
  /// The one to give to the tick: the last, because the first does most of the kernel's own work.
  int best_core() const;
  /// May a thread of the controller that must be on time run on this one? Yes, where that is not known.
  bool may_run_threads(int core) const;

 private:
  const BoardFiles& files_;
};

/// One practice, of which a judgement is made.
struct Ask {
  const char* key;
  const char* what;

  Finding good(const std::string& read, const std::string& why) const { return {key, what, read, Finding::Verdict::kGood, why, ""}; }
  Finding better(const std::string& read, const std::string& why, const std::string& remedy) const {
    return {key, what, read, Finding::Verdict::kCouldBeBetter, why, remedy};
  }
  Finding bad(const std::string& read, const std::string& why, const std::string& remedy) const {
    return {key, what, read, Finding::Verdict::kBad, why, remedy};
  }
  Finding not_known(const std::string& why, const std::string& remedy) const {
    return {key, what, "", Finding::Verdict::kNotRead, why, remedy};
  }
  /// The file is not there, or may not be read.
  Finding not_read(const Board& board, const std::string& path) const;
  /// It holds something that is no answer.
  Finding garbled_file(const std::string& path, const std::string& text) const;
  /// The same of something that is no file.
  Finding garbled(const std::string& text, const std::string& remedy) const;
  /// No thread of a controller is seen.
  Finding no_controller(const std::string& read = {}) const;
};

}  // namespace isotouch::qualify
