#include "host/motion/motion_csv.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <optional>
#include <string_view>
#include <utility>

#include "host/cloud/text_lines.h"
#include "host/error.h"
#include "host/files/whole_file.h"

namespace isotouch::motion {

namespace {

using Factor = std::pair<std::string_view, double>;
using Factors = std::vector<Factor>;
constexpr std::size_t kStated = 4;  // may be stated as an option; behind them is what else the endings of names say
const Factors kSeconds = {
    {"s", 1.0},       {"ms", 1e-3},           {"us", 1e-6},    {"ns", 1e-9},     {"sec", 1.0},           {"secs", 1.0},
    {"seconds", 1.0}, {"msec", 1e-3},         {"msecs", 1e-3}, {"millis", 1e-3}, {"milliseconds", 1e-3}, {"usec", 1e-6},
    {"micros", 1e-6}, {"microseconds", 1e-6}, {"nsec", 1e-9},  {"nanos", 1e-9},  {"nanoseconds", 1e-9}};
const Factors kMillimetres = {{"mm", 1.0},          {"cm", 10.0},         {"m", 1000.0},         {"in", 25.4},
                              {"millimetres", 1.0}, {"millimeters", 1.0}, {"centimetres", 10.0}, {"centimeters", 10.0},
                              {"metres", 1000.0},   {"meters", 1000.0},   {"inch", 25.4},        {"inches", 25.4}};

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view kBlank = " \r\"";
  const std::size_t first = text.find_first_not_of(kBlank);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlank) - first + 1);
}

std::string in_quotes(std::string_view text) {
  std::string sentence = "'";
  return sentence.append(text).append("'");
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

/// The factor of a stated unit.
double stated_factor(const Factors& factors, const std::string& stated) {
  const auto end = factors.begin() + kStated;
  const auto found = std::find_if(factors.begin(), end, [&](const Factor& f) { return f.first == stated; });
  if (found != end) return found->second;
  std::string known;
  std::for_each(factors.begin(), end, [&](const Factor& f) { known.append(" ").append(f.first); });
  throw InputError("unknown unit " + in_quotes(stated) + "; choose one of:" + known);
}

/// The factor of the unit that a column's name ends with, else 1.
double named_factor(const Factors& factors, std::string_view column) {
  const std::size_t ending = column.rfind('_');
  if (ending == std::string_view::npos) return 1.0;
  const auto found = std::find_if(factors.begin(), factors.end(), [&](const Factor& f) { return f.first == column.substr(ending + 1); });
  return found == factors.end() ? 1.0 : found->second;
}

/// Lines with their numbers, and the sentences that name them.
class Table {
 public:
  explicit Table(const std::filesystem::path& file) : name_(file.string()), in_(is_standard(file) ? "/dev/stdin" : file) {
    if (is_standard(file)) claim_standard_input();
    if (!in_ || std::filesystem::is_directory(file)) throw InputError(name_ + ": cannot be read; check the path and its permissions");
  }

  bool next() {
    while (std::getline(in_, line_)) {
      ++number_;
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
  std::string name_;
  std::ifstream in_;
  std::string line_;
  std::size_t number_ = 0;
};

std::size_t find_column(const Table& table, const std::vector<std::string_view>& names, const std::string& wanted) {
  const auto found = std::find(names.begin(), names.end(), wanted);
  if (found != names.end()) {
    if (std::find(found + 1, names.end(), wanted) != names.end())
      table.refuse("two columns are called " + in_quotes(wanted) + "; rename one of them");
    return static_cast<std::size_t>(found - names.begin());
  }
  std::string present;
  for (const std::string_view name : names) present.append(" ").append(name);
  table.refuse("no column is called " + in_quotes(wanted) + ", there are:" + present + "; name them with --columns t=…,x=…,y=…,z=…");
}

double number(const Table& table, std::string_view field, std::string_view column) {
  const std::optional<double> value = cloud::as_number(field);
  if (!value || !std::isfinite(*value)) {
    table.refuse(in_quotes(field) + " in column " + in_quotes(column) + " is not a finite number; correct or remove the row");
  }
  return *value;
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
      throw InputError(in_quotes(part) + " does not name a column; write --columns t=NAME,x=NAME,y=NAME,z=NAME, and fx, fy, fz for forces");
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
    table.refuse_file(
        "is no text, but a table of times and positions is expected; name a recording (MCAP, .db3) as a file, not through a pipe");
  }
  const char separator = header.find('\t') != std::string::npos ? '\t' : header.find(';') != std::string::npos ? ';' : ',';
  const std::vector<std::string_view> names = split(header, separator);
  std::vector<std::size_t> at;
  for (const std::string* name : {&columns.time, &columns.x, &columns.y, &columns.z}) at.push_back(find_column(table, names, *name));
  if (columns.with_forces) {
    for (const std::string* name : {&columns.fx, &columns.fy, &columns.fz}) at.push_back(find_column(table, names, *name));
  }
  const double seconds = columns.time_unit.empty() ? named_factor(kSeconds, columns.time) : stated_factor(kSeconds, columns.time_unit);
  const double millimetres =
      columns.length_unit.empty() ? named_factor(kMillimetres, columns.x) : stated_factor(kMillimetres, columns.length_unit);
  for (const std::string* other : {&columns.y, &columns.z}) {
    if (columns.length_unit.empty() && named_factor(kMillimetres, *other) != millimetres)
      table.refuse("the columns " + in_quotes(columns.x) + " and " + in_quotes(*other) +
                   " have different units; write --length-unit for all three, or rename one");
  }

  std::vector<TimedPoint> points;
  while (table.next()) {
    const std::vector<std::string_view> fields = split(table.line(), separator);
    if (fields.size() != names.size()) {
      table.refuse("has " + std::to_string(fields.size()) + " fields where the header names " + std::to_string(names.size()) +
                   "; correct or remove the row");
    }
    std::array<double, 7> value{};
    for (std::size_t i = 0; i < at.size(); ++i) value[i] = number(table, fields[at[i]], names[at[i]]);
    const TimedPoint point{seconds * value[0], millimetres * Eigen::Vector3d(value[1], value[2], value[3]),
                           Eigen::Vector3d(value[4], value[5], value[6])};
    if (!points.empty() && point.time <= points.back().time) {
      table.refuse("the time " + std::string(fields[at[0]]) +
                   " does not come after that of the row before; sort the rows or remove this one");
    }
    points.push_back(point);
  }
  if (points.size() < 2) table.refuse_file("holds " + std::to_string(points.size()) + " rows; a motion needs at least two");
  return points;
}

}  // namespace isotouch::motion
