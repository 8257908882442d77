#include "host/cloud/ply.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <optional>
#include <string_view>
#include <vector>

#include "host/cloud/ply_header.h"
#include "host/cloud/point_columns.h"
#include "host/cloud/polygon.h"
#include "host/cloud/text_lines.h"
#include "host/error.h"
#include "host/files/whole_file.h"
#include "shared/bytes.h"

namespace isotouch::cloud {
namespace {

using Eigen::Vector3d;

/// Rows of numbers, one line each.
class TextRows {
 public:
  TextRows(const std::string& name, std::span<const std::uint8_t> file, std::size_t header_bytes) : lines_(name, file) {
    while (lines_.bytes_read() < header_bytes) lines_.next();
  }

  std::size_t most_rows(const PlyElement& element) const { return lines_.bytes_left() / (2 * element.properties.size()) + 1; }
  void begin_row(const PlyElement& element, std::size_t row) {
    do {
      if (!lines_.next()) {
        throw refusal("the file ends after " + std::to_string(row) + " of the " + std::to_string(element.count) + " rows of element " +
                      quote(element.name) + "; it was cut short, or the count is wrong");
      }
    } while (lines_.rest().find_first_not_of(" \t") == std::string_view::npos);
  }
  double number(PlyType type, std::string_view what) {
    const double value = lines_.number(what);
    const bool fits = std::abs(value) <= static_cast<double>(std::numeric_limits<float>::max());
    return type == PlyType::kFloat32 && fits ? static_cast<double>(static_cast<float>(value)) : value;  // as in the binary file
  }
  void end_row() {
    if (const auto extra = lines_.field()) throw refusal(quote(*extra) + " follows the last property of the row");
  }
  void end() {
    while (lines_.next()) {
      if (lines_.field()) throw refusal("more rows than the header declares");
    }
  }
  std::optional<std::size_t> line() const { return lines_.line(); }
  InputError refusal(const std::string& what) const { return lines_.refusal(what); }

 private:
  TextLines lines_;
};

/// Rows of numbers, packed without gaps.
class BinaryRows {
 public:
  BinaryRows(const std::string& name, std::span<const std::uint8_t> body, bool big_endian)
      : name_(name), body_(body), big_endian_(big_endian) {}

  std::size_t most_rows(const PlyElement& element) const {
    std::size_t least = 0;
    for (const PlyProperty& property : element.properties) least += bytes_of(property.count_type.value_or(property.type));
    return (body_.size() - at_) / least;
  }
  void begin_row(const PlyElement& element, std::size_t row) {
    element_ = &element;
    row_ = row;
  }
  double number(PlyType type, std::string_view) {
    const std::size_t size = bytes_of(type);
    if (body_.size() - at_ < size) throw refusal("the file ends in the middle of it");
    const std::uint8_t* at = body_.data() + at_;
    at_ += size;
    std::array<std::uint8_t, 8> turned;
    if (big_endian_) {
      std::reverse_copy(at, at + size, turned.begin());
      at = turned.data();
    }
    switch (type) {
      case PlyType::kInt8: return load_le<std::int8_t>(at);
      case PlyType::kUint8: return load_le<std::uint8_t>(at);
      case PlyType::kInt16: return load_le<std::int16_t>(at);
      case PlyType::kUint16: return load_le<std::uint16_t>(at);
      case PlyType::kInt32: return load_le<std::int32_t>(at);
      case PlyType::kUint32: return load_le<std::uint32_t>(at);
      case PlyType::kFloat32: return static_cast<double>(std::bit_cast<float>(load_le<std::uint32_t>(at)));
      case PlyType::kFloat64: return std::bit_cast<double>(load_le<std::uint64_t>(at));
    }
    return 0.0;
  }
  void end_row() {}
  void end() {
    const auto blank = [](std::uint8_t c) { return c == '\n' || c == '\r' || c == ' ' || c == 0; };
    if (!std::all_of(body_.begin() + static_cast<std::ptrdiff_t>(at_), body_.end(), blank)) {
      throw InputError(name_ + ": " + std::to_string(body_.size() - at_) +
                       " bytes follow the last row that the header declares; the header's counts are wrong");
    }
  }
  std::optional<std::size_t> line() const { return std::nullopt; }
  InputError refusal(const std::string& what) const {
    return InputError(name_ + ": " + element_->name + ' ' + std::to_string(row_ + 1) + " of " + std::to_string(element_->count) + ": " +
                      what);
  }

 private:
  std::string name_;
  std::span<const std::uint8_t> body_;
  bool big_endian_;
  std::size_t at_ = 0;
  const PlyElement* element_ = nullptr;
  std::size_t row_ = 0;
};

/// What becomes of a property; the columns of a point stand in their order (point_columns.h).
enum class Use { kSkip, kX, kY, kZ, kNormalX, kNormalY, kNormalZ, kStiffness, kCorners, kCell };

Use use_of(const PlyElement& element, const PlyProperty& property) {
  if (element.name == "face" && property.count_type) {
    return property.name == "vertex_indices" || property.name == "vertex_index" ? Use::kCorners : Use::kSkip;
  }
  if (element.name == "range_grid") return property.count_type && property.name == "vertex_indices" ? Use::kCell : Use::kSkip;
  if (element.name != "vertex") return Use::kSkip;
  const auto column = point_column(property.name);
  return column ? static_cast<Use>(static_cast<std::size_t>(Use::kX) + *column) : Use::kSkip;
}

/// What each row of an element holds.
struct RowUses {
  std::vector<Use> uses;  ///< one for each property
  bool has_normals = false;
  bool has_stiffness = false;
  bool has_cells = false;

  explicit RowUses(const PlyElement& element) {
    for (const PlyProperty& property : element.properties) uses.push_back(use_of(element, property));
    const auto has = [&](Use use) { return std::find(uses.begin(), uses.end(), use) != uses.end(); };
    has_normals = has(Use::kNormalX) && has(Use::kNormalY) && has(Use::kNormalZ);
    has_stiffness = has(Use::kStiffness);
    has_cells = has(Use::kCell);
  }
};

template <class Rows>
void read_row(Rows& rows, const PlyElement& element, const RowUses& row, std::size_t number, std::size_t vertex_count, Model& model) {
  const std::vector<Use>& uses = row.uses;
  std::array<double, kPointColumns> vertex{};
  std::vector<std::uint32_t> corners;
  for (std::size_t i = 0; i < uses.size(); ++i) {
    const PlyProperty& property = element.properties[i];
    if (!property.count_type) {
      const double value = rows.number(property.type, property.name);
      if (uses[i] == Use::kSkip) continue;
      const bool is_of_normal = uses[i] >= Use::kNormalX && uses[i] <= Use::kNormalZ;
      if (!std::isfinite(value) && !is_of_normal)
        throw rows.refusal(property.name + " is not a finite number; correct it, or save the cloud without this point");
      vertex[static_cast<std::size_t>(uses[i]) - 1] = value;
      continue;
    }
    const double length = rows.number(*property.count_type, "the length of list " + property.name);
    if (!(length >= 0.0) || length != std::floor(length)) throw rows.refusal("list " + property.name + " has an impossible length");
    for (double left = length; left > 0.0; --left) {
      const double value = rows.number(property.type, property.name);
      if (uses[i] != Use::kCorners && uses[i] != Use::kCell) continue;
      if (!(value >= 0.0) || value != std::floor(value) || value >= static_cast<double>(vertex_count)) {
        throw rows.refusal(std::string(uses[i] == Use::kCell ? "a cell" : "a corner") +
                           " refers to a vertex that is not there; there are " + std::to_string(vertex_count) + ", counted from 0");
      }
      corners.push_back(static_cast<std::uint32_t>(value));
    }
  }
  if (element.name == "vertex") {
    model.positions.emplace_back(vertex[0], vertex[1], vertex[2]);
    if (row.has_normals) model.normals.push_back(known_or_zero({vertex[3], vertex[4], vertex[5]}));
    if (row.has_stiffness) model.stiffness.push_back(vertex[kStiffnessColumn]);
    if (const auto line = rows.line()) model.lines.push_back(*line);
  }
  if (row.has_cells) {  // where a ray returned twice, the first counts
    if (model.grid) model.grid->cells.push_back(corners.empty() ? ScanGrid::kNoReturn : corners[0]);
  } else {
    add_polygon(model, corners, rows.line().value_or(0), number + 1);
  }
}

/// Where the sensor of a range image was: in the origin, or so far away that its lines of sight are parallel.
Vector3d sensor(const PlyRangeInfo& range, const std::vector<Vector3d>& positions) {
  if (!range.cyberware.value_or(true) || positions.empty()) return Vector3d::Zero();
  Eigen::AlignedBox3d box;
  for (const Vector3d& p : positions) box.extend(p);
  constexpr double kFar = 1000.0;
  const double sideways = !range.warped ? 0.0 : range.right_mirror ? 0.5 : -0.5;
  return box.center() + kFar * box.sizes().maxCoeff() * Vector3d(sideways, 0.0, std::sqrt(1.0 - sideways * sideways));
}

template <class Rows>
void read_body(const std::string& name, Rows rows, const PlyHeader& header, Model& model) {
  std::size_t vertex_count = 0;
  for (const PlyElement& element : header.elements) {
    if (element.name == "vertex") vertex_count = element.count;
  }
  for (const PlyElement& element : header.elements) {
    if (element.count > rows.most_rows(element)) {
      throw InputError(name + ": the header declares " + std::to_string(element.count) + " rows of element " + quote(element.name) +
                       ", more than the file has room for; it was cut short, or the count is wrong");
    }
    const RowUses uses(element);
    if (uses.has_cells && header.range.columns > 0 && header.range.linear) model.grid = ScanGrid{.columns = header.range.columns};
    if (element.name == "vertex") {
      model.positions.reserve(element.count);
      if (uses.has_normals) model.normals.reserve(element.count);
    }
    for (std::size_t row = 0; row < element.count; ++row) {
      rows.begin_row(element, row);
      read_row(rows, element, uses, row, vertex_count, model);
      rows.end_row();
    }
  }
  rows.end();
  if (!model.grid) return;
  model.grid->sensor = sensor(header.range, model.positions);
  model.grid->known = !header.range.cyberware   ? ScanGrid::Known::kUsual
                      : *header.range.cyberware ? ScanGrid::Known::kSurely
                                                : ScanGrid::Known::kAssumed;
}

}  // namespace

Model read_ply(const std::string& name, std::span<const std::uint8_t> bytes, const PlyHeader& header) {
  const auto body = bytes.subspan(header.bytes);
  Model model;
  switch (header.encoding) {
    case PlyEncoding::kAscii:
      model.format = "PLY, ascii";
      read_body(name, TextRows(name, bytes, header.bytes), header, model);
      break;
    case PlyEncoding::kLittleEndian:
      model.format = "PLY, binary little-endian";
      read_body(name, BinaryRows(name, body, false), header, model);
      break;
    case PlyEncoding::kBigEndian:
      model.format = "PLY, binary big-endian";
      read_body(name, BinaryRows(name, body, true), header, model);
      break;
  }
  return model;
}

bool is_strips(const PlyElement& element) { return element.name == "tristrips" && element.count > 0; }

bool is_bare_ply_mesh(const PlyHeader& header) {
  bool faces = false;
  bool normals = false;
  for (const PlyElement& element : header.elements) {
    for (const PlyProperty& property : element.properties) {
      const Use use = use_of(element, property);
      faces = faces || (use == Use::kCorners && element.count > 0) || is_strips(element);
      normals = normals || use == Use::kNormalX;
    }
  }
  return faces && !normals;
}

void write_ply(const std::filesystem::path& file, const OrientedPoints& points, const std::string& comment) {
  std::string header = "ply\nformat binary_little_endian 1.0\n";
  if (!comment.empty()) header += "comment " + comment + '\n';
  header += "element vertex " + std::to_string(points.size()) + '\n';
  std::vector<const char*> properties = {"x", "y", "z", "nx", "ny", "nz"};
  if (!points.stiffness.empty()) properties.push_back("stiffness");
  for (const char* property : properties) header += std::string("property double ") + property + '\n';
  header += "end_header\n";
  std::vector<std::uint8_t> bytes(header.begin(), header.end());
  bytes.resize(header.size() + points.size() * properties.size() * 8);
  std::uint8_t* at = bytes.data() + header.size();
  const auto append = [&at](double value) {
    store_le(at, std::bit_cast<std::uint64_t>(value));
    at += 8;
  };
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (const Vector3d* v : {&points.positions[i], &points.normals[i]}) {
      for (const double value : *v) append(value);
    }
    if (!points.stiffness.empty()) append(points.stiffness[i]);
  }
  write_file(file, bytes.data(), bytes.size());
}

}  // namespace isotouch::cloud
