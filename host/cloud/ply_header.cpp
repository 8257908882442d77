#include "host/cloud/ply_header.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <string_view>
#include <system_error>
#include <utility>

#include "host/cloud/point_columns.h"
#include "host/cloud/text_lines.h"

namespace isotouch::cloud {
namespace {

std::string_view word(TextLines& lines, const std::string& what) {
  const auto field = lines.field();
  if (!field) throw lines.refusal("the line ends where " + what + " should stand");
  return *field;
}

PlyEncoding encoding(TextLines& lines) {
  const std::string_view name = word(lines, "the format");
  const std::string_view version = word(lines, "the format's version");
  if (version != "1.0") throw lines.refusal("PLY version " + quote(version) + " is unknown; save the file as PLY 1.0");
  if (name == "ascii") return PlyEncoding::kAscii;
  if (name == "binary_little_endian") return PlyEncoding::kLittleEndian;
  if (name == "binary_big_endian") return PlyEncoding::kBigEndian;
  throw lines.refusal("PLY format " + quote(name) + " is unknown; it may be ascii, binary_little_endian or binary_big_endian");
}

PlyType type(TextLines& lines) {
  constexpr std::array<std::pair<std::string_view, PlyType>, 16> kTypes = {{
      {"char", PlyType::kInt8},
      {"uchar", PlyType::kUint8},
      {"short", PlyType::kInt16},
      {"ushort", PlyType::kUint16},
      {"int", PlyType::kInt32},
      {"uint", PlyType::kUint32},
      {"float", PlyType::kFloat32},
      {"double", PlyType::kFloat64},
      {"int8", PlyType::kInt8},
      {"uint8", PlyType::kUint8},
      {"int16", PlyType::kInt16},
      {"uint16", PlyType::kUint16},
      {"int32", PlyType::kInt32},
      {"uint32", PlyType::kUint32},
      {"float32", PlyType::kFloat32},
      {"float64", PlyType::kFloat64},
  }};
  const std::string_view name = word(lines, "a number type");
  for (const auto& [known, value] : kTypes) {
    if (name == known) return value;
  }
  throw lines.refusal("number type " + quote(name) + " is unknown to PLY");
}

PlyElement element(TextLines& lines, const PlyHeader& header) {
  PlyElement element;
  element.name = word(lines, "the element's name");
  const std::string_view count = word(lines, "the element's count");
  const auto [end, error] = std::from_chars(count.data(), count.data() + count.size(), element.count);
  if (error != std::errc{} || end != count.data() + count.size()) {
    throw lines.refusal("the count of element " + quote(element.name) + " is " + quote(count) + ", not a whole number from 0 up");
  }
  for (const PlyElement& other : header.elements) {
    if (other.name == element.name) throw lines.refusal("element " + quote(element.name) + " is declared twice");
  }
  return element;
}

PlyProperty property(TextLines& lines, const PlyElement& element) {
  PlyProperty property;
  TextLines ahead = lines;
  if (word(ahead, "a number type") == "list") {
    lines = ahead;
    property.count_type = type(lines);
    if (*property.count_type == PlyType::kFloat32 || *property.count_type == PlyType::kFloat64) {
      throw lines.refusal("a list's length must be a whole number type");
    }
  }
  property.type = type(lines);
  property.name = word(lines, "the property's name");
  for (const PlyProperty& other : element.properties) {
    if (other.name == property.name) throw lines.refusal("property " + quote(property.name) + " is declared twice");
  }
  return property;
}

/// A line `obj_info`: a name and a whole number where it speaks of a range image, otherwise anything.
void read_info(TextLines& lines, PlyRangeInfo& range) {
  const std::string_view name = lines.field().value_or("");
  const std::string_view text = lines.field().value_or("");
  std::size_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return;
  if (name == "num_cols") range.columns = value;
  if (name == "num_rows") range.rows = value;
  if (name == "is_cyberware_data") range.cyberware = value != 0;
  if (name == "is_warped") range.warped = value != 0;
  if (name == "is_right_mirror_open") range.right_mirror = value != 0;
  if (name == "is_linear_scan") range.linear = value != 0;
}

/// A grid has as many cells as its header says columns and rows.
void check_range(const std::string& name, const PlyHeader& header) {
  const std::size_t columns = header.range.columns, rows = header.range.rows;
  if (columns == 0) return;
  for (const PlyElement& element : header.elements) {
    if (element.name == "range_grid" && (element.count / columns != rows || element.count % columns != 0)) {
      throw InputError(name + ": obj_info states " + std::to_string(columns) + " columns and " + std::to_string(rows) +
                       " rows, but element 'range_grid' has " + std::to_string(element.count) + " cells");
    }
  }
}

/// What the readers rely on: positions, and normals either whole or not at all.
void check_vertex(const std::string& name, PlyHeader& header) {
  const auto vertex = std::find_if(header.elements.begin(), header.elements.end(), [](const PlyElement& e) { return e.name == "vertex"; });
  if (vertex == header.elements.end())
    throw InputError(name + ": the PLY header declares no element 'vertex', so there are no points in it");
  constexpr std::array<const char*, kPointColumns> kNames = {"x", "y", "z", "nx", "ny", "nz", "stiffness"};
  std::array<const PlyProperty*, kPointColumns> found{};
  const auto require_number = [&](const PlyProperty& property) {
    if (property.count_type)
      throw InputError(name + ": property " + quote(property.name) + " of element 'vertex' is a list; it must be a single number");
  };
  drop_second_names(vertex->properties, kNames);
  for (const PlyProperty& property : vertex->properties) {
    const auto column = point_column(property.name);
    if (!column) continue;
    require_number(property);
    if (const PlyProperty* other = std::exchange(found[*column], &property)) {
      throw InputError(name + ": properties " + quote(other->name) + " and " + quote(property.name) +
                       " of element 'vertex' are the same; remove one of them");
    }
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (!found[axis]) throw InputError(name + ": element 'vertex' has no property '" + kNames[axis] + "'; points need x, y and z");
  }
  const auto normals = 3 - std::count(found.begin() + 3, found.begin() + kStiffnessColumn, nullptr);
  if (normals != 0 && normals != 3) throw InputError(name + ": element 'vertex' has only a part of nx, ny, nz; a normal needs all three");
}

}  // namespace

PlyHeader read_ply_header(const std::string& name, std::span<const std::uint8_t> bytes) {
  TextLines lines(name, bytes);
  if (!lines.next() || lines.rest() != "ply") throw InputError(name + ": line 1: a PLY file begins with a line 'ply', this one does not");
  PlyHeader header;
  bool has_format = false;
  while (lines.next()) {
    const std::string_view keyword = lines.field().value_or("");
    if (keyword == "format") {
      if (std::exchange(has_format, true)) throw lines.refusal("the format is declared twice");
      header.encoding = encoding(lines);
    } else if (keyword == "element") {
      header.elements.push_back(element(lines, header));
    } else if (keyword == "property") {
      if (header.elements.empty()) throw lines.refusal("a property before the first element");
      header.elements.back().properties.push_back(property(lines, header.elements.back()));
    } else if (keyword == "end_header") {
      if (!has_format) throw lines.refusal("the header ends without a 'format' line");
      for (const PlyElement& element : header.elements) {
        if (element.properties.empty()) throw lines.refusal("element " + quote(element.name) + " has no properties");
      }
      header.bytes = lines.bytes_read();
      check_vertex(name, header);
      check_range(name, header);
      return header;
    } else if (keyword == "obj_info") {
      read_info(lines, header.range);
    } else if (keyword != "comment" && keyword != "bye" && !keyword.empty()) {  // `bye` ends the info of Stanford's later scans
      throw lines.refusal(quote(keyword) + " is no keyword of a PLY header");
    }
  }
  throw InputError(name + ": the file ends within its PLY header; there is no 'end_header'");
}

}  // namespace isotouch::cloud
