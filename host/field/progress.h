/// Stages of a long computation: their names, their times, and how far the present one is.
#pragma once

#include <chrono>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace isotouch::field {

class Progress {
 public:
  using Show = std::function<void(const std::string& stage, double fraction)>;

  Progress() = default;
  explicit Progress(Show show) : show_(std::move(show)) {}

  /// Ends the present stage and begins the next.
  void begin(const std::string& stage) {
    end();
    current_ = stage;
    started_ = Clock::now();
    report(0.0);
  }
  /// fraction  of the present stage, 0 to 1
  void report(double fraction) const {
    if (show_ && !current_.empty()) show_(current_, fraction);
  }
  void end() {
    if (current_.empty()) return;
    report(1.0);
    seconds_.emplace_back(current_, std::chrono::duration<double>(Clock::now() - started_).count());
    current_.clear();
  }
  /// Finished stages in their order, with their wall-clock seconds.
  const std::vector<std::pair<std::string, double>>& seconds() const { return seconds_; }

 private:
  using Clock = std::chrono::steady_clock;
  Show show_;
  std::string current_;
  Clock::time_point started_;
  std::vector<std::pair<std::string, double>> seconds_;
};

}  // namespace isotouch::field
