#include "host/evaluate/sharp_edges.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <numeric>
#include <tuple>
#include <utility>

#include "host/field/face_edges.h"
#include "host/field/line_crossings.h"

namespace isotouch::evaluate {

using Eigen::Vector3d;

namespace {

constexpr double kFinestPart = 0.01, kMaxParts = 16;  // an edge's parts that are asked: their length of the mesh's size, and how many

/// The same with one vertex at each place, the first one there.
cloud::TriangleMesh with_common_vertices(cloud::TriangleMesh mesh) {
  std::vector<std::uint32_t> order(mesh.vertices.size()), first(mesh.vertices.size());
  std::iota(order.begin(), order.end(), 0U);
  const auto key = [&](std::uint32_t v) { return std::tuple(mesh.vertices[v].x(), mesh.vertices[v].y(), mesh.vertices[v].z()); };
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return std::pair(key(a), a) < std::pair(key(b), b); });
  for (std::size_t i = 0; i < order.size(); ++i)
    first[order[i]] = i > 0 && key(order[i]) == key(order[i - 1]) ? first[order[i - 1]] : order[i];
  for (auto& face : mesh.faces)
    for (std::uint32_t& v : face) v = first[v];
  return mesh;
}

/// The edge that two sides of faces make; none of a face without area.
std::optional<SharpEdge> edge_between(const cloud::TriangleMesh& mesh, const field::FaceEdge& one, const field::FaceEdge& other) {
  const Vector3d first = cloud::face_normal(mesh, one.face), second = cloud::face_normal(mesh, other.face);
  if (first.isZero() || second.isZero()) return std::nullopt;
  const double turn = std::atan2(first.cross(second).norm(), first.dot(second)) * 180 / std::numbers::pi;
  // The corner of the second face that is not on the edge lies below the first face at a convex edge.
  const auto& corners = mesh.faces[other.face];
  const std::uint32_t third = corners[0] ^ corners[1] ^ corners[2] ^ one.low ^ one.high;
  const bool convex = first.dot(mesh.vertices[third] - mesh.vertices[one.low]) < 0;
  return SharpEdge{mesh.vertices[one.low], mesh.vertices[one.high], {first, second}, convex ? turn : -turn};
}

}  // namespace

Vector3d SharpEdge::into_face(std::size_t side) const {
  const Vector3d along = (end - begin).normalized(), into = normals[side].cross(along).normalized();
  // At a convex edge the other face's front lies beyond the edge, at a concave one on this side of it.
  return into.dot(normals[1 - side]) * turn_deg > 0 ? Vector3d(-into) : into;
}

std::vector<SharpEdge> sharp_edges(const cloud::TriangleMesh& of, double least_deg) {
  const cloud::TriangleMesh mesh = with_common_vertices(of);
  std::vector<SharpEdge> sharp;
  const std::vector<field::FaceEdge> sides = field::face_edges(mesh);
  for (std::size_t begin = 0, end = 0; begin < sides.size(); begin = end) {
    while (end < sides.size() && sides[end].same_edge(sides[begin])) ++end;
    for (std::size_t i = begin; i < end; ++i) {
      for (std::size_t j = i + 1; j < end; ++j) {
        if (sides[i].is_back(mesh) == sides[j].is_back(mesh)) continue;
        if (const auto edge = edge_between(mesh, sides[i], sides[j]); edge && std::abs(edge->turn_deg) >= least_deg) sharp.push_back(*edge);
      }
    }
  }
  return sharp;
}

std::vector<SharpEdge> bounding_edges(const TrueTrees& trees, double least_deg) {
  const std::vector<SharpEdge> all = sharp_edges(trees.closed.mesh(), least_deg);
  if (trees.outer.mesh().faces == trees.closed.mesh().faces) return all;
  const auto& box = trees.closed.box(field::TriangleTree::root());
  const double size = (box.high - box.low).norm();
  // Is what is in front of a face beside the edge free, and what is behind it not?
  const auto bounds = [&](const SharpEdge& edge, std::size_t side) {
    const Vector3d beside = (edge.begin + edge.end) / 2 + 1e-4 * size * edge.into_face(side);
    const Vector3d ahead = 1e-6 * size * edge.normals[side];
    return !field::is_inside(trees.closed, beside + ahead) && field::is_inside(trees.closed, beside - ahead);
  };
  std::vector<SharpEdge> found;
  for (const SharpEdge& edge : all) {
    const double parts = std::clamp(std::ceil((edge.end - edge.begin).norm() / (kFinestPart * size)), 1.0, kMaxParts);
    for (double part = 0; part < parts; ++part) {
      SharpEdge piece = edge;
      piece.begin = edge.begin + part / parts * (edge.end - edge.begin);
      piece.end = edge.begin + (part + 1) / parts * (edge.end - edge.begin);
      if (bounds(piece, 0) && bounds(piece, 1)) found.push_back(piece);
    }
  }
  return found;
}

std::optional<EdgePlace> place_on_edges(const std::vector<SharpEdge>& edges, cloud::Random& random) {
  double length = 0;
  for (const SharpEdge& edge : edges) length += (edge.end - edge.begin).norm();
  if (!(length > 0)) return std::nullopt;
  double left = random.uniform() * length;
  for (const SharpEdge& edge : edges) {
    const double own = (edge.end - edge.begin).norm();
    if (left < own) return EdgePlace{edge, edge.begin + left / own * (edge.end - edge.begin)};
    left -= own;
  }
  return EdgePlace{edges.back(), edges.back().end};
}

}  // namespace isotouch::evaluate
