/// What is killed while it writes: one kind of write a class, and what kill_trials.cpp asks of each.
#pragma once

#include <unistd.h>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <iterator>
#include <memory>
#include <string>
#include <vector>

namespace isotouch::test {

namespace fs = std::filesystem;
using Number = std::uint64_t;  // of a write, from 1; 0 = none

/// What the child said before it was killed.
struct Heard {
  Number begun = 0, done = 0;
};

/// Says on the pipe what a child begins and what is acknowledged.
class Reporter {
 public:
  /// rests_after   so many acknowledged writes, until it is killed; 0: never
  Reporter(int pipe, Number rests_after) : pipe_(pipe), left_(rests_after) {}
  void begin(Number number) const { say(number << 1); }
  void done(Number number) const {
    say(number << 1 | 1);
    while (left_ == 1) ::pause();
    if (left_ > 1) --left_;
  }

 private:
  void say(Number word) const { (void)!::write(pipe_, &word, sizeof word); }
  int pipe_;
  mutable Number left_;
};

/// Why a trial fails, as one clause; empty: all holds.
using Verdict = std::string;

/// One kind of write.
class Kind {
 public:
  explicit Kind(fs::path folder) : folder_(std::move(folder)) { fs::create_directories(folder_); }
  virtual ~Kind() = default;
  /// In the child: writes number `first` and those behind it, for ever.
  virtual void write(Number first, const Reporter& report) = 0;
  /// In the parent: which write is there? It must be whole. 0: none.
  virtual Number found(Verdict& wrong) = 0;
  /// A writer begins with nothing, because a controller has saved before what the run before it left.
  virtual bool begins_anew() const { return false; }

  const fs::path& folder() const { return folder_; }
  std::size_t files() const { return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder_), fs::directory_iterator())); }

 private:
  fs::path folder_;
};

struct NamedKind {
  const char* name;
  Number modulo;  ///< what `found` knows of the number; 0: all of it
  std::function<std::unique_ptr<Kind>(const fs::path&)> make;
};

template <class K>
NamedKind named(const char* name, Number modulo = 0) {
  return {name, modulo, [](const fs::path& folder) { return std::make_unique<K>(folder); }};
}

/// What the controller writes, and what the host tool writes.
std::vector<NamedKind> controller_writers();
std::vector<NamedKind> tool_writers();

}  // namespace isotouch::test
