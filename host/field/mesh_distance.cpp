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
  outer_ = outer_faces(mesh_, tree_, *turns_, crossings_.faces > 0 || crossings_.touching);
  if (!outer_) return;
  tree_ = FaceTree(*outer_);
  const auto& box = turns_->box(TriangleTree::root());
  size_ = (box.high - box.low).norm();
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

Vector3d MeshDistance::out_of_gaps(double distance) const {
  const Vector3d aside = kThinnest * size_ * Vector3d(1.55, 2.15, 2.65);  // leaves every gap along the coordinates, and most others
  return distance > aside.norm() ? aside : Vector3d::Zero();
}

double MeshDistance::operator()(const Vector3d& point) const {
  const FaceTree::Place place = tree_.nearest(point);
  const double distance = std::sqrt(place.square);
  const bool inside = turns_ ? is_inside(*turns_, point + out_of_gaps(distance)) : is_behind(place);
  return inside ? -distance : distance;
}

MeshDistance::Block MeshDistance::block(const Vector3d& first, double step, double reach) const {
  const Vector3d middle = first + Vector3d::Constant(1.5 * step);
  const FaceTree::Place place = tree_.nearest(middle);
  const double to_middle = std::sqrt(place.square);
  const bool middle_inside = turns_ ? is_inside(*turns_, middle + out_of_gaps(to_middle)) : is_behind(place);
  Block block{middle_inside ? -to_middle : to_middle, std::nullopt};
  if (to_middle / step > reach) return block;
  // The nearest place of a corner is at most a half diagonal farther from it than the middle's, and from the middle a whole one.
  const FaceTree::Part part = tree_.part(middle, to_middle + 3 * std::sqrt(3.0) * step);

  constexpr std::array<std::size_t, 3> kBack = {1, 4, 16};  // to the point before along each axis
  std::array<double, 64>& result = block.points.emplace();
  std::array<std::uint32_t, 64> faces{};
  std::array<std::optional<TurnsAlong>, 2> turns;  // along the row, and beside it, once they are asked for
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
      const Vector3d aside = out_of_gaps(distance), at = point + aside;
      std::optional<TurnsAlong>& row = turns[aside.x() > 0 ? 1 : 0];
      if (!row) row.emplace(*turns_, at.y(), at.z());
      inside = row->at(at.x()) > 0;
    } else if (alike == 0) {
      inside = is_behind(found);
    }
    result[n] = inside ? -distance : distance;
  }
  return block;
}

}  // namespace isotouch::field
