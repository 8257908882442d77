#include "firmware/recording/numbered_traces.h"

#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <string_view>
#include <system_error>

namespace isotouch::recording {

NumberedTraces::NumberedTraces(const std::string& name) {
  const std::filesystem::path path(name);
  extension_ = path.extension();
  begin_ = name.substr(0, name.size() - extension_.size()) + "-";
  const std::string begin = path.stem().string() + "-";
  std::error_code ignored;
  const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
  for (std::filesystem::directory_iterator entry(folder, ignored), end; entry != end; entry.increment(ignored)) {
    const std::string found = entry->path().filename().string();
    std::size_t number = 0;
    if (!found.starts_with(begin)) continue;
    const auto [from, failed] = std::from_chars(found.data() + begin.size(), found.data() + found.size(), number);
    const std::string_view rest(from);
    if (failed != std::errc{} || (!rest.empty() && rest.front() != '.')) continue;
    if (rest == extension_) whole_.push_back(number);
    highest_ = std::max(highest_, number);
  }
  std::sort(whole_.begin(), whole_.end());
}

std::string NumberedTraces::next() const {
  std::size_t number = highest_ + 1;
  while (access(numbered(number).c_str(), F_OK) == 0) ++number;
  return numbered(number);
}

void NumberedTraces::forget_oldest(std::size_t most) const {
  for (std::size_t i = 0; i + most < whole_.size(); ++i) unlink(numbered(whole_[i]).c_str());
}

}  // namespace isotouch::recording
