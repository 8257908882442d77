#include "host/cloud/text_lines.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <limits>
#include <system_error>
#include <utility>

namespace isotouch::cloud {
namespace {

constexpr std::string_view kSeparators = " \t,;";
constexpr std::string_view kSeparatorsOfJoined = " \t,;\\\r\n";

}  // namespace

TextLines::TextLines(std::string name, std::span<const std::uint8_t> bytes, std::span<const std::string_view> going_on)
    : name_(std::move(name)), bytes_(bytes), going_on_(going_on) {
  constexpr std::array<std::uint8_t, 3> kMark = {0xEF, 0xBB, 0xBF};  // of UTF-8, as editors of Windows write it
  if (bytes.size() >= kMark.size() && std::equal(kMark.begin(), kMark.end(), bytes.begin())) next_ = kMark.size();
}

bool TextLines::next() {
  if (next_ >= bytes_.size()) return false;
  std::string_view last = line_of_file();
  rest_ = last;
  const std::string_view word = last.substr(std::min(last.find_first_not_of(kSeparatorsOfJoined), last.size()));
  if (std::find(going_on_.begin(), going_on_.end(), word.substr(0, word.find_first_of(kSeparatorsOfJoined))) == going_on_.end())
    return true;
  // A remark may end in the name of a folder.
  while (last.ends_with('\\') && last.find('#') == std::string_view::npos && next_ < bytes_.size()) {
    last = line_of_file();
    rest_ = std::string_view(rest_.data(), static_cast<std::size_t>(last.data() + last.size() - rest_.data()));
  }
  return true;
}

std::string_view TextLines::line_of_file() {
  const char* begin = reinterpret_cast<const char*>(bytes_.data()) + next_;
  const void* found = std::memchr(begin, '\n', bytes_left());
  const char* end = found != nullptr ? static_cast<const char*>(found) : begin + bytes_left();
  next_ += static_cast<std::size_t>(end - begin) + (found != nullptr ? 1 : 0);
  ++line_;
  std::string_view line(begin, static_cast<std::size_t>(end - begin));
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

std::optional<std::string_view> TextLines::field() {
  const std::string_view separators = going_on_.empty() ? kSeparators : kSeparatorsOfJoined;
  const std::size_t begin = rest_.find_first_not_of(separators);
  if (begin == std::string_view::npos) return std::nullopt;
  rest_.remove_prefix(begin);
  const std::string_view found = rest_.substr(0, rest_.find_first_of(separators));
  rest_.remove_prefix(found.size());
  return found;
}

double TextLines::number(std::string_view what) {
  const std::optional<std::string_view> found = field();
  if (!found) throw refusal("the line ends where " + std::string(what) + " should stand");
  const std::optional<double> value = as_number(*found);
  if (!value) throw refusal(quote(*found) + " is no number; " + std::string(what) + " should stand there");
  return *value;
}

InputError TextLines::refusal(const std::string& what) const { return InputError(name_ + ": line " + std::to_string(line_) + ": " + what); }

namespace {

/// Of a number that is written well and is not zero: from where its first digit that is not 0 stands, and its exponent.
bool is_below_one(std::string_view number) {
  const std::size_t e = std::min(number.find_first_of("eE"), number.size());
  std::string_view exponent = number.substr(std::min(e + 1, number.size()));
  if (exponent.starts_with('+')) exponent.remove_prefix(1);
  long long shift = 0;
  if (std::from_chars(exponent.data(), exponent.data() + exponent.size(), shift).ec == std::errc::result_out_of_range)
    return exponent.starts_with('-');
  const std::string_view digits = number.substr(0, e);
  const auto first = static_cast<long long>(digits.find_first_of("123456789"));
  const auto point = static_cast<long long>(std::min(digits.find('.'), digits.size()));
  return point - first + (first > point ? 1 : 0) + std::clamp(shift, -(1LL << 40), 1LL << 40) <= 0;
}

}  // namespace

std::size_t with_decimal_commas(std::string_view line) {
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  std::size_t fields = 0, decimal = 0;
  for (std::size_t begin = 0; (begin = line.find_first_not_of(" \t;", begin)) != std::string_view::npos; ++fields) {
    const std::string_view field = line.substr(begin, line.find_first_of(" \t;", begin) - begin);
    begin += field.size();
    const std::size_t comma = field.find(',');
    if (comma == std::string_view::npos) continue;
    if (comma == 0 || comma + 1 == field.size() || field.find(',', comma + 1) != std::string_view::npos) return 0;
    if (!is_digit(field[comma - 1]) || !is_digit(field[comma + 1])) return 0;
    ++decimal;
  }
  return decimal > 0 ? fields : 0;
}

InputError decimal_commas(const TextLines& lines) {
  return lines.refusal("its numbers have decimal commas; save them with decimal points");
}

std::vector<std::string_view> cells_of(std::string_view line, char separator) {
  std::vector<std::string_view> cells;
  if (separator == '\0' || line.find(separator) == std::string_view::npos) {
    for (std::size_t begin = 0, end = 0; (begin = line.find_first_not_of(kSeparators, end)) != std::string_view::npos;) {
      end = std::min(line.find_first_of(kSeparators, begin), line.size());
      cells.push_back(line.substr(begin, end - begin));
    }
    return cells;
  }
  constexpr std::string_view kBlanks = " \t";
  for (std::size_t begin = 0, end = 0; end < line.size(); begin = end + 1) {
    end = std::min(line.find(separator, begin), line.size());
    std::string_view cell = line.substr(begin, end - begin);
    cell.remove_prefix(std::min(cell.find_first_not_of(kBlanks), cell.size()));
    cells.push_back(cell.substr(0, cell.find_last_not_of(kBlanks) + 1));
  }
  return cells;
}

std::optional<double> as_number(std::string_view field) {
  if (field.starts_with('+') && !field.starts_with("+-")) field.remove_prefix(1);
  double value = 0.0;
  const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value);
  if (end != field.data() + field.size()) return std::nullopt;
  if (error == std::errc::result_out_of_range) {  // too large, or too small to matter: from_chars leaves `value` as it was
    return is_below_one(field) ? 0.0 : std::numeric_limits<double>::infinity();
  }
  if (error != std::errc{}) return std::nullopt;
  return value;
}

std::string quote(std::string_view field) {
  constexpr std::size_t kShown = 24;
  std::string text = "'";
  for (const char c : field.substr(0, kShown)) text += c >= ' ' && c <= '~' ? c : '?';
  return text + (field.size() > kShown ? "...'" : "'");
}

}  // namespace isotouch::cloud
