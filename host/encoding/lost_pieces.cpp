#include "host/encoding/lost_pieces.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>

#include "host/cloud/placement.h"
#include "host/field/first_hit.h"
#include "host/field/line_crossings.h"
#include "host/field/on_triangle.h"
#include "host/field/triangle_tree.h"
#include "host/to_double.h"

namespace isotouch::encoding {

namespace {

using Eigen::Vector3d;
using Eigen::Vector3i;

constexpr double kNoVolume = 6e-9;  // of the box's diagonal cubed: a piece of less encloses nothing

struct Piece {
  double six_volumes = 0, largest_area = 0;
  std::uint32_t largest = 0;  ///< its largest face; of a hollow, of those in front of which nothing is
  bool shown = false;
};

/// The written field at a sample, or half a voxel farther along some axes, in no unit that counts.
double value_at(const FieldView& view, const Vector3i& sample, const Vector3i& halves) {
  double sum = 0;
  for (int n = 0; n < 27; ++n) {
    const Vector3i step(n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1);
    double weight = 1;
    Vector3i at = sample + step;
    for (int axis = 0; axis < 3; ++axis) {
      const bool linear = view.interpolation == Interpolation::kTrilinear;
      const double beside = linear ? 0 : 0.125;
      weight *= halves[axis] != 0 ? (step[axis] < 0 ? 0 : 0.5) : step[axis] == 0 ? 1 - 2 * beside : beside;
      at[axis] = std::clamp(at[axis], 0, view.size[static_cast<std::size_t>(axis)] - 1);
    }
    if (weight > 0) sum += weight * view.coefficient(at.x(), at.y(), at.z());
  }
  return sum;
}

/// Has the field this sign at or beside a sample?
bool shows_at(const FieldView& view, const Vector3i& sample, bool inside) {
  for (int n = 0; n < 27; ++n) {
    const Vector3i step(n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1);  // in halves; back is the half before
    const Vector3i from = sample + step.cwiseMin(0);
    if ((from.array() < 0).any()) continue;
    const double value = value_at(view, from, step.cwiseAbs());
    if (inside ? value < 0 : value > 0) return true;
  }
  return false;
}

/// Has the field this sign beside a sample within a voxel of a face whose coefficient has it?
bool shows(const FieldView& view, const field::Corners& in_voxels, bool inside) {
  Eigen::AlignedBox3d box;
  for (const Vector3d& corner : in_voxels) box.extend(corner);
  const Vector3i last(view.size[0] - 1, view.size[1] - 1, view.size[2] - 1);
  const Vector3i low = (box.min().array() - 1).ceil().cast<int>().matrix().cwiseMax(0) / 4;
  const Vector3i high = (box.max().array() + 1).floor().cast<int>().matrix().cwiseMin(last) / 4;
  const auto square_to = [&](const Vector3d& place) { return (field::nearest_on_triangle(place, in_voxels).point - place).squaredNorm(); };
  constexpr double kBrick = 1 + 2.6;  // a voxel, and from a brick's middle to its farthest sample
  for (Vector3i cell = low; cell.z() <= high.z(); ++cell.z()) {
    for (cell.y() = low.y(); cell.y() <= high.y(); ++cell.y()) {
      for (cell.x() = low.x(); cell.x() <= high.x(); ++cell.x()) {
        if (square_to((4 * cell).cast<double>() + Vector3d::Constant(1.5)) > kBrick * kBrick) continue;
        const std::int16_t* brick = view.brick(4 * cell.x(), 4 * cell.y(), 4 * cell.z());
        for (int n = 0; n < 64; ++n) {
          if (inside ? brick[n] >= 0 : brick[n] <= 0) continue;
          const Vector3i sample = 4 * cell + Vector3i(n & 3, n >> 2 & 3, n >> 4);
          if (square_to(sample.cast<double>()) <= 1 && shows_at(view, sample, inside)) return true;
        }
      }
    }
  }
  return false;
}

}  // namespace

LostPieces lost_pieces(const cloud::TriangleMesh& mesh, const FieldView& view) {
  const std::vector<std::uint32_t> root = cloud::pieces_of_vertices(mesh);
  std::vector<Piece> pieces(mesh.vertices.size());
  const field::TriangleTree tree(mesh);
  for (std::uint32_t face = 0; face < mesh.faces.size(); ++face) {
    const auto [a, b, c] = tree.corners(face);
    Piece& piece = pieces[root[mesh.faces[face][0]]];
    const Vector3d& origin = mesh.vertices[root[mesh.faces[face][0]]];
    piece.six_volumes += (a - origin).dot((b - origin).cross(c - origin));
  }
  const double edge = to_double(view.edge);
  const Vector3d grid = to_double(view.origin);
  for (std::uint32_t face = 0; face < mesh.faces.size(); ++face) {
    Piece& piece = pieces[root[mesh.faces[face][0]]];
    if (piece.shown) continue;
    field::Corners in_voxels = tree.corners(face);
    for (Vector3d& corner : in_voxels) corner = (corner - grid) / edge;
    piece.shown = shows(view, in_voxels, piece.six_volumes > 0);
  }
  const auto& box = tree.box(field::TriangleTree::root());
  const double size = (box.high - box.low).norm();
  for (std::uint32_t face = 0; face < mesh.faces.size(); ++face) {
    Piece& piece = pieces[root[mesh.faces[face][0]]];
    if (piece.shown) continue;
    const auto [a, b, c] = tree.corners(face);
    const double area = (b - a).cross(c - a).norm();
    if (area <= piece.largest_area) continue;
    const Vector3d ahead = (a + b + c) / 3 + 1e-6 * size * cloud::face_normal(mesh, face);
    if (piece.six_volumes < 0 && field::is_inside(tree, ahead)) continue;  // another piece fills the hollow there
    piece.largest_area = area;
    piece.largest = face;
  }
  LostPieces lost;
  for (const Piece& piece : pieces) {
    if (piece.shown || piece.largest_area == 0 || std::abs(piece.six_volumes) <= kNoVolume * size * size * size) continue;
    if (lost.pieces + lost.cavities == 0) {
      const auto [a, b, c] = tree.corners(piece.largest);
      lost.place = (a + b + c) / 3;
      const Vector3d into = (piece.six_volumes > 0 ? -1 : 1) * cloud::face_normal(mesh, piece.largest);
      const auto hit = field::first_hit(tree, lost.place, into, 1e-9 * size);
      lost.thickness_voxel = hit ? hit->t / edge : 0;
    }
    ++(piece.six_volumes > 0 ? lost.pieces : lost.cavities);
  }
  return lost;
}

std::vector<std::string> LostPieces::warnings(const cloud::Placement& placement) const {
  if (pieces + cavities == 0) return {};
  const auto count_of = [](std::size_t count, const char* one, const char* many) {
    return std::to_string(count) + ' ' + (count == 1 ? one : many);
  };
  std::string text;
  if (pieces > 0) text = count_of(pieces, "closed piece of the mesh is", "closed pieces of the mesh are") + " left out";
  if (cavities > 0)
    text += (pieces > 0 ? " and " : "") + count_of(cavities, "hollow of the mesh is", "hollows of the mesh are") + " filled";
  const Vector3d at = placement.to_cloud(place);
  char where[160];
  std::snprintf(where, sizeof where,
                ", too thin for the grid, the first near (%.6g, %.6g, %.6g), "
                "there %.2g voxels thick",
                at.x(), at.y(), at.z(), thickness_voxel);
  return {text + where + "; a smaller --voxel keeps more"};
}

}  // namespace isotouch::encoding
