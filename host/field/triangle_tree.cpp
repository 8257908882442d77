#include "host/field/triangle_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace isotouch::field {

using Eigen::Vector3d;

namespace {

constexpr int kCurveBits = 21;  // an axis: three of them fill a word

/// Two zero bits between each two bits of a number below 2^21.
std::uint64_t spread_bits(std::uint64_t v) {
  v = (v | v << 32) & 0x001F00000000FFFFULL;
  v = (v | v << 16) & 0x001F0000FF0000FFULL;
  v = (v | v << 8) & 0x100F00F00F00F00FULL;
  v = (v | v << 4) & 0x10C30C30C30C30C3ULL;
  return (v | v << 2) & 0x1249249249249249ULL;
}

TriangleTree::Box empty_box() {
  return {Vector3d::Constant(std::numeric_limits<double>::max()), Vector3d::Constant(std::numeric_limits<double>::lowest())};
}

}  // namespace

TriangleTree::TriangleTree(const cloud::TriangleMesh& mesh) : mesh_(mesh) {
  const std::size_t count = mesh.faces.size();
  Box all = empty_box();
  for (const Vector3d& vertex : mesh.vertices) all = {all.low.cwiseMin(vertex), all.high.cwiseMax(vertex)};
  const double extent = (all.high - all.low).maxCoeff();
  const double scale = extent > 0 ? ((1 << kCurveBits) - 1) / extent : 0;
  std::vector<std::pair<std::uint64_t, std::uint32_t>> along(count);
  for (std::uint32_t face = 0; face < count; ++face) {
    const Corners at = corners(face);
    const Vector3d place = scale * ((at[0] + at[1] + at[2]) / 3 - all.low);
    std::uint64_t code = 0;
    for (int axis = 0; axis < 3; ++axis) code |= spread_bits(static_cast<std::uint64_t>(std::max(0.0, place[axis]))) << axis;
    along[face] = {code, face};
  }
  std::sort(along.begin(), along.end());
  order_.reserve(count);
  for (const auto& [code, face] : along) order_.push_back(face);

  while (leaves_ * kLeafFaces < count) leaves_ *= 2;
  boxes_.assign(2 * leaves_, empty_box());
  for (std::size_t leaf = leaves_; leaf < 2 * leaves_; ++leaf) {
    Box& box = boxes_[leaf];
    for (const std::uint32_t face : faces(leaf)) {
      for (const Vector3d& corner : corners(face)) box = {box.low.cwiseMin(corner), box.high.cwiseMax(corner)};
    }
  }
  for (std::size_t node = leaves_ - 1; node > 0; --node) {
    const Box& a = boxes_[2 * node];
    const Box& b = boxes_[2 * node + 1];
    boxes_[node] = {a.low.cwiseMin(b.low), a.high.cwiseMax(b.high)};
  }
}

/// The leaves share the order evenly, so that the tree is as deep everywhere.
std::span<const std::uint32_t> TriangleTree::faces(std::size_t leaf) const {
  const auto begin_of = [&](std::size_t number) { return number * order_.size() / leaves_; };
  const std::size_t begin = begin_of(leaf - leaves_);
  return std::span(order_).subspan(begin, begin_of(leaf - leaves_ + 1) - begin);
}

TriangleTree::Foot TriangleTree::nearest(const Vector3d& point, double enough, std::uint32_t first) const {
  Foot best{Vector3d::Zero(), 0, 0, 0};
  double best_square = std::numeric_limits<double>::max();
  const auto ask = [&](std::uint32_t face) {
    const OnTriangle found = nearest_on_triangle(point, corners(face));
    const double square = (point - found.point).squaredNorm();
    if (!(square < best_square)) return;  // also where a face without area knows no number
    best_square = square;
    best = {found.point, 0, face, found.feature};
  };
  ask(first);
  std::array<std::pair<std::size_t, double>, 64> waiting;  // at most one a level
  std::size_t count = 0;
  waiting[count++] = {root(), boxes_[root()].squared_distance(point)};
  while (count > 0 && (enough < 0 || !(best_square <= enough * enough))) {
    const auto [node, square] = waiting[--count];
    if (square >= best_square) continue;
    if (!is_leaf(node)) {
      std::pair<std::size_t, double> near{2 * node, boxes_[2 * node].squared_distance(point)};
      std::pair<std::size_t, double> far{2 * node + 1, boxes_[2 * node + 1].squared_distance(point)};
      if (far.second < near.second) std::swap(near, far);
      if (far.second < best_square) waiting[count++] = far;
      waiting[count++] = near;
      continue;
    }
    for (const std::uint32_t face : faces(node)) ask(face);
  }
  best.distance = std::sqrt(best_square);
  return best;
}

}  // namespace isotouch::field
