/// How far a long command is, drawn in one line of a terminal.
///
/// The ends of stages are known, what lies between them is not: a walk along a surface does not know how long the surface is. There the bar goes on by
/// the time that the stage is expected to take, corrected by how long the stages before took, and slows down where that is over. A stage that reports
/// how far it is goes by that.
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "host/field/progress.h"

namespace isotouch::commands {

struct PlannedStage {
  std::string name;
  double seconds;  ///< about; what counts is its share in the whole
};

class ProgressBar {
 public:
  enum class Drawn {
    kAlways,    ///< ten times a second, by a thread of its own
    kAtBegins,  ///< when a stage begins: while time is measured
    kNever,
  };

  /// Draws on standard error when that is a terminal, after a moment; else it does nothing. A signal that ends the program wipes the line first.
  explicit ProgressBar(std::vector<PlannedStage> plan, Drawn drawn = Drawn::kAlways);
  /// As `end`.
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  /// Another plan for what is still to come; the bar never goes back.
  void plan(std::vector<PlannedStage> plan);
  /// The stages of the plan come in their order; some may be left out.
  void begin(const std::string& stage);
  /// Wipes the line, so that others may print until the next stage begins.
  void end();
  /// Prints something in the middle of a stage: the line is wiped before, and drawn again after a moment.
  void aside(const std::function<void()>& print);
  /// For `field::Progress`; lives no longer than the bar.
  field::Progress::Show show();

  /// The share of the whole that is done.
  double done_now() const {
    const std::scoped_lock held(lock_);
    return done(now());
  }
  /// The same: for tests.
  ///
  /// now       seconds since the bar was made
  double done(double now) const;

 private:
  using Clock = std::chrono::steady_clock;

  double now() const { return std::chrono::duration<double>(Clock::now() - made_).count(); }
  void report(const std::string& stage, double fraction);
  void draw();  ///< the caller holds the lock
  void wipe();

  std::vector<PlannedStage> plan_;
  Drawn drawn_;
  bool on_terminal_;
  Clock::time_point made_ = Clock::now();
  std::size_t next_ = 0;        ///< the plan's stage after the present one
  std::string stage_;           ///< empty: between stages
  double seconds_ = 0;          ///< planned for it
  double began_ = 0;            ///< seconds since the bar was made
  double before_ = 0;           ///< planned for the stages before it
  std::optional<double> told_;  ///< its own report
  double least_ = 0;            ///< the bar never goes back
  int shown_ = -1;              ///< percent; -1: no line
  std::string shown_stage_;
  mutable std::mutex lock_;
  std::condition_variable_any woken_;
  std::jthread drawer_;  // last: it uses all of these
};

}  // namespace isotouch::commands
