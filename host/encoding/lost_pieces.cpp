#include "host/encoding/lost_pieces.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>

#include "host/cloud/placement.h"
#include "host/field/first_hit.h"
#include "host/field/line_crossings.h"
#include "host/field/parallel.h"
#include "host/field/sheets.h"
#include "host/field/triangle_tree.h"
#include "host/to_double.h"

namespace isotouch::encoding {

namespace {

using Eigen::Vector3d;
using Eigen::Vector3i;

constexpr double kNoVolume = 6e-9;  // of the box's diagonal cubed: a piece of less encloses nothing
constexpr double kReach = 1.25;     // voxels: a surface a voxel thick or more has a sample inside as near as this everywhere, by trial
constexpr double kMinPlaces = 32, kMaxPlaces = 1024;  // of one piece that are asked
constexpr int kClear = 16;                            // with that many more shown places than missed ones, or the reverse, it is settled

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

/// Is there a sample whose coefficient has the sign near a place, and the field beside it?
bool shows(const FieldView& view, const Vector3d& in_voxels, bool inside) {
  const Vector3i last(view.size[0] - 1, view.size[1] - 1, view.size[2] - 1);
  const Vector3i low = (in_voxels.array() - kReach).ceil().cast<int>().matrix().cwiseMax(0);
  const Vector3i high = (in_voxels.array() + kReach).floor().cast<int>().matrix().cwiseMin(last);
  for (int z = low.z(); z <= high.z(); ++z) {
    for (int y = low.y(); y <= high.y(); ++y) {
      for (int x = low.x(); x <= high.x(); ++x) {
        const Vector3i sample(x, y, z);
        if ((sample.cast<double>() - in_voxels).squaredNorm() > kReach * kReach) continue;
        const auto value = view.coefficient(x, y, z);
        if ((inside ? value < 0 : value > 0) && shows_at(view, sample, inside)) return true;
      }
    }
  }
  return false;
}

/// A closed piece of a mesh.
struct Piece {
  std::vector<std::uint32_t> faces;
  double six_volumes = 0;
  bool lost = false;
  std::uint32_t face = 0;  ///< the largest of those on which a place is missed
  Vector3d place;          ///< that place

  bool is_body() const { return six_volumes > 0; }
};

std::vector<Piece> pieces_of(const cloud::TriangleMesh& mesh) {
  const std::vector<std::uint32_t> of = field::pieces_of_faces(mesh);
  std::vector<std::size_t> number(mesh.faces.size());
  std::vector<Piece> pieces;
  for (std::uint32_t face = 0; face < of.size(); ++face) {
    std::size_t& own = number[of[face]];
    if (own == 0) {
      pieces.emplace_back();
      own = pieces.size();
    }
    pieces[own - 1].faces.push_back(face);
  }
  return pieces;
}

/// Asks at places that are spread over a piece's area whether the field shows it there. Places inside the union of all pieces do not count.
class Search {
 public:
  Search(const field::TriangleTree& tree, const FieldView& view)
      : tree_(tree), view_(view), edge_(to_double(view.edge)), origin_(to_double(view.origin)) {
    const auto& box = tree.box(field::TriangleTree::root());
    size_ = (box.high - box.low).norm();
  }

  double size() const { return size_; }

  void judge(Piece& piece) const {
    double area = 0;
    std::vector<double> area_up_to;
    const Vector3d origin = tree_.corners(piece.faces[0])[0];
    for (const std::uint32_t face : piece.faces) {
      const auto [a, b, c] = tree_.corners(face);
      piece.six_volumes += (a - origin).dot((b - origin).cross(c - origin));
      area_up_to.push_back(area += area_of(face));
    }
    if (std::abs(piece.six_volumes) <= kNoVolume * size_ * size_ * size_) return;
    const auto places = static_cast<std::size_t>(std::clamp(area / (edge_ * edge_), kMinPlaces, kMaxPlaces));
    int missed = 0;  // more than shown
    double largest = 0;
    for (std::size_t n = 0; n < places && std::abs(missed) < kClear; ++n) {
      const double here = part(n, 0.8191725133961645) * area;
      const auto found = std::upper_bound(area_up_to.begin(), area_up_to.end() - 1, here);
      const std::uint32_t face = piece.faces[static_cast<std::size_t>(found - area_up_to.begin())];
      const auto [a, b, c] = tree_.corners(face);
      const double spread = std::sqrt(part(n, 0.6710436067037893)), along = part(n, 0.5497004779019703);
      const Vector3d place = a + spread * (1 - along) * (b - a) + spread * along * (c - a);
      if (field::is_inside(tree_, place + 1e-6 * size_ * cloud::face_normal(tree_.mesh(), face))) continue;
      if (shows(view_, (place - origin_) / edge_, piece.is_body())) {
        --missed;
        continue;
      }
      ++missed;
      if (area_of(face) <= largest) continue;
      largest = area_of(face);
      piece.face = face;
      piece.place = place;
    }
    piece.lost = missed > 0;
  }

 private:
  double area_of(std::uint32_t face) const {
    const auto [a, b, c] = tree_.corners(face);
    return (b - a).cross(c - a).norm() / 2;
  }
  /// The numbers from 0 on with three such steps spread evenly in a cube, however many there are: R3 sequence of Martin Roberts, 2018.
  static double part(std::size_t number, double step) { return std::fmod((static_cast<double>(number) + 0.5) * step, 1.0); }

  const field::TriangleTree& tree_;
  const FieldView& view_;
  double edge_;
  Vector3d origin_;
  double size_ = 0;
};

}  // namespace

LostPieces lost_pieces(const cloud::TriangleMesh& mesh, const FieldView& view) {
  std::vector<Piece> pieces = pieces_of(mesh);
  const field::TriangleTree tree(mesh);
  const Search search(tree, view);
  field::in_parallel(pieces.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n) search.judge(pieces[n]);
  });
  LostPieces lost;
  for (const Piece& piece : pieces) {
    if (!piece.lost) continue;
    if (lost.pieces + lost.cavities == 0) {
      lost.place = piece.place;
      const Vector3d into = (piece.is_body() ? -1 : 1) * cloud::face_normal(mesh, piece.face);
      const auto hit = field::first_hit(tree, lost.place, into, 1e-9 * search.size());
      lost.thickness_voxel = hit ? hit->t / to_double(view.edge) : 0;
    }
    ++(piece.is_body() ? lost.pieces : lost.cavities);
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
  text += pieces + cavities == 1 ? ", or most of it" : ", or most of each";
  const Vector3d at = placement.to_cloud(place);
  char where[160];
  std::snprintf(where, sizeof where,
                ", too thin for the grid, the first near (%.6g, %.6g, %.6g), "
                "there %.2g voxels thick",
                at.x(), at.y(), at.z(), thickness_voxel);
  return {text + where + "; a smaller --voxel keeps more"};
}

}  // namespace isotouch::encoding
