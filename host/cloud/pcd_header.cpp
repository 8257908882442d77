#include "host/cloud/pcd_header.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <string_view>
#include <system_error>
#include <utility>

#include "host/cloud/computable.h"
#include "host/cloud/point_columns.h"
#include "host/cloud/text_lines.h"

namespace isotouch::cloud {
namespace {

constexpr std::size_t kMaxCount = 65536;  // numbers in one field; PCL's longest descriptor has 1980

std::size_t whole(const TextLines& lines, std::string_view text, std::string_view what, std::size_t high) {
  std::size_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || value > high) {
    throw lines.refusal(std::string(what) + " is " + quote(text) + ", not a whole number from 0 to " + std::to_string(high));
  }
  return value;
}

std::size_t single(TextLines& lines, std::string_view what) {
  return whole(lines, lines.field().value_or(""), what, std::numeric_limits<std::uint32_t>::max());
}

/// One word for each field.
template <class Set>
void for_each_field(TextLines& lines, std::string_view what, PcdHeader& header, const Set& set) {
  for (PcdField& field : header.fields) {
    const auto word = lines.field();
    if (!word) throw lines.refusal(std::string(what) + " names fewer fields than FIELDS");
    set(field, *word);
  }
  if (lines.field()) throw lines.refusal(std::string(what) + " names more fields than FIELDS");
}

void read_viewpoint(TextLines& lines, PcdHeader& header) {
  std::array<double, 7> values{};
  for (double& value : values) {
    value = lines.number("a number of the viewpoint");
    if (!std::isfinite(value)) throw lines.refusal("a number of the viewpoint is not finite");
  }
  if (const auto extra = lines.field()) throw lines.refusal(quote(*extra) + " follows the last number of the viewpoint");
  if (!is_computable({values[0], values[1], values[2]})) throw lines.refusal("the viewpoint is farther away than 1e100");
  header.viewpoint.reset();
  if (values[0] == 0.0 && values[1] == 0.0 && values[2] == 0.0) return;  // as written by programs that know of no sensor
  header.viewpoint.emplace(values[0], values[1], values[2]);
  header.is_turned = values[4] != 0.0 || values[5] != 0.0 || values[6] != 0.0;
}

PcdData data(TextLines& lines) {
  const std::string_view name = lines.field().value_or("");
  if (name == "ascii") return PcdData::kAscii;
  if (name == "binary") return PcdData::kBinary;
  if (name == "binary_compressed") return PcdData::kCompressed;
  throw lines.refusal("PCD data " + quote(name) + " is unknown; it may be ascii, binary or binary_compressed");
}

void check_fields(const std::string& name, PcdHeader& header) {
  constexpr std::array<const char*, kPointColumns> kNames = {"x", "y", "z", "normal_x", "normal_y", "normal_z", "stiffness"};
  std::array<const PcdField*, kPointColumns> found{};
  drop_second_names(header.fields, kNames);
  for (const PcdField& field : header.fields) {
    const auto column = point_column(field.name);
    if (!column) continue;
    if (const PcdField* other = std::exchange(found[*column], &field)) {
      throw InputError(name + ": " +
                       (other->name == field.name
                            ? "field " + quote(field.name) + " is declared twice"
                            : "fields " + quote(other->name) + " and " + quote(field.name) + " are the same; remove one of them"));
    }
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (!found[axis]) throw InputError(name + ": the PCD header names no field '" + kNames[axis] + "'; points need x, y and z");
  }
  const auto normals = 3 - std::count(found.begin() + 3, found.begin() + kStiffnessColumn, nullptr);
  if (normals != 0 && normals != 3)
    throw InputError(name + ": the PCD header names only a part of normal_x, normal_y, normal_z; a normal needs all three");
  header.has_normals = normals == 3;
  header.has_stiffness = found[kStiffnessColumn] != nullptr;
  for (const PcdField& field : header.fields) {
    if (point_column(field.name) && field.count != 1)
      throw InputError(name + ": field " + quote(field.name) + " has " + std::to_string(field.count) + " numbers, not one");
    const bool known =
        field.type == 'F' ? field.size == 4 || field.size == 8 : field.size == 1 || field.size == 2 || field.size == 4 || field.size == 8;
    if (!known) {
      throw InputError(name + ": field " + quote(field.name) + " has TYPE " + field.type + " and SIZE " + std::to_string(field.size) +
                       ", which are no number type");
    }
  }
}

/// Width, height and points, of which old files state a part.
void check_counts(const std::string& name, PcdHeader& header, bool has_width, bool has_points) {
  if (!has_width) header.width = header.height > 0 ? header.points / header.height : 0;
  const std::uint64_t product = std::uint64_t{header.width} * header.height;  // each below 2^32
  if (!has_points) header.points = static_cast<std::size_t>(std::min<std::uint64_t>(product, std::numeric_limits<std::uint32_t>::max()));
  if (product != header.points) {
    throw InputError(name + ": WIDTH " + std::to_string(header.width) + " times HEIGHT " + std::to_string(header.height) +
                     " is not POINTS " + std::to_string(header.points));
  }
}

}  // namespace

PcdHeader read_pcd_header(const std::string& name, std::span<const std::uint8_t> bytes) {
  TextLines lines(name, bytes);
  PcdHeader header;
  bool has_width = false, has_points = false, has_sizes = false, has_types = false;
  while (lines.next()) {
    const std::string_view keyword = lines.field().value_or("");
    if (keyword.empty() || keyword.starts_with('#') || keyword == "VERSION") continue;
    if (keyword == "FIELDS" || keyword == "COLUMNS") {
      if (!header.fields.empty()) throw lines.refusal(std::string(keyword) + " is declared twice");
      while (const auto field = lines.field()) header.fields.push_back({.name = std::string(*field)});
    } else if (keyword == "SIZE") {
      has_sizes = true;
      for_each_field(lines, keyword, header, [&](PcdField& f, std::string_view word) { f.size = whole(lines, word, "a size", 8); });
    } else if (keyword == "TYPE") {
      has_types = true;
      for_each_field(lines, keyword, header, [&](PcdField& f, std::string_view word) {
        if (word != "F" && word != "I" && word != "U")
          throw lines.refusal("type " + quote(word) + " is unknown to PCD; it may be F, I or U");
        f.type = word[0];
      });
    } else if (keyword == "COUNT") {
      for_each_field(lines, keyword, header, [&](PcdField& f, std::string_view word) {
        f.count = whole(lines, word, "a count", kMaxCount);
        if (f.count == 0) throw lines.refusal("field " + quote(f.name) + " has a count of 0");
      });
    } else if (keyword == "WIDTH") {
      has_width = true;
      header.width = single(lines, keyword);
    } else if (keyword == "HEIGHT") {
      header.height = single(lines, keyword);
    } else if (keyword == "VIEWPOINT") {
      read_viewpoint(lines, header);
    } else if (keyword == "POINTS") {
      has_points = true;
      header.points = single(lines, keyword);
    } else if (keyword == "DATA") {
      header.data = data(lines);
      header.bytes = lines.bytes_read();
      if (!has_sizes || !has_types) throw InputError(name + ": the PCD header has no line " + (has_sizes ? "TYPE" : "SIZE"));
      check_fields(name, header);
      check_counts(name, header, has_width, has_points);
      return header;
    } else {
      throw lines.refusal(quote(keyword) + " is no keyword of a PCD header");
    }
  }
  throw InputError(name + ": the file ends within its PCD header; there is no line DATA");
}

}  // namespace isotouch::cloud
