#include "host/field/mesh_distance.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "host/field/angle.h"
#include "host/field/face_edges.h"
#include "host/field/line_crossings.h"
#include "host/field/outer_faces.h"
#include "host/field/sets.h"

namespace isotouch::field {

using Eigen::Vector3d;

namespace {

double angle_at(const Vector3d& corner, const Vector3d& b, const Vector3d& c) {
  const Vector3d u = b - corner;
  const Vector3d v = c - corner;
  return angle_of(u.cross(v).norm(), u.dot(v));
}

/// Sets of which only the number counts.
class Joined {
 public:
  explicit Joined(std::size_t members) : sets_(members), count_(members) {}
  void join(std::uint32_t a, std::uint32_t b) {
    const std::uint32_t root = sets_.of(a), other = sets_.of(b);
    if (root == other) return;
    sets_.join(root, other);
    --count_;
  }
  std::size_t count() const { return count_; }

 private:
  Sets sets_;
  std::size_t count_;
};

/// Has every edge two faces, and do all faces hang together by such edges, and all corners at each vertex?
bool is_one_sheet(const cloud::TriangleMesh& mesh, const std::vector<FaceEdge>& edges) {
  const auto corner = [&](const FaceEdge& edge, std::uint32_t vertex) {
    return 3 * edge.face + (mesh.faces[edge.face][edge.side] == vertex ? edge.side : (edge.side + 1) % 3);
  };
  Joined sheets(mesh.faces.size()), fans(edges.size());  // a corner for each edge of a face
  for (std::size_t n = 0; n < edges.size(); n += 2) {
    const bool paired =
        n + 1 < edges.size() && edges[n].same_edge(edges[n + 1]) && !(n + 2 < edges.size() && edges[n].same_edge(edges[n + 2]));
    if (!paired) return false;
    const FaceEdge &a = edges[n], &b = edges[n + 1];
    sheets.join(a.face, b.face);
    fans.join(corner(a, a.low), corner(b, b.low));
    fans.join(corner(a, a.high), corner(b, b.high));
  }
  std::vector<std::uint32_t> corners_at(mesh.vertices.size());
  for (const auto& face : mesh.faces) {
    for (const std::uint32_t vertex : face) ++corners_at[vertex];
  }
  const auto vertices = std::count_if(corners_at.begin(), corners_at.end(), [](std::uint32_t corners) { return corners > 0; });
  return sheets.count() == 1 && fans.count() == static_cast<std::size_t>(vertices);
}

}  // namespace

MeshDistance::MeshDistance(cloud::TriangleMesh mesh) : mesh_(std::move(mesh)), tree_(mesh_) {
  const bool is_one_sheet = make_pseudonormals();
  crossings_ = is_one_sheet ? face_crossings(mesh_, tree_) : face_crossings(mesh_, tree_, kNear);
  if (is_one_sheet && crossings_.faces == 0 && !crossings_.touching) return;
  turns_.emplace(mesh_);
  auto [outer, coarse] = outer_faces(mesh_, tree_, *turns_, crossings_.faces > 0 || crossings_.touching);
  outer_ = std::move(outer);
  coarse_ = coarse;
  if (!outer_) return;
  tree_ = FaceTree(*outer_);
  const auto& box = turns_->box(TriangleTree::root());
  thinnest_ = kThinnest * (box.high - box.low).norm();
  hidden_.resize(mesh_.faces.size());
  const auto& stay = outer_->faces;
  for (std::size_t face = 0, next = 0; face < hidden_.size(); ++face) {
    while (next < stay.size() && stay[next][0] >= mesh_.vertices.size()) ++next;  // parts
    hidden_[face] = next == stay.size() || stay[next] != mesh_.faces[face];
    if (!hidden_[face]) ++next;
  }
}

/// Fills both kinds of normals. Is the mesh one sheet?
bool MeshDistance::make_pseudonormals() {
  vertex_normals_.assign(mesh_.vertices.size(), Vector3d::Zero());
  normals_.resize(mesh_.faces.size());
  for (std::uint32_t face = 0; face < mesh_.faces.size(); ++face) {
    const Vector3d normal = cloud::face_normal(mesh_, face);
    normals_[face][3] = normal;
    const auto& f = mesh_.faces[face];
    for (std::uint32_t i = 0; i < 3; ++i) {
      const std::uint32_t here = f[i];
      const std::uint32_t next = f[(i + 1) % 3];
      const std::uint32_t last = f[(i + 2) % 3];
      vertex_normals_[here] += angle_at(mesh_.vertices[here], mesh_.vertices[next], mesh_.vertices[last]) * normal;
    }
  }
  const std::vector<FaceEdge> edges = face_edges(mesh_);
  for (std::size_t begin = 0, end = 0; begin < edges.size(); begin = end) {
    Vector3d sum = Vector3d::Zero();
    for (; end < edges.size() && edges[end].same_edge(edges[begin]); ++end) sum += normals_[edges[end].face][3];
    for (std::size_t i = begin; i < end; ++i) normals_[edges[i].face][edges[i].side] = sum;
  }
  return is_one_sheet(mesh_, edges);
}

/// Is the point that this place is nearest to on the inner side of the pseudonormal?
bool MeshDistance::is_behind(const FaceTree::Place& place) const {
  const std::uint32_t number = tree_.faces()[place.face].number;
  const auto feature = static_cast<std::size_t>(place.feature);
  const Vector3d& normal = feature < 3 ? vertex_normals_[mesh_.faces[number][feature]] : normals_[number][feature - 3];
  return place.offset.dot(normal) < 0;
}

bool MeshDistance::any_hidden(const Vector3d& low, const Vector3d& high) const {
  bool found = false;
  turns_->visit(
      [&](const TriangleTree::Box& box) {
        return !found && (box.low.array() - thinnest_ <= high.array()).all() && (box.high.array() + thinnest_ >= low.array()).all();
      },
      [&](std::uint32_t face) { found = found || hidden_[face]; });
  return found;
}

template <class Inside>
bool MeshDistance::most_inside(const Vector3d& point, double distance, const Inside& is_inside_at) const {
  const Vector3d aside = thinnest_ * Vector3d(1.55, 2.15, 2.65);  // leaves every gap along the coordinates, and most others
  if (distance <= aside.norm()) return is_inside_at(point, 0);
  const bool after = is_inside_at(point + aside, 1);
  return is_inside_at(point - aside, 2) == after ? after : is_inside_at(point, 0);
}

bool MeshDistance::is_in(const Vector3d& point, const FaceTree::Place& nearest) const {
  if (!turns_) return is_behind(nearest);
  const auto is_inside_at = [&](const Vector3d& place, std::size_t) { return is_inside(*turns_, place); };
  return outer_ && any_hidden(point, point) ? most_inside(point, std::sqrt(nearest.square), is_inside_at) : is_inside_at(point, 0);
}

double MeshDistance::operator()(const Vector3d& point) const {
  const FaceTree::Place place = tree_.nearest(point);
  const double distance = std::sqrt(place.square);
  return is_in(point, place) ? -distance : distance;
}

MeshDistance::Block MeshDistance::block(const Vector3d& first, double step, double reach) const {
  const Vector3d middle = first + Vector3d::Constant(1.5 * step);
  const FaceTree::Place place = tree_.nearest(middle);
  const double to_middle = std::sqrt(place.square);
  const bool middle_inside = is_in(middle, place);
  Block block{middle_inside ? -to_middle : to_middle, std::nullopt};
  if (to_middle / step > reach) return block;
  // The nearest place of a corner is at most a half diagonal farther from it than the middle's, and from the middle a whole one.
  const FaceTree::Part part = tree_.part(middle, to_middle + 3 * std::sqrt(3.0) * step);

  constexpr std::array<std::size_t, 3> kBack = {1, 4, 16};  // to the point before along each axis
  std::array<double, 64>& result = block.points.emplace();
  std::array<std::uint32_t, 64> faces{};
  std::array<std::optional<TurnsAlong>, 3> turns;  // along the row, and on either side of it, once they are asked for
  const bool beside_hidden = outer_ && any_hidden(first, first + Vector3d::Constant(3 * step));
  // Between two points of which one is farther from the mesh than they are from each other lies no face: they have one sign.
  const double faceless = step * (1 + 1e-9);
  for (std::size_t n = 0; n < result.size(); ++n) {
    const std::array<std::size_t, 3> index = {n & 3, n >> 2 & 3, n >> 4};
    const Vector3d point =
        first + step * Vector3d(static_cast<double>(index[0]), static_cast<double>(index[1]), static_cast<double>(index[2]));
    std::size_t axis = 0;
    while (axis < 2 && index[axis] == 0) ++axis;
    const FaceTree::Place found = tree_.nearest(point, n == 0 ? place.face : faces[n - kBack[axis]], part);
    faces[n] = found.face;
    const double distance = std::sqrt(found.square);
    double alike = 0;  // at a point before it that has the same sign, if there is one
    for (axis = 0; axis < 3; ++axis) {
      if (index[axis] > 0 && std::max(distance, std::abs(result[n - kBack[axis]])) > faceless) alike = result[n - kBack[axis]];
    }
    if (index[0] == 0) turns = {};
    bool inside = alike < 0;
    if (alike == 0 && turns_) {
      const auto is_inside_at = [&](const Vector3d& at, std::size_t line) {
        if (!turns[line]) turns[line].emplace(*turns_, at.y(), at.z());
        return turns[line]->at(at.x()) > 0;
      };
      inside = beside_hidden ? most_inside(point, distance, is_inside_at) : is_inside_at(point, 0);
    } else if (alike == 0) {
      inside = is_behind(found);
    }
    result[n] = inside ? -distance : distance;
  }
  return block;
}

}  // namespace isotouch::field
