#include "host/commands/progress_bar.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <string>

namespace isotouch::commands {

namespace {

class Line {
 public:
  Line() = default;
  ~Line() { wipe(); }
  Line(const Line&) = delete;
  Line& operator=(const Line&) = delete;

  void draw(const std::string& stage, int percent) {
    if (percent == 100) return wipe();
    if (percent == shown_) return;
    shown_ = percent;
    constexpr int kCells = 40;
    const int filled = percent * kCells / 100;
    const std::string bar =
        std::string(static_cast<std::size_t>(filled), '#') + std::string(static_cast<std::size_t>(kCells - filled), ' ');
    std::fprintf(stderr, "\r%-14s [%s] %3d %%", stage.c_str(), bar.c_str(), percent);
    std::fflush(stderr);
  }

 private:
  static constexpr int kNothing = -1;

  void wipe() {
    if (shown_ == kNothing) return;
    shown_ = kNothing;
    std::fputs("\r\033[K", stderr);
    std::fflush(stderr);
  }

  int shown_ = kNothing;  // percent
};

}  // namespace

field::Progress::Show progress_bar() {
  if (isatty(STDERR_FILENO) == 0) return {};
  return [line = std::make_shared<Line>()](const std::string& stage, double fraction) {
    line->draw(stage, std::clamp(static_cast<int>(100 * fraction), 0, 100));
  };
}

}  // namespace isotouch::commands
