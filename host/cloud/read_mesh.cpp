#include "host/cloud/read_mesh.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <vector>

#include "host/cloud/model.h"
#include "host/cloud/polygon.h"
#include "host/error.h"

namespace isotouch::cloud {
namespace {

using Eigen::Vector3d;

constexpr double kFarthest = 1e12;

/// The model's faces on vertices of which no two share a place; vertices keep their order.
TriangleMesh joined(const Model& model) {
  const std::vector<Vector3d>& positions = model.positions;
  std::vector<std::uint32_t> order(positions.size());
  std::iota(order.begin(), order.end(), 0U);
  const auto before = [&](std::uint32_t a, std::uint32_t b) {
    const auto key = [&](std::uint32_t i) { return std::array{positions[i].x(), positions[i].y(), positions[i].z()}; };
    const auto ka = key(a);
    const auto kb = key(b);
    return ka != kb ? ka < kb : a < b;
  };
  std::sort(order.begin(), order.end(), before);
  std::vector<std::uint32_t> first_at(positions.size());  // the first vertex at the same place
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool same = i > 0 && positions[order[i]] == positions[order[i - 1]];
    first_at[order[i]] = same ? first_at[order[i - 1]] : order[i];
  }
  TriangleMesh mesh;
  std::vector<bool> has_face(positions.size());
  for (const auto& [a, b, c] : model.faces) {
    const std::array<std::uint32_t, 3> face = {first_at[a], first_at[b], first_at[c]};
    if (face[0] == face[1] || face[1] == face[2] || face[2] == face[0]) continue;
    mesh.faces.push_back(face);
    for (const std::uint32_t v : face) has_face[v] = true;
  }
  std::vector<std::uint32_t> number(positions.size());
  for (std::uint32_t i = 0; i < positions.size(); ++i) {
    if (!has_face[i]) continue;
    number[i] = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.push_back(positions[i]);
  }
  for (auto& face : mesh.faces) {
    for (std::uint32_t& v : face) v = number[v];
  }
  return mesh;
}

}  // namespace

TriangleMesh read_mesh(const SourceFile& file, MeshReport& report) {
  Model model = file.faces();
  report = {model.format, file.hash()};
  for (std::size_t i = 0; i < model.positions.size(); ++i) {
    if (model.positions[i].cwiseAbs().maxCoeff() > kFarthest) {
      throw InputError(file.name() + ": " + model.place(i) +
                       ": a coordinate is larger than 1e12; the file is damaged or its units are unusable");
    }
  }
  if (model.faces.empty() && !model.positions.empty()) throw NoFaces(file.name(), "a mesh is a closed surface of faces");
  cut_polygons(model, file.name());
  TriangleMesh mesh = joined(model);
  if (mesh.faces.empty()) throw InputError(file.name() + ": there are no faces in it; a mesh is a closed surface of faces");
  return mesh;
}

TriangleMesh read_mesh(const std::filesystem::path& file) {
  MeshReport report;
  return read_mesh(SourceFile(file), report);
}

}  // namespace isotouch::cloud
