#include "host/server/scene.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "host/field_file/marks.h"
#include "host/server/put_bytes.h"
#include "host/to_double.h"
#include "host/trace/hash_text.h"
#include "host/view/field_ray.h"
#include "host/view/surface_mesh.h"

namespace isotouch::server {

namespace {

void put_vertex(std::string& bytes, const Eigen::Vector3d& position, const Eigen::Vector3d& normal, std::uint8_t mark) {
  for (const double value : position) put_float(bytes, value);
  for (const double value : normal) put_whole(bytes, static_cast<std::int8_t>(std::lround(127 * std::clamp(value, -1.0, 1.0))));
  put_whole(bytes, mark);
}

/// Of each vertex, whether a wall's other side lies behind it.
std::vector<std::uint8_t> thin_walls(const view::SurfaceMesh& mesh, const view::FieldRays& rays) {
  std::vector<std::uint8_t> thin;
  thin.reserve(mesh.positions.size());
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const Eigen::Vector3d inwards = -Scene::kThin_voxels * rays.edge() * mesh.normals[i].cast<double>();
    thin.push_back(rays.value(mesh.positions[i].cast<double>() + inwards).distance > 0 ? 1 : 0);
  }
  return thin;
}

std::string line_bytes(const Lines& lines) {
  const std::size_t drawn = std::min(lines.size(), Scene::kMaxPoints);
  std::string bytes;
  put_whole(bytes, static_cast<std::uint32_t>(drawn));
  for (std::size_t i = 0; i < drawn; ++i) {
    for (const Eigen::Vector3d& end : lines[i * lines.size() / drawn]) {
      for (const double value : end) put_float(bytes, value);
    }
  }
  return bytes;
}

std::string surface_bytes(const view::SurfaceMesh& mesh, const std::vector<std::uint8_t>& thin) {
  std::string bytes;
  bytes.reserve(8 + 16 * mesh.positions.size() + 12 * mesh.faces.size());
  put_whole(bytes, static_cast<std::uint32_t>(mesh.positions.size()));
  put_whole(bytes, static_cast<std::uint32_t>(mesh.faces.size()));
  for (std::size_t i = 0; i < mesh.positions.size(); ++i)
    put_vertex(bytes, mesh.positions[i].cast<double>(), mesh.normals[i].cast<double>(),
               static_cast<std::uint8_t>(mesh.invented[i] | thin[i] << 1));
  for (const auto& face : mesh.faces) {
    for (const std::uint32_t vertex : face) put_whole(bytes, vertex);
  }
  return bytes;
}

/// Evenly chosen where there are too many.
std::string point_bytes(const cloud::OrientedPoints& points) {
  const std::size_t drawn = std::min(points.size(), Scene::kMaxPoints);
  std::string bytes;
  put_whole(bytes, static_cast<std::uint32_t>(drawn));
  for (std::size_t i = 0; i < drawn; ++i) {
    const std::size_t chosen = i * points.size() / drawn;
    put_vertex(bytes, points.positions[chosen], points.normals[chosen], 0);
  }
  return bytes;
}

}  // namespace

Scene::Scene(std::string name, field_file::OpenField field, const Scan& scan)
    : name_(std::move(name)), field_(std::move(field)), hash_(trace::hash_text(field_.view.hash())), all_points_(scan.points.size()) {
  if (field_.invented.any()) invented_share_ = field_file::share_of(field_.invented, field_.view);
  const view::SurfaceMesh mesh = view::surface_mesh(field_.view, field_.invented, kMaxVertices);
  step_ = mesh.step;
  const std::vector<std::uint8_t> thin = thin_walls(mesh, view::FieldRays(field_.view));
  thin_share_ = thin.empty() ? 0 : static_cast<double>(std::count(thin.begin(), thin.end(), 1)) / static_cast<double>(thin.size());
  surface_ = surface_bytes(mesh, thin);
  points_ = point_bytes(scan.points);
  rim_ = line_bytes(scan.rim);
  turned_ = line_bytes(scan.turned);
}

nlohmann::ordered_json Scene::summary() const {
  const FieldView& field = field_.view;
  const Eigen::Vector3d low = to_double(field.origin);
  const double edge = to_double(field.edge);
  const Eigen::Vector3d high = low + edge * Eigen::Vector3d(field.size[0] - 1, field.size[1] - 1, field.size[2] - 1);
  return {{"name", name_},
          {"hash", hash()},
          {"low_mm", {low.x(), low.y(), low.z()}},
          {"high_mm", {high.x(), high.y(), high.z()}},
          {"samples", field.size},
          {"voxel_mm", edge},
          {"band_mm", edge * to_double(field.band)},
          {"stiffness_n_per_mm", to_double(field.stiffness)},
          {"bytes", field.image.size()},
          {"points", all_points_},
          {"points_drawn", std::min(all_points_, kMaxPoints)},
          {"step_voxels", step_},
          {"invented_share", invented_share_ ? nlohmann::ordered_json(*invented_share_) : nullptr},
          {"thin_share", thin_share_},
          {"thin_mm", kThin_voxels * edge}};
}

std::string Scene::image() const {
  const std::span<const std::uint8_t> bytes = field_.image.bytes();
  return {bytes.begin(), bytes.end()};
}

std::string Scene::slice(char axis, double at, int samples) const {
  const view::FieldRays rays(field_.view);
  const double edge = to_double(field_.view.edge);
  const Eigen::Vector3d low = to_double(field_.view.origin);
  const Eigen::Vector3d size = edge * Eigen::Vector3d(field_.view.size[0] - 1, field_.view.size[1] - 1, field_.view.size[2] - 1);
  const int across = axis - 'x', u = (across + 1) % 3, v = (across + 2) % 3;
  const double longer = std::max(size[u], size[v]);
  const auto count = [&](double length) { return std::max(2, static_cast<int>(std::lround(samples * length / longer))); };
  const int columns = count(size[u]), rows = count(size[v]);
  Eigen::Vector3d first = low;
  first[across] = at;
  const Eigen::Vector3d along = Eigen::Vector3d::Unit(u) * size[u] / (columns - 1), up = Eigen::Vector3d::Unit(v) * size[v] / (rows - 1);
  std::string bytes;
  bytes.reserve(44 + 4 * static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
  put_whole(bytes, static_cast<std::uint32_t>(columns));
  put_whole(bytes, static_cast<std::uint32_t>(rows));
  for (const Eigen::Vector3d& corner : {first, Eigen::Vector3d(first + (columns - 1) * along), Eigen::Vector3d(first + (rows - 1) * up)}) {
    for (const double value : corner) put_float(bytes, value);
  }
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) put_float(bytes, edge * rays.value(first + column * along + row * up).distance);
  }
  return bytes;
}

}  // namespace isotouch::server
