#include "host/commands/progress_bar.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <string>

namespace isotouch::commands {

field::Progress::Show progress_bar() {
  if (isatty(STDERR_FILENO) == 0) return {};
  return [shown = -1](const std::string& stage, double fraction) mutable {
    constexpr int kCells = 40;
    const int percent = std::clamp(static_cast<int>(100 * fraction), 0, 100);
    if (percent == shown) return;
    shown = percent;
    if (percent == 100) {
      std::fputs("\r\033[K", stderr);
    } else {
      const auto filled = static_cast<std::size_t>(percent * kCells / 100);
      std::fprintf(stderr, "\r%-14s [%s%s] %3d %%", stage.c_str(), std::string(filled, '#').c_str(),
                   std::string(kCells - filled, ' ').c_str(), percent);
    }
    std::fflush(stderr);
  };
}

}  // namespace isotouch::commands
