#include "host/cloud/obj.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>
#include <system_error>
#include <utility>

#include "host/cloud/polygon.h"
#include "host/cloud/text_lines.h"

namespace isotouch::cloud {
namespace {

using Eigen::Vector3d;

constexpr std::uint32_t kNone = 0xFFFFFFFFU;
constexpr std::array<std::string_view, 3> kStatements = {"v", "vn", "f"};  // those that are read

struct Corner {
  std::uint32_t vertex = kNone;
  std::uint32_t normal = kNone;

  auto operator<=>(const Corner&) const = default;
};

struct Face {
  std::vector<Corner> corners;
  std::size_t line = 0;
};

/// The file as it stands.
struct ObjFile {
  std::vector<Vector3d> vertices, normals;
  std::vector<std::size_t> vertex_lines;
  std::vector<Face> faces;
};

Vector3d vector(TextLines& lines, const char* what) {
  if (with_decimal_commas(lines.rest()) >= 3) throw decimal_commas(lines);
  Vector3d v;
  for (double& value : v) {
    value = lines.number(what);
    if (!std::isfinite(value))
      throw lines.refusal(std::string(what) + " is not a finite number; correct it, or save the model without this point");
  }
  return v;
}

/// One index of a corner; kNone where the part is empty. OBJ counts from 1, or backwards from -1.
std::uint32_t index(TextLines& lines, std::string_view part, std::size_t count, const char* of_what) {
  if (part.empty()) return kNone;
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), value);
  if (error != std::errc{} || end != part.data() + part.size()) throw lines.refusal(quote(part) + " is no index of a " + of_what);
  const std::int64_t from_zero = value > 0 ? value - 1 : value + static_cast<std::int64_t>(count);
  if (value == 0 || from_zero < 0 || from_zero >= static_cast<std::int64_t>(count)) {
    throw lines.refusal("a corner refers to " + std::string(of_what) + ' ' + std::to_string(value) + ", but " + std::to_string(count) +
                        " stand before it");
  }
  return static_cast<std::uint32_t>(from_zero);
}

/// v, v/vt, v//vn or v/vt/vn
Corner corner(TextLines& lines, std::string_view field, const ObjFile& obj) {
  const std::size_t first = std::min(field.find('/'), field.size());
  const std::size_t second = std::min(field.find('/', std::min(first + 1, field.size())), field.size());
  Corner corner;
  corner.vertex = index(lines, field.substr(0, first), obj.vertices.size(), "vertex");
  corner.normal = index(lines, field.substr(std::min(second + 1, field.size())), obj.normals.size(), "normal");
  if (corner.vertex == kNone) throw lines.refusal(quote(field) + " names no vertex");
  return corner;
}

ObjFile read(const std::string& name, std::span<const std::uint8_t> bytes) {
  TextLines lines(name, bytes, kStatements);
  ObjFile obj;
  while (lines.next()) {
    const std::string_view keyword = lines.field().value_or("");
    if (keyword == "v") {
      obj.vertices.push_back(vector(lines, "a coordinate"));
      obj.vertex_lines.push_back(lines.line());
    } else if (keyword == "vn") {
      obj.normals.push_back(vector(lines, "a normal's component"));
    } else if (keyword == "f") {
      Face face{{}, lines.line()};
      while (const auto field = lines.field()) face.corners.push_back(corner(lines, *field, obj));
      if (face.corners.size() < 3)
        throw lines.refusal("a face needs three corners or more, this one has " + std::to_string(face.corners.size()));
      obj.faces.push_back(std::move(face));
    }
  }
  return obj;
}

/// Normals that no corner names belong to nothing.
bool names_normals(const ObjFile& obj) {
  return std::any_of(obj.faces.begin(), obj.faces.end(), [](const Face& face) {
    return std::any_of(face.corners.begin(), face.corners.end(), [](const Corner& corner) { return corner.normal != kNone; });
  });
}

}  // namespace

Model read_obj_faces(const std::string& name, std::span<const std::uint8_t> bytes) {
  ObjFile obj = read(name, bytes);
  Model model;
  model.format = "OBJ";
  model.positions = std::move(obj.vertices);
  model.lines = std::move(obj.vertex_lines);
  std::vector<std::uint32_t> vertices;
  for (std::size_t face = 0; face < obj.faces.size(); ++face) {
    vertices.clear();
    for (const Corner& corner : obj.faces[face].corners) vertices.push_back(corner.vertex);
    add_polygon(model, vertices, obj.faces[face].line, face + 1);
  }
  return model;
}

Model read_obj_points(const std::string& name, std::span<const std::uint8_t> bytes) {
  const ObjFile obj = read(name, bytes);
  Model model;
  model.format = "OBJ";
  model.unused_faces = obj.faces.size();
  std::vector<Corner> points;
  if (obj.faces.empty()) {
    if (!obj.normals.empty() && obj.normals.size() != obj.vertices.size()) {
      throw InputError(name + ": " + std::to_string(obj.vertices.size()) + " vertices and " + std::to_string(obj.normals.size()) +
                       " normals without faces: it is not known which of them belong together");
    }
    for (std::uint32_t i = 0; i < obj.normals.size(); ++i) points.push_back({i, i});
  } else if (names_normals(obj)) {
    std::vector<std::pair<Corner, std::size_t>> uses;  // with its place in the file
    for (const Face& face : obj.faces) {
      for (const Corner& corner : face.corners) {
        if (corner.normal == kNone)
          throw InputError(name + ": line " + std::to_string(face.line) + ": a corner has no normal, others have; export normals for all");
        uses.emplace_back(corner, uses.size());
      }
    }
    std::sort(uses.begin(), uses.end());
    uses.erase(std::unique(uses.begin(), uses.end(), [](const auto& a, const auto& b) { return a.first == b.first; }), uses.end());
    std::sort(uses.begin(), uses.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
    for (const auto& [corner, place] : uses) points.push_back(corner);
  }
  for (const Corner& point : points) {
    model.positions.push_back(obj.vertices[point.vertex]);
    model.normals.push_back(obj.normals[point.normal]);
    model.lines.push_back(obj.vertex_lines[point.vertex]);
  }
  if (points.empty()) {  // vertices without normals: the caller says so
    model.positions = obj.vertices;
    model.lines = obj.vertex_lines;
  }
  return model;
}

bool is_bare_obj_mesh(const std::string& name, std::span<const std::uint8_t> bytes) {
  TextLines lines(name, bytes, kStatements);
  bool faces = false;
  while (lines.next()) {
    if (lines.field() != "f") continue;
    faces = true;
    while (const auto corner = lines.field()) {
      const std::size_t first = corner->find('/');
      const std::size_t second = first == std::string_view::npos ? first : corner->find('/', first + 1);
      if (second < corner->size() - 1) return false;  // v//vn or v/vt/vn
    }
  }
  return faces;
}

}  // namespace isotouch::cloud
