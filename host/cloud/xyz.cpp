#include "host/cloud/xyz.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
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
  struct Column {
    std::string name;
  };
  std::vector<Column> columns;
  std::vector<std::size_t> of;  ///< the columns of x, y, z, then of the normal and of the stiffness where they are there
  bool stiffness = false;
  bool remark = false;
  char separator = '\0';  ///< of cells, as `cells_of` takes it
};

/// Cells may be empty only where one character separates them. Several tabs together bring columns under each other.
char separator_in(std::string_view names) {
  for (const char c : {';', ','}) {
    if (names.find(c) != std::string_view::npos) return c;
  }
  return names.find('\t') != std::string_view::npos && names.find("\t\t") == std::string_view::npos ? '\t' : '\0';
}

/// Nothing where the line does not name x, y and z; a remark, which may be a sentence, must name a normal, too, or hold no other word.
///
/// fails     InputError: a column is named twice, or only a part of a normal is
std::optional<Names> names_in(const TextLines& line, std::string_view text, Names names) {
  for (const std::string_view cell : cells_of(text, names.separator)) {
    std::string name(cell);
    std::erase(name, '"');
    names.columns.push_back({name});
  }
  while (!names.columns.empty() && names.columns.back().name.empty()) names.columns.pop_back();
  drop_second_names(names.columns, {"x", "y", "z", "nx", "ny", "nz", "stiffness"});
  std::array<std::optional<std::size_t>, kPointColumns> found;
  bool is_twice = false, is_sentence = false;
  std::size_t first = 0, second = 0;
  for (std::size_t i = 0; i < names.columns.size(); ++i) {
    const auto column = point_column(names.columns[i].name);
    is_sentence |= !column;
    if (!column) continue;
    if (found[*column] && !is_twice) is_twice = true, first = *found[*column], second = i;
    if (!found[*column]) found[*column] = i;
  }
  if (!found[0] || !found[1] || !found[2]) return std::nullopt;
  const auto normals = 3 - std::count(found.begin() + 3, found.begin() + kStiffnessColumn, std::nullopt);
  const bool is_part = normals != 0 && normals != 3;
  if (names.remark && (is_twice || is_part || (is_sentence && normals == 0))) return std::nullopt;
  if (is_twice) {
    throw line.refusal("columns " + quote(names.columns[first].name) + " and " + quote(names.columns[second].name) +
                       " are the same; remove one of them");
  }
  if (is_part) throw line.refusal("only a part of nx, ny, nz is named; a normal needs all three");
  for (const auto& column : found) {
    if (column) names.of.push_back(*column);
  }
  names.stiffness = found[kStiffnessColumn].has_value();
  return names;
}

std::optional<Names> names_of(const TextLines& line) {
  std::string_view text = line.rest();
  Names names;
  names.remark = is_remark(text);
  if (names.remark) text.remove_prefix(std::min(text.find_first_not_of(" \t#/"), text.size()));
  if (const char separator = separator_in(text)) {
    Names cells = names;
    cells.separator = separator;
    if (std::optional<Names> found = names_in(line, text, std::move(cells))) return found;
  }
  return names_in(line, text, std::move(names));
}

/// The numbers of a point in a line of as many cells as there are names; nothing where it has another number of cells.
std::optional<std::vector<double>> named_row(const TextLines& line, const Names& names) {
  std::vector<std::string_view> cells = cells_of(line.rest(), names.separator);
  while (cells.size() > names.columns.size() && cells.back().empty()) cells.pop_back();
  if (cells.size() != names.columns.size()) return std::nullopt;
  std::vector<double> row;
  for (const std::size_t column : names.of) {
    const std::optional<double> value = as_number(cells[column]);
    if (!value) throw line.refusal(quote(cells[column]) + " is no number; " + quote(names.columns[column].name) + " should stand there");
    row.push_back(*value);
  }
  return row;
}

/// The file as a table of three or six columns, and of one more where it is named.
struct Table {
  std::vector<Eigen::Vector3d> first, second;  ///< columns 1 to 3, columns 4 to 6
  std::vector<double> stiffness;
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
        throw lines.refusal("not " + std::to_string(names->columns.size()) + " values, as many as the line of names has");
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
    if (names && names->stiffness) {
      table.stiffness.push_back(row.back());
      row.pop_back();
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
  if (table.count && table.second.empty() && table.stiffness.empty() && table.first.size() % 2 == 0 &&
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
  Model model{"text", std::move(table.first), std::move(table.second), std::move(table.lines), {}};
  model.stiffness = std::move(table.stiffness);
  return model;
}

}  // namespace isotouch::cloud
