#include "host/motion/motion_csv.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <optional>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "host/cloud/text_lines.h"
#include "host/error.h"
#include "host/files/whole_file.h"
#include "shared/printable.h"

namespace isotouch::motion {

namespace {

struct Unit {
  std::string_view name;  ///< may be stated as an option
  double factor;
  std::vector<std::string_view> words;  ///< what else may stand for it in a column's name
};
struct Units {
  std::vector<Unit> units;
  std::string_view option;  ///< that states one; empty: there is none
  std::vector<std::string_view> quantity =
      {};  ///< words for what is measured, which may stand before the last word of a name where that is its axis
};
const Units kSeconds = {{{"s", 1.0, {"sec", "secs", "second", "seconds"}},
                         {"ms", 1e-3, {"msec", "msecs", "millis", "millisecond", "milliseconds"}},
                         {"us", 1e-6, {"µs", "μs", "usec", "usecs", "micros", "microsecond", "microseconds"}},
                         {"ns", 1e-9, {"nsec", "nsecs", "nanos", "nanosec", "nanosecs", "nanosecond", "nanoseconds"}}},
                        "--time-unit"};
const Units kMillimetres = {{{"mm", 1.0, {"millimetre", "millimetres", "millimeter", "millimeters"}},
                             {"cm", 10.0, {"centimetre", "centimetres", "centimeter", "centimeters"}},
                             {"m", 1000.0, {"metre", "metres", "meter", "meters"}},
                             {"in", 25.4, {"inch", "inches"}}},
                            "--length-unit"};
const Units kNewtons = {{{"N", 1.0, {"newton", "newtons"}}}, "", {"force", "forces", "f"}};
constexpr std::array<std::string_view, 6> kAxes = {"x", "y", "z", "fx", "fy", "fz"};

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view kBlank = " \r\"";
  const std::size_t first = text.find_first_not_of(kBlank);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlank) - first + 1);
}

/// A part of the file in a sentence: not longer than people read, and nothing that a terminal would obey.
std::string shortened(std::string_view text) {
  constexpr std::size_t kLongest = 60;
  std::string part(text.substr(0, kLongest));
  make_printable(part, '?');
  if (text.size() > kLongest) part += "…";
  return part;
}

std::string in_quotes(std::string_view text) {
  std::string sentence = "'";
  return sentence.append(shortened(text)).append("'");
}

std::vector<std::string_view> split(std::string_view line, char separator) {
  std::vector<std::string_view> fields;
  for (;;) {
    const std::size_t end = line.find(separator);
    fields.push_back(trimmed(line.substr(0, end)));
    if (end == std::string_view::npos) return fields;
    line.remove_prefix(end + 1);
  }
}

std::string names_of(const Units& units) {
  std::string names;
  for (const Unit& unit : units.units) names.append(names.empty() ? "" : " ").append(unit.name);
  return names;
}

/// The factor of a stated unit.
double stated_factor(const Units& units, const std::string& stated) {
  for (const Unit& unit : units.units) {
    if (unit.name == stated) return unit.factor;
  }
  throw UsageError("unknown unit " + in_quotes(stated) + "; choose one of: " + names_of(units));
}

/// Lines with their numbers, and the sentences that name them.
class Table {
 public:
  explicit Table(const std::filesystem::path& file) : name_(file.string()), in_(is_standard(file) ? "/dev/stdin" : file) {
    if (is_standard(file)) claim_standard_input();
    if (!in_ || std::filesystem::is_directory(file)) throw InputError(name_ + ": cannot be read; check the path and its permissions");
  }

  bool next() {
    while (read_line()) {
      if (number_ == 1 && line_.starts_with("\xEF\xBB\xBF")) line_.erase(0, 3);
      const std::string_view text = trimmed(line_);
      if (!text.empty() && text.front() != '#') return true;
    }
    if (in_.bad()) refuse_file("cannot be read to its end");
    return false;
  }
  const std::string& line() const { return line_; }
  [[noreturn]] void refuse(const std::string& what) const { throw InputError(name_ + ": line " + std::to_string(number_) + ": " + what); }
  [[noreturn]] void refuse_file(const std::string& what) const { throw InputError(name_ + ": " + what); }

 private:
  bool read_line() {
    ++number_;
    in_.getline(buffer_.data(), static_cast<std::streamsize>(buffer_.size()));
    const auto got = static_cast<std::size_t>(in_.gcount());
    if (in_.fail() && got + 1 == buffer_.size())
      refuse("has no end within 64 KiB; a header line and a row of numbers for each sample are expected");
    if (in_.fail()) return false;
    line_.assign(buffer_.data(), got > 0 && !in_.eof() ? got - 1 : got);
    return true;
  }

  std::string name_;
  std::ifstream in_;
  std::vector<char> buffer_ = std::vector<char>(std::size_t{64} << 10);
  std::string line_;
  std::size_t number_ = 0;
};

/// The last word of a name, and what stands before it. A word is made of letters, digits and what is not ASCII.
struct LastWord {
  std::string_view before, word;
};

LastWord last_word(std::string_view name) {
  const auto is_of_word = [](char c) { return (c & 0x80) != 0 || std::isalnum(static_cast<unsigned char>(c)) != 0; };
  while (!name.empty() && !is_of_word(name.back())) name.remove_suffix(1);
  std::size_t begin = name.size();
  while (begin > 0 && is_of_word(name[begin - 1])) --begin;
  return {name.substr(0, begin), name.substr(begin)};
}

/// No two units differ only by capital letters.
bool is_same_word(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](char x, char y) {
    return std::tolower(static_cast<unsigned char>(x)) == std::tolower(static_cast<unsigned char>(y));
  });
}

/// The factor of the unit that a column's name ends with, or that stands before an axis at its end; 1 for a name of one word.
double named_factor(const Table& table, const Units& units, std::string_view column) {
  const LastWord last = last_word(column);
  std::string_view before = last.before, word = last.word;
  const auto is_it = [&](std::string_view name) { return is_same_word(name, word); };
  const auto has_it = [&](const auto& words) { return std::any_of(words.begin(), words.end(), is_it); };
  if (!units.quantity.empty() && has_it(kAxes)) {
    word = last_word(before).word;
    if (word.empty() || has_it(units.quantity)) return 1.0;
    before = column;  // it has more than one word
  }
  const std::string give = units.option.empty() ? "" : "give the unit with " + std::string(units.option) + ", or ";
  for (const Unit& unit : units.units) {
    if (!is_it(unit.name) && !has_it(unit.words)) continue;
    if (before.empty() && unit.factor != 1.0)
      table.refuse("the name of the column " + in_quotes(column) + " is only a unit; " + give + "rename it");
    return unit.factor;
  }
  if (before.empty()) return 1.0;
  table.refuse("the name of the column " + in_quotes(column) + " ends with " +
               in_quotes(column.substr(static_cast<std::size_t>(word.data() - column.data()))) + ", which is none of the known units (" +
               names_of(units) + "); " + give + "convert the column if needed and rename it");
}

std::size_t find_column(const Table& table, const std::vector<std::string_view>& names, const std::string& wanted) {
  const auto found = std::find(names.begin(), names.end(), wanted);
  if (found != names.end()) {
    if (std::find(found + 1, names.end(), wanted) != names.end())
      table.refuse("two columns are called " + in_quotes(wanted) + "; rename one of them");
    return static_cast<std::size_t>(found - names.begin());
  }
  constexpr std::size_t kShown = 20;
  std::string present;
  for (std::size_t i = 0; i < std::min(names.size(), kShown); ++i) present.append(" ").append(shortened(names[i]));
  if (names.size() > kShown) present.append(" and ").append(std::to_string(names.size() - kShown)).append(" more");
  table.refuse("no column is called " + in_quotes(wanted) + ", there are:" + present + "; name them with --columns t=…,x=…,y=…,z=…");
}

double number(const Table& table, std::string_view field, std::string_view column) {
  const std::optional<double> value = cloud::as_number(field);
  if (cloud::with_decimal_commas(field) == 1)
    table.refuse(in_quotes(field) + " in column " + in_quotes(column) + " has a decimal comma; save the table with decimal points");
  if (!value || !std::isfinite(*value)) {
    table.refuse(in_quotes(field) + " in column " + in_quotes(column) + " is not a finite number; correct or remove the row");
  }
  return *value;
}

/// A time in two parts, because a double has too few digits for one since 1970: 0.2 us of its seconds, 256 of its nanoseconds.
struct Time {
  std::int64_t whole = 0;
  double part = 0;
};

/// value     what the field says
Time time_of(std::string_view field, double value) {
  const std::size_t point = std::min(field.find('.'), field.size());
  const std::string_view whole = field.substr(0, point), part = field.substr(std::min(point + 1, field.size()));
  Time time;
  const auto [end, failed] = std::from_chars(whole.data(), whole.data() + whole.size(), time.whole);
  const bool is_plain = std::all_of(part.begin(), part.end(), [](char c) { return c >= '0' && c <= '9'; });
  if (failed != std::errc() || end != whole.data() + whole.size() || !is_plain) return {0, value};  // such as .5 or 1e3
  if (!part.empty()) time.part = *cloud::as_number("0." + std::string(part)) * (field.front() == '-' ? -1 : 1);
  return time;
}

double between(const Time& from, const Time& to) {
  const auto whole = static_cast<std::int64_t>(static_cast<std::uint64_t>(to.whole) - static_cast<std::uint64_t>(from.whole));
  return static_cast<double>(whole) + (to.part - from.part);
}

}  // namespace

double millimetres_in(const std::string& unit) { return stated_factor(kMillimetres, unit); }

MotionColumns parse_columns(const std::string& text) {
  MotionColumns columns;
  if (text.empty()) return columns;
  for (const std::string_view part : split(text, ',')) {
    const std::size_t equals = part.find('=');
    const std::string_view key = part.substr(0, equals);
    const std::array<std::pair<std::string_view, std::string*>, 7> names = {{{"t", &columns.time},
                                                                             {"x", &columns.x},
                                                                             {"y", &columns.y},
                                                                             {"z", &columns.z},
                                                                             {"fx", &columns.fx},
                                                                             {"fy", &columns.fy},
                                                                             {"fz", &columns.fz}}};
    const auto found = std::find_if(names.begin(), names.end(), [&](const auto& n) { return n.first == key; });
    std::string* name = found == names.end() ? nullptr : found->second;
    if (equals == std::string_view::npos || name == nullptr || equals + 1 == part.size()) {
      throw UsageError(in_quotes(part) + " does not name a column; write --columns t=NAME,x=NAME,y=NAME,z=NAME, and fx, fy, fz for forces");
    }
    *name = part.substr(equals + 1);
  }
  return columns;
}

std::vector<TimedPoint> read_motion_csv(const std::filesystem::path& file, const MotionColumns& columns) {
  Table table(file);
  if (!table.next()) table.refuse_file("is empty; a header line with the columns' names and rows of numbers are expected");
  const std::string header = table.line();
  if (header.front() == '\x89' || header.find('\0') != std::string::npos) {
    table.refuse_file(std::string("is no text, but a table of times and positions is expected; ") +
                      (is_standard(file) ? "name a recording (MCAP, .db3) as a file, not through a pipe, or " : "") +
                      "export it as a table (CSV)");
  }
  const char separator = header.find('\t') != std::string::npos ? '\t' : header.find(';') != std::string::npos ? ';' : ',';
  const std::vector<std::string_view> names = split(header, separator);
  std::vector<std::size_t> at;
  for (const std::string* name : {&columns.time, &columns.x, &columns.y, &columns.z}) at.push_back(find_column(table, names, *name));
  if (columns.with_forces) {
    for (const std::string* name : {&columns.fx, &columns.fy, &columns.fz}) at.push_back(find_column(table, names, *name));
  }
  const double seconds =
      columns.time_unit.empty() ? named_factor(table, kSeconds, columns.time) : stated_factor(kSeconds, columns.time_unit);
  const double millimetres =
      columns.length_unit.empty() ? named_factor(table, kMillimetres, columns.x) : stated_factor(kMillimetres, columns.length_unit);
  for (const std::string* other : {&columns.y, &columns.z}) {
    if (columns.length_unit.empty() && named_factor(table, kMillimetres, *other) != millimetres)
      table.refuse("the columns " + in_quotes(columns.x) + " and " + in_quotes(*other) +
                   " have different units; write --length-unit for all three, or rename one");
  }
  for (const std::string* name : {&columns.fx, &columns.fy, &columns.fz}) {
    if (columns.with_forces) named_factor(table, kNewtons, *name);
  }

  std::vector<TimedPoint> points;
  Time begin;
  while (table.next()) {
    const std::vector<std::string_view> fields = split(table.line(), separator);
    if (fields.size() != names.size()) {
      table.refuse("has " + std::to_string(fields.size()) + " fields where the header names " + std::to_string(names.size()) +
                   "; correct or remove the row");
    }
    std::array<double, 7> value{};
    for (std::size_t i = 0; i < at.size(); ++i) value[i] = number(table, fields[at[i]], names[at[i]]);
    const Time time = time_of(fields[at[0]], value[0]);
    if (points.empty()) begin = time;
    const TimedPoint point{seconds * between(begin, time), millimetres * Eigen::Vector3d(value[1], value[2], value[3]),
                           Eigen::Vector3d(value[4], value[5], value[6])};
    if (!point.position.allFinite()) table.refuse("the place is farther away than a number can say; correct the row or the unit");
    if (!points.empty() && point.time <= points.back().time) {
      table.refuse("the time " + shortened(fields[at[0]]) +
                   " does not come after that of the row before; sort the rows or remove this one");
    }
    points.push_back(point);
  }
  if (points.size() < 2) table.refuse_file("holds " + std::to_string(points.size()) + " rows; a motion needs at least two");
  return points;
}

}  // namespace isotouch::motion
