#include "host/encoding/lost_pieces.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>

#include "host/cloud/placement.h"
#include "host/field/first_hit.h"
#include "host/field/line_crossings.h"
#include "host/field/on_triangle.h"
#include "host/field/parallel.h"
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

/// Has the field this sign at or beside a sample, half a voxel away along any axes?
bool shows_at(const FieldView& view, const Vector3i& sample, bool inside) {
  const double beside = view.interpolation == Interpolation::kTrilinear ? 0 : 0.125;
  std::array<double, 27>
      values;  // coefficients round the sample; then, axis by axis, the field half a voxel before it, at it, and after it
  for (int n = 0; n < 27; ++n) {
    Vector3i at = sample + Vector3i(n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1);
    for (int axis = 0; axis < 3; ++axis) at[axis] = std::clamp(at[axis], 0, view.size[static_cast<std::size_t>(axis)] - 1);
    values[static_cast<std::size_t>(n)] = view.coefficient(at.x(), at.y(), at.z());
  }
  for (const std::size_t step : {1U, 3U, 9U}) {
    for (std::size_t n = 0; n < 27; ++n) {
      if (n / step % 3 != 1) continue;
      double &before = values[n - step], &here = values[n], &after = values[n + step];
      const double middle = (1 - 2 * beside) * here + beside * (before + after);
      before = (before + here) / 2;
      after = (here + after) / 2;
      here = middle;
    }
  }
  return std::any_of(values.begin(), values.end(), [&](double value) { return inside ? value < 0 : value > 0; });
}

/// A face beside a field, of which one sign is asked.
struct Beside {
  const FieldView& view;
  const field::Corners& in_voxels;
  bool inside;

  double square_to(const Vector3d& place) const { return (field::nearest_on_triangle(place, in_voxels).point - place).squaredNorm(); }

  /// Is there a sample whose coefficient has the sign within a voxel of the face, and the field beside it? In a cube of bricks from `first` to `last`,
  /// `side` of them along an edge, a power of two. Cubes farther away are left out whole: the box round a tilted face is mostly empty.
  bool shows(const Vector3i& first, int side, const Vector3i& last) const {
    if ((first.array() > last.array()).any()) return false;
    const double half = (4.0 * side - 1) / 2, reach = 1 + std::sqrt(3.0) * half;
    if (square_to((4 * first).cast<double>() + Vector3d::Constant(half)) > reach * reach) return false;
    if (side > 1) {
      for (int n = 0; n < 8; ++n)
        if (shows(first + side / 2 * Vector3i(n & 1, n >> 1 & 1, n >> 2), side / 2, last)) return true;
      return false;
    }
    const std::int16_t* brick = view.brick(4 * first.x(), 4 * first.y(), 4 * first.z());
    for (int n = 0; n < 64; ++n) {
      if (inside ? brick[n] >= 0 : brick[n] <= 0) continue;
      const Vector3i sample = 4 * first + Vector3i(n & 3, n >> 2 & 3, n >> 4);
      if (square_to(sample.cast<double>()) <= 1 && shows_at(view, sample, inside)) return true;
    }
    return false;
  }
};

bool shows(const FieldView& view, const field::Corners& in_voxels, bool inside) {
  Eigen::AlignedBox3d box;
  for (const Vector3d& corner : in_voxels) box.extend(corner);
  const Vector3i last(view.size[0] - 1, view.size[1] - 1, view.size[2] - 1);
  const Vector3i low = (box.min().array() - 1).ceil().cast<int>().matrix().cwiseMax(0) / 4;
  const Vector3i high = (box.max().array() + 1).floor().cast<int>().matrix().cwiseMin(last) / 4;
  if ((low.array() > high.array()).any()) return false;
  const auto bricks = static_cast<unsigned>((high - low).maxCoeff() + 1);
  return Beside{view, in_voxels, inside}.shows(low, static_cast<int>(std::bit_ceil(bricks)), high);
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
  field::in_parallel(mesh.faces.size(), 16, [&](std::size_t begin, std::size_t end) {
    for (auto face = static_cast<std::uint32_t>(begin); face < end; ++face) {
      Piece& piece = pieces[root[mesh.faces[face][0]]];
      const std::atomic_ref shown(piece.shown);
      if (shown) continue;
      field::Corners in_voxels = tree.corners(face);
      for (Vector3d& corner : in_voxels) corner = (corner - grid) / edge;
      if (shows(view, in_voxels, piece.six_volumes > 0)) shown = true;
    }
  });
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
