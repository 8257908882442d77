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
  std::size_t others = 0;       ///< columns with other names
  bool stiffness = false;
  bool remark = false;
  bool in_order = true;       ///< x, y, z, then the normal, then the stiffness: as without names
  std::string contradiction;  ///< what to refuse them with
  char separator = '\0';      ///< of cells, as `cells_of` takes it
};

/// Cells may be empty only where one character separates them. Several tabs together bring columns under each other.
char separator_in(std::string_view names) {
  for (const char c : {';', ','}) {
    if (names.find(c) != std::string_view::npos) return c;
  }
  return names.find('\t') != std::string_view::npos && names.find("\t\t") == std::string_view::npos ? '\t' : '\0';
}

/// What a file is read for.
enum class Wanted { kPoints, kPositions };

/// Nothing where the text does not name x, y and z; a remark, which may be a sentence, must name a normal, too, or hold no other word.
std::optional<Names> names_in(std::string_view text, Names names, Wanted wanted) {
  for (const std::string_view cell : cells_of(text, names.separator)) {
    std::string name(cell);
    std::erase(name, '"');
    names.columns.push_back({name});
  }
  while (!names.columns.empty() && names.columns.back().name.empty()) names.columns.pop_back();
  drop_second_names(names.columns, {"x", "y", "z", "nx", "ny", "nz", "stiffness"});
  const std::size_t counts = wanted == Wanted::kPositions ? 3 : kPointColumns;
  std::array<std::optional<std::size_t>, kPointColumns> found;
  bool is_twice = false, is_sentence = false;
  std::size_t first = 0, second = 0;
  for (std::size_t i = 0; i < names.columns.size(); ++i) {
    const auto column = point_column(names.columns[i].name);
    is_sentence |= !column;
    if (!column && !names.columns[i].name.empty()) ++names.others;
    if (!column) continue;
    if (found[*column] && *column < counts && !is_twice) is_twice = true, first = *found[*column], second = i;
    if (!found[*column]) found[*column] = i;
  }
  if (!found[0] || !found[1] || !found[2]) return std::nullopt;
  const auto normals = 3 - std::count(found.begin() + 3, found.begin() + kStiffnessColumn, std::nullopt);
  const bool is_part = wanted == Wanted::kPoints && normals != 0 && normals != 3;
  if (names.remark && (is_twice || is_part || (is_sentence && normals == 0))) return std::nullopt;
  if (is_twice) {
    names.contradiction =
        "columns " + quote(names.columns[first].name) + " and " + quote(names.columns[second].name) + " are the same; remove one of them";
  } else if (is_part) {
    names.contradiction = "only a part of nx, ny, nz is named; a normal needs all three";
  }
  for (const auto& column : found) {
    if (column) names.of.push_back(*column);
  }
  names.in_order = std::is_sorted(names.of.begin(), names.of.end());
  if (wanted == Wanted::kPositions) names.of.resize(3);
  names.stiffness = wanted == Wanted::kPoints && found[kStiffnessColumn];
  return names;
}

/// Whether names that are split at every blank and separator say more than the same names that one separator splits.
bool is_better(const std::optional<Names>& split, const std::optional<Names>& cells) {
  if (!split || !cells) return split.has_value();
  if (!split->contradiction.empty() || !cells->contradiction.empty()) return split->contradiction.empty();
  return split->of.size() > cells->of.size() && split->others < cells->others;
}

/// fails     InputError: a column is named twice, or only a part of a normal is
std::optional<Names> names_of(const TextLines& line, Wanted wanted) {
  std::string_view text = line.rest();
  Names names;
  names.remark = is_remark(text);
  if (names.remark) text.remove_prefix(std::min(text.find_first_not_of(" \t#/"), text.size()));
  std::optional<Names> found = names_in(text, names, wanted);
  if (const char separator = separator_in(text)) {
    names.separator = separator;
    std::optional<Names> cells = names_in(text, std::move(names), wanted);
    if (!is_better(found, cells)) found = std::move(cells);
  }
  if (found && !found->contradiction.empty()) throw line.refusal(found->contradiction);
  return found;
}

/// The numbers of a point in a line of as many cells as there are names; nothing where it has another number of cells.
std::optional<std::vector<double>> named_row(const TextLines& line, const Names& names) {
  std::vector<std::string_view> cells = cells_of(line.rest(), names.separator);
  while (cells.size() > names.columns.size() && cells.back().empty()) cells.pop_back();
  if (cells.size() != names.columns.size() && names.separator == '\t') cells = cells_of(line.rest(), '\0');  // a tab is a blank, too
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

/// fails     InputError: the line begins with something other than a number, as a line of names does
void refuse_word(TextLines line) {
  const auto field = line.field();
  if (!field || as_number(*field)) return;
  throw line.refusal(quote(*field) + " is no number; a coordinate should stand there, or a first line must name the columns x, y and z");
}

Table read_table(const std::string& name, std::span<const std::uint8_t> bytes, Wanted wanted) {
  if (is_utf16(bytes)) throw InputError(name + ": the text is encoded as UTF-16; save it as UTF-8");
  TextLines lines(name, bytes);
  Table table;
  std::size_t columns = 0;
  std::optional<Names> names;
  while (lines.next()) {
    if (table.lines.empty() && !table.count && !names && (names = names_of(lines, wanted))) continue;
    if (is_remark(lines.rest())) continue;
    if (table.lines.empty() && !table.count && (table.count = stated_count(lines))) continue;
    if (const std::size_t fields = table.lines.empty() ? with_decimal_commas(lines.rest()) : 0; fields == 3 || fields == 6)
      throw decimal_commas(lines);
    std::vector<double> row;
    if (names) {
      const auto named = named_row(lines, *names);
      const bool is_doubted = names->remark && table.lines.empty();
      if (!named && !(is_doubted && names->in_order)) {
        throw lines.refusal(
            "not " + std::to_string(names->columns.size()) + " values, as many " +
            (is_doubted ? "columns as a remark above names; correct that remark or remove it" : "as the line of names has"));
      }
      if (named) row = *named;
      if (!named) names.reset();  // a remark that only looked like names
    }
    if (!names) {
      if (table.lines.empty()) refuse_word(lines);
      TextLines rest = lines;
      const std::size_t most = wanted == Wanted::kPositions ? 3 : 7;
      while (row.size() < most && (rest.field() || wanted == Wanted::kPositions)) row.push_back(lines.number("a coordinate"));
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
      const std::string needed = table.lines.empty()
                                     ? "x y z or x y z nx ny nz, or a first line must name the columns, such as x y z intensity"
                                 : columns == 3 ? "x y z like the lines before; correct or remove it"
                                                : "x y z nx ny nz like the lines before; correct or remove it";
      throw lines.refusal((row.size() > 6 ? "more than 6" : std::to_string(row.size())) + " numbers; a line must hold " + needed);
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

void check_count(const std::string& name, const Table& table) {
  if (table.count && *table.count != table.first.size()) {
    throw InputError(name + ": its first line states " + std::to_string(*table.count) + " points, but " +
                     std::to_string(table.first.size()) + " follow; correct it, or copy the file again");
  }
}

}  // namespace

Model read_xyz(const std::string& name, std::span<const std::uint8_t> bytes) {
  Table table = read_table(name, bytes, Wanted::kPoints);
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
  check_count(name, table);
  Model model{"text", std::move(table.first), std::move(table.second), std::move(table.lines), {}};
  model.stiffness = std::move(table.stiffness);
  return model;
}

std::vector<Eigen::Vector3d> read_xyz_positions(const std::string& name, std::span<const std::uint8_t> bytes) {
  Table table = read_table(name, bytes, Wanted::kPositions);
  check_count(name, table);
  return std::move(table.first);
}

}  // namespace isotouch::cloud
