#include "host/cloud/mesh.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>
#include <utility>

#include "host/cloud/file_kind.h"
#include "host/cloud/files.h"
#include "host/cloud/model.h"
#include "host/cloud/obj.h"
#include "host/cloud/ply.h"
#include "host/cloud/random.h"
#include "host/cloud/stl.h"
#include "host/error.h"

namespace isotouch::cloud {
namespace {

using Eigen::Vector3d;

Model read_faces(const std::filesystem::path& file, std::span<const std::uint8_t> bytes) {
  const std::string name = file.string();
  switch (file_kind(file, bytes)) {
    case FileKind::kPly: return read_ply(name, bytes);
    case FileKind::kObj: return read_obj_faces(name, bytes);
    case FileKind::kStl: return read_stl(name, bytes);
    case FileKind::kText:
    case FileKind::kUnknown: break;
  }
  throw InputError(name + ": this is no kind of mesh file that is known; a mesh ends in .ply, .obj or .stl");
}

/// The model's faces on vertices of which no two share a place; vertices are numbered by their first appearance.
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
  std::vector<std::uint32_t> number(positions.size());
  for (std::uint32_t i = 0; i < positions.size(); ++i) {
    if (first_at[i] == i) {
      number[i] = static_cast<std::uint32_t>(mesh.vertices.size());
      mesh.vertices.push_back(positions[i]);
    }
  }
  for (const auto& [a, b, c] : model.faces) {
    const std::array<std::uint32_t, 3> face = {number[first_at[a]], number[first_at[b]], number[first_at[c]]};
    if (face[0] != face[1] && face[1] != face[2] && face[2] != face[0]) mesh.faces.push_back(face);
  }
  return mesh;
}

/// Twice the face's area, along its normal.
Vector3d area_vector(const TriangleMesh& mesh, std::size_t face) {
  const auto& [a, b, c] = mesh.faces[face];
  return (mesh.vertices[b] - mesh.vertices[a]).cross(mesh.vertices[c] - mesh.vertices[a]);
}

std::string text(const Vector3d& p) { return std::to_string(p.x()) + ' ' + std::to_string(p.y()) + ' ' + std::to_string(p.z()); }

}  // namespace

TriangleMesh read_mesh(const std::filesystem::path& file) {
  const std::vector<std::uint8_t> bytes = read_file(file);
  if (bytes.empty()) throw InputError(file.string() + ": the file is empty");
  TriangleMesh mesh = joined(read_faces(file, bytes));
  if (mesh.faces.empty()) throw InputError(file.string() + ": there are no faces in it; a comparison needs a closed mesh");
  return mesh;
}

void require_closed(const TriangleMesh& mesh, const std::string& name) {
  using Edge = std::pair<std::uint32_t, std::uint32_t>;
  std::vector<Edge> edges;  // as the faces run them
  edges.reserve(3 * mesh.faces.size());
  for (const auto& [a, b, c] : mesh.faces) {
    edges.emplace_back(a, b);
    edges.emplace_back(b, c);
    edges.emplace_back(c, a);
  }
  std::sort(edges.begin(), edges.end());
  std::size_t open = 0;
  Edge first_open;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const bool twice = (i > 0 && edges[i] == edges[i - 1]) || (i + 1 < edges.size() && edges[i] == edges[i + 1]);
    const bool answered = std::binary_search(edges.begin(), edges.end(), Edge{edges[i].second, edges[i].first});
    if (!twice && answered) continue;
    if (open++ == 0) first_open = edges[i];
  }
  if (open > 0) {
    throw InputError(name + ": the mesh is not closed: " + std::to_string(open) + " of its " + std::to_string(edges.size()) +
                     " face edges have not exactly one opposite, the first from " + text(mesh.vertices[first_open.first]) + " to " +
                     text(mesh.vertices[first_open.second]) + "; repair it first");
  }
  if (!(signed_volume(mesh) > 0.0)) throw InputError(name + ": the mesh is closed but its faces turn inward; turn them round first");
}

double signed_volume(const TriangleMesh& mesh) {
  if (mesh.vertices.empty()) return 0.0;
  const Vector3d& origin = mesh.vertices[0];  // near the mesh, so that little cancels
  double six_volumes = 0.0;
  for (const auto& [a, b, c] : mesh.faces) {
    six_volumes += (mesh.vertices[a] - origin).dot((mesh.vertices[b] - origin).cross(mesh.vertices[c] - origin));
  }
  return six_volumes / 6.0;
}

Vector3d face_normal(const TriangleMesh& mesh, std::size_t face) {
  const Vector3d across = area_vector(mesh, face);
  const double length = across.norm();
  return length > 0.0 ? Vector3d(across / length) : Vector3d::Zero();
}

OrientedPoints scatter_on_mesh(const TriangleMesh& mesh, std::size_t count, std::uint64_t seed) {
  std::vector<double> area_up_to;
  double area = 0.0;
  for (std::size_t face = 0; face < mesh.faces.size(); ++face) area_up_to.push_back(area += area_vector(mesh, face).norm());
  if (!(area > 0.0)) throw InputError("the mesh has no area to draw points from");
  Random random(seed);
  OrientedPoints points;
  while (points.size() < count) {
    const auto found = std::upper_bound(area_up_to.begin(), area_up_to.end(), random.uniform() * area);
    const double spread = std::sqrt(random.uniform());
    const double along = random.uniform();
    if (found == area_up_to.end()) continue;  // by rounding only
    const auto face = static_cast<std::size_t>(found - area_up_to.begin());
    const auto& [a, b, c] = mesh.faces[face];
    points.positions.emplace_back((1.0 - spread) * mesh.vertices[a] + spread * (1.0 - along) * mesh.vertices[b] +
                                  spread * along * mesh.vertices[c]);
    points.normals.push_back(face_normal(mesh, face));
  }
  return points;
}

}  // namespace isotouch::cloud
