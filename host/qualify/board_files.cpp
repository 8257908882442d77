#include "host/qualify/board_files.h"

#include <algorithm>
#include <charconv>
#include <sstream>
#include <system_error>

#include "shared/printable.h"

namespace isotouch::qualify {

namespace {

constexpr std::string_view kBlanks = " \t\r\n";

std::string_view trimmed(std::string_view text) {
  const auto begin = text.find_first_not_of(kBlanks);
  return begin == std::string_view::npos ? std::string_view{} : text.substr(begin, text.find_last_not_of(kBlanks) - begin + 1);
}

std::vector<std::string> words_of(std::string_view text) {
  std::istringstream in{std::string(text)};
  std::vector<std::string> words;
  for (std::string word; in >> word;) words.push_back(word);
  return words;
}

}  // namespace

std::optional<std::int64_t> whole_number(std::string_view text) {
  text = trimmed(text);
  std::int64_t number = 0;
  const auto [end, failed] = std::from_chars(text.data(), text.data() + text.size(), number);
  return failed == std::errc() && end == text.data() + text.size() && !text.empty() ? std::optional(number) : std::nullopt;
}

std::optional<std::set<int>> processors(std::string_view text) {
  constexpr std::int64_t kMaxProcessor = 8191;
  std::set<int> all;
  for (text = trimmed(text); !text.empty();) {
    const auto comma = text.find(',');
    const std::string_view part = text.substr(0, comma);
    const auto dash = part.find('-');
    const auto first = whole_number(part.substr(0, dash)),
               last = dash == std::string_view::npos ? first : whole_number(part.substr(dash + 1));
    if (!first || !last || *first < 0 || *last < *first || *last > kMaxProcessor) return std::nullopt;
    for (std::int64_t p = *first; p <= *last; ++p) all.insert(static_cast<int>(p));
    if (comma == std::string_view::npos) break;
    text = text.substr(comma + 1);
    if (text.empty()) return std::nullopt;
  }
  return all;
}

std::string list_of(const std::set<int>& processors) {
  std::string text;
  for (auto at = processors.begin(); at != processors.end();) {
    auto last = at;
    for (auto next = std::next(last); next != processors.end() && *next == *last + 1; ++next) last = next;
    if (!text.empty()) text += ",";
    text += std::to_string(*at);
    if (last != at) text.append("-").append(std::to_string(*last));
    at = std::next(last);
  }
  return text;
}

std::optional<Scheduling> scheduling(std::string_view stat) {
  // Fields 40 and 41 of proc(5); the name, field 2, may hold blanks and brackets of its own, so the last bracket counts.
  constexpr std::size_t kPriority = 37, kPolicy = 38;
  const auto bracket = stat.rfind(')');
  if (bracket == std::string_view::npos) return std::nullopt;
  const std::vector<std::string> fields = words_of(stat.substr(bracket + 1));
  if (fields.size() <= kPolicy) return std::nullopt;
  const auto priority = whole_number(fields[kPriority]), policy = whole_number(fields[kPolicy]);
  if (!priority || !policy || *priority < 0 || *priority > 99 || *policy < 0 || *policy > 7) return std::nullopt;
  return Scheduling{static_cast<int>(*policy), static_cast<int>(*priority)};
}

std::string name_in(std::string_view stat) {
  const auto begin = stat.find('('), end = stat.rfind(')');
  return begin == std::string_view::npos || end == std::string_view::npos || end < begin
             ? std::string()
             : std::string(stat.substr(begin + 1, end - begin - 1));
}

bool Interrupt::has_come() const {
  return std::any_of(counts.begin(), counts.end(), [](std::uint64_t count) { return count > 0; });
}

std::vector<Interrupt> interrupts(std::string_view text) {
  std::istringstream in{std::string(text)};
  std::string line;
  std::getline(in, line);
  std::size_t columns = 0;
  for (const std::string& word : words_of(line)) columns += word.starts_with("CPU") ? 1U : 0U;
  std::vector<Interrupt> all;
  while (columns > 0 && std::getline(in, line)) {
    const auto colon = line.find(':');
    const auto number = whole_number(std::string_view(line).substr(0, colon));
    if (colon == std::string::npos || !number || *number < 0 || *number > INT32_MAX) continue;
    const std::vector<std::string> words = words_of(std::string_view(line).substr(colon + 1));
    Interrupt one{static_cast<int>(*number), {}, {}};
    std::size_t word = 0;
    for (; word < std::min(columns, words.size()); ++word) {
      const auto count = whole_number(words[word]);
      if (!count || *count < 0) break;
      one.counts.push_back(static_cast<std::uint64_t>(*count));
    }
    if (one.counts.size() != columns) continue;
    for (; word < words.size(); ++word) one.name += (one.name.empty() ? "" : " ") + words[word];
    all.push_back(std::move(one));
  }
  return all;
}

std::string shown(std::string_view text, std::size_t most) {
  std::string line;
  text = trimmed(text);
  while (!text.empty() && line.size() < most) {
    const std::size_t size = printable_size(text);
    line += size == 0 ? std::string(1, ' ') : std::string(text.substr(0, size));
    text.remove_prefix(std::max<std::size_t>(size, 1));
  }
  line.resize(line.find_last_not_of(' ') + 1);
  return text.empty() ? line : line + "…";
}

}  // namespace isotouch::qualify
