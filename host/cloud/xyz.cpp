#include "host/cloud/xyz.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <string_view>
#include <system_error>
#include <vector>

#include "host/cloud/point_columns.h"
#include "host/cloud/text_lines.h"

namespace isotouch::cloud {
namespace {

/// A whole number in a line of its own.
std::optional<std::size_t> stated_count(TextLines line) {
  const auto field = line.field();
  if (!field || line.field() || field->find_first_not_of("0123456789") != std::string_view::npos) return std::nullopt;
  std::size_t count = 0;
  const auto [end, error] = std::from_chars(field->data(), field->data() + field->size(), count);
  return error == std::errc{} ? count : std::numeric_limits<std::size_t>::max();
}

bool is_remark(std::string_view line) {
  const std::size_t begin = line.find_first_not_of(" \t");
  return begin == std::string_view::npos || line[begin] == '#' || line.substr(begin).starts_with("//");
}

bool is_utf16(std::span<const std::uint8_t> bytes) {
  return bytes.size() >= 2 && ((bytes[0] == 0xFF && bytes[1] == 0xFE) || (bytes[0] == 0xFE && bytes[1] == 0xFF));
}

/// Which columns a line of names gives to a point. It may be a remark.
struct Names {
  std::size_t columns = 0;
  std::array<std::size_t, 6> of = {};  ///< the column of x, y, z, and of the normal where there is one
  bool normals = false;
  bool remark = false;
};

/// Nothing where the line does not name x, y and z; a remark, which may be a sentence, must name a normal, too.
std::optional<Names> names_of(TextLines line) {
  Names names;
  std::array<bool, 6> found{};
  while (const std::optional<std::string_view> field = line.field()) {
    std::string word;
    for (const char c : *field) {
      if (c != '"' && (names.columns > 0 || (c != '#' && c != '/'))) word += c;
    }
    names.remark |= names.columns == 0 && (field->starts_with('#') || field->starts_with("//"));
    if (word.empty() && names.columns == 0) continue;
    if (const auto column = point_column(word); column && !found[*column]) {
      found[*column] = true;
      names.of[*column] = names.columns;
    }
    ++names.columns;
  }
  names.normals = found[3] && found[4] && found[5];
  return found[0] && found[1] && found[2] && (names.normals || !names.remark) ? std::optional(names) : std::nullopt;
}

/// The numbers of a point in a line of as many fields as there are names; nothing where it has another number of fields.
std::optional<std::vector<double>> named_row(TextLines& line, const Names& names) {
  std::vector<TextLines> fields(names.columns, line);
  TextLines rest = line;
  for (TextLines& field : fields) {
    field = rest;
    if (!rest.field()) return std::nullopt;
  }
  if (rest.field()) return std::nullopt;
  std::vector<double> row;
  for (std::size_t i = 0; i < (names.normals ? 6 : 3); ++i) row.push_back(fields[names.of[i]].number("a coordinate"));
  return row;
}

/// The file as a table of three or six columns.
struct Table {
  std::vector<Eigen::Vector3d> first, second;  ///< columns 1 to 3, columns 4 to 6
  std::vector<std::size_t> lines;
  std::optional<std::size_t> count;
  bool is_named = false;  ///< a line of names says what the columns hold
};

Table read_table(const std::string& name, std::span<const std::uint8_t> bytes) {
  TextLines lines(name, bytes);
  Table table;
  std::size_t columns = 0;
  std::optional<Names> names;
  while (lines.next()) {
    if (table.lines.empty() && !table.count && !names && (names = names_of(lines))) continue;
    if (is_remark(lines.rest())) continue;
    if (table.lines.empty() && !table.count && (table.count = stated_count(lines))) continue;
    if (const std::size_t fields = table.lines.empty() ? with_decimal_commas(lines.rest()) : 0; fields == 3 || fields == 6)
      throw decimal_commas(lines);
    std::vector<double> row;
    if (names) {
      const auto named = named_row(lines, *names);
      if (!named && !(names->remark && table.lines.empty()))
        throw lines.refusal("not " + std::to_string(names->columns) + " values, as many as the line of names has");
      if (named) row = *named;
      if (!named) names.reset();  // a remark that only looked like names
    }
    if (!names) {
      TextLines rest = lines;
      while (rest.field() && row.size() < 7) row.push_back(lines.number("a coordinate"));
    }
    for (std::size_t i = 0; i < std::min<std::size_t>(row.size(), 3); ++i) {
      if (!std::isfinite(row[i]))
        throw lines.refusal("number " + std::to_string(i + 1) + " is not a finite number; correct or remove the line");
    }
    if (columns == 0) columns = row.size();
    if ((columns != 3 && columns != 6) || row.size() != columns) {
      const std::string wanted = table.lines.empty()
                                     ? "x y z or x y z nx ny nz, or a first line must name the columns, such as x y z intensity"
                                 : columns == 3 ? "x y z like the lines before; correct or remove it"
                                                : "x y z nx ny nz like the lines before; correct or remove it";
      throw lines.refusal((row.size() > 6 ? "more than 6" : std::to_string(row.size())) + " numbers; a line must hold " + wanted);
    }
    table.is_named = names.has_value();
    table.first.emplace_back(row[0], row[1], row[2]);
    if (columns == 6) table.second.push_back(known_or_zero({row[3], row[4], row[5]}));
    table.lines.push_back(lines.line());
  }
  return table;
}

/// Numbers that are never negative and mostly not of length 1 are no normals, but colours, say.
bool are_colours(const std::vector<Eigen::Vector3d>& columns) {
  constexpr double kOff = 0.05;  // of a length: more than a file's few digits
  const auto positive = [](const Eigen::Vector3d& c) { return c.minCoeff() >= 0.0; };
  const auto off = [](const Eigen::Vector3d& c) { return !c.isZero(0.0) && std::abs(c.norm() - 1.0) > kOff; };
  return std::all_of(columns.begin(), columns.end(), positive) &&
         2 * static_cast<std::size_t>(std::count_if(columns.begin(), columns.end(), off)) > columns.size();
}

}  // namespace

Model read_xyz(const std::string& name, std::span<const std::uint8_t> bytes) {
  if (is_utf16(bytes)) throw InputError(name + ": the text is encoded as UTF-16; save it as UTF-8");
  Table table = read_table(name, bytes);
  if (!table.is_named && are_colours(table.second)) {
    throw InputError(name +
                     ": the numbers in columns 4 to 6 are never negative and not of length 1, as colours are and normals are not; "
                     "remove these columns, or name all in a first line: x,y,z,nx,ny,nz");
  }
  if (table.count && table.second.empty() && table.first.size() % 2 == 0 &&
      table.first.size() / 2 == *table.count) {  // a block of positions, a block of normals
    const auto half = static_cast<std::ptrdiff_t>(*table.count);
    table.second.assign(table.first.begin() + half, table.first.end());
    table.first.resize(*table.count);
    table.lines.resize(*table.count);
  }
  if (table.count && *table.count != table.first.size()) {
    throw InputError(name + ": its first line states " + std::to_string(*table.count) + " points, but " +
                     std::to_string(table.first.size()) + " follow; correct it, or copy the file again");
  }
  return {"text", std::move(table.first), std::move(table.second), std::move(table.lines), {}};
}

}  // namespace isotouch::cloud
