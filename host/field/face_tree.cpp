#include "host/field/face_tree.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include "host/field/parallel.h"

namespace isotouch::field {

namespace {

using Eigen::Vector3d;

constexpr float kFar = std::numeric_limits<float>::max();

/// A face on its way to its place in the order.
struct Middle {
  std::array<float, 3> at;
  std::uint32_t number;
};

/// A half is a power of two: then the halves' halves are groups of four and sixteen from their first face on.
void sort_by_place(std::span<Middle> middles) {
  if (middles.size() <= 4) {
    std::sort(middles.begin(), middles.end(), [](const Middle& a, const Middle& b) { return a.number < b.number; });
    return;
  }
  std::array<float, 3> low = middles[0].at, high = low;
  for (const Middle& middle : middles) {
    for (std::size_t a = 0; a < 3; ++a) {
      low[a] = std::min(low[a], middle.at[a]);
      high[a] = std::max(high[a], middle.at[a]);
    }
  }
  std::size_t axis = 0;
  for (std::size_t a = 1; a < 3; ++a)
    if (high[a] - low[a] > high[axis] - low[axis]) axis = a;
  const std::size_t half = std::bit_floor(middles.size() - 1);
  std::nth_element(middles.begin(), middles.begin() + static_cast<std::ptrdiff_t>(half), middles.end(),
                   [axis](const Middle& a, const Middle& b) { return std::pair(a.at[axis], a.number) < std::pair(b.at[axis], b.number); });
  sort_by_place(middles.first(half));
  sort_by_place(middles.subspan(half));
}

/// The axes of a box round faces: the last along their normal, the first as the sides of what was cut along the coordinates.
Eigen::Matrix3d axes_of(std::span<const FaceTree::Face> faces) {
  Vector3d area = Vector3d::Zero();
  for (const auto& [corners, number] : faces) area += (corners[1] - corners[0]).cross(corners[2] - corners[0]);
  const double size = area.norm();
  if (!(size > 1e-200)) return Eigen::Matrix3d::Identity();  // no direction, or one that rounding has bent
  const Vector3d normal = area / size;
  int flattest = 0;  // the coordinate that runs most along the faces
  normal.cwiseAbs().minCoeff(&flattest);
  const Vector3d side = Vector3d::Unit(flattest) - normal[flattest] * normal;
  Eigen::Matrix3d axes;
  axes.col(0) = side / side.norm();
  axes.col(1) = normal.cross(axes.col(0));
  axes.col(2) = normal;
  return axes;
}

struct OrientedBox {
  Eigen::Matrix3d axes;
  Vector3d middle, half;
};

OrientedBox box_round(std::span<const FaceTree::Face> faces) {
  const Eigen::Matrix3d axes = axes_of(faces);
  const Vector3d start = faces[0].corners[0];
  Vector3d low = Vector3d::Zero(), high = low;  // along the axes, from the start
  for (const FaceTree::Face& face : faces) {
    for (const Vector3d& corner : face.corners) {
      const Vector3d at = axes.transpose() * (corner - start);
      low = low.cwiseMin(at);
      high = high.cwiseMax(at);
    }
  }
  return {axes, start + axes * (low + high) / 2, (high - low) / 2};
}

}  // namespace

FaceTree::FaceTree(const cloud::TriangleMesh& mesh) {
  std::vector<Middle> order;
  order.reserve(mesh.faces.size());
  double farthest = 0;
  for (const auto& [a, b, c] : mesh.faces) {
    const Vector3d middle = (mesh.vertices[a] + mesh.vertices[b] + mesh.vertices[c]) / 3;
    order.push_back({{static_cast<float>(middle.x()), static_cast<float>(middle.y()), static_cast<float>(middle.z())},
                     static_cast<std::uint32_t>(order.size())});
  }
  for (const Vector3d& vertex : mesh.vertices) farthest = std::max(farthest, vertex.cwiseAbs().maxCoeff());
  sort_by_place(order);
  faces_.reserve(order.size());
  for (const Middle& middle : order) {
    const auto& [a, b, c] = mesh.faces[middle.number];
    faces_.push_back({{mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]}, middle.number});
  }

  // What a coordinate, a point's and a box's, may be off after rounding: together less than half of this.
  const double slack = farthest * (8.0 / (1 << 24));
  leaves_ = (faces_.size() + 3) / 4;
  std::uint32_t first = 0;  // of the faces or nodes in a level's boxes
  std::size_t held = 1;     // faces in each of them
  for (std::size_t count = faces_.size(); nodes_.empty() || count > 1; count = (count + 3) / 4) {
    const auto begin = static_cast<std::uint32_t>(nodes_.size());
    add_level(held, count, first, slack);
    first = begin;
    held *= 4;
  }
}

/// Boxes round so many faces each, but for the last.
void FaceTree::add_level(std::size_t held, std::size_t count, std::uint32_t first, double slack) {
  const Node empty{{all(kFar), all(kFar), all(kFar)}, {{{all(1), {}, {}}, {}, {}}}, {}, 0};
  const std::size_t start = nodes_.size();
  nodes_.resize(start + (count + 3) / 4, empty);
  in_parallel(nodes_.size() - start, std::max<std::size_t>(1, 1024 / held), [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n) {
      Node& node = nodes_[start + n];
      node.first = first + static_cast<std::uint32_t>(4 * n);
      for (std::size_t lane = 0; lane < 4 && 4 * n + lane < count; ++lane) {
        const std::size_t begin_face = (4 * n + lane) * held;
        const OrientedBox box = box_round(std::span(faces_).subspan(begin_face, std::min(held, faces_.size() - begin_face)));
        for (std::size_t a = 0; a < 3; ++a) {
          const auto axis = static_cast<Eigen::Index>(a);
          node.middle[a][lane] = static_cast<float>(box.middle[axis]);
          node.half[a][lane] = static_cast<float>(box.half[axis] + slack + 2e-6 * box.half.sum());
          for (std::size_t b = 0; b < 3; ++b) node.axes[a][b][lane] = static_cast<float>(box.axes(static_cast<Eigen::Index>(b), axis));
        }
      }
    }
  });
}

FaceTree::Place FaceTree::on_face(const Vector3d& point, std::uint32_t face) const {
  const OnTriangle place = nearest_on_triangle(point, faces_[face].corners);
  const Vector3d offset = point - place.point;
  return {offset.squaredNorm(), offset, face, place.feature};
}

FaceTree::Part FaceTree::part(const Vector3d& point, double distance) const {
  const Point at = to_lanes(point);
  for (Part part = whole();;) {
    if (part.nodes[0] < leaves_) return part;
    Part below{{}, 0};
    for (std::size_t n = 0; n < part.count; ++n) {
      const Node& node = nodes_[part.nodes[n]];
      for (unsigned lanes = node.near(at, distance * distance); lanes != 0; lanes &= lanes - 1) {
        if (below.count == below.nodes.size()) return part;
        below.nodes[below.count++] = node.first + static_cast<std::uint32_t>(std::countr_zero(lanes));
      }
    }
    if (below.count == 0) return below;
    part = below;
  }
}

FaceTree::Place FaceTree::nearest(const Vector3d& point, std::uint32_t begin, const Part& part) const {
  Place best = on_face(point, begin);
  if (std::isnan(best.square)) best.square = std::numeric_limits<double>::max();  // a face without area may know no number
  each_near(point, best.square, part, [&](std::uint32_t face) {
    const Place found = on_face(point, face);
    if (found.square < best.square || (found.square == best.square && face < best.face)) best = found;
  });
  return best;
}

std::uint32_t FaceTree::near(const Vector3d& point) const {
  const Point at = to_lanes(point);
  for (std::size_t number = nodes_.size() - 1;;) {
    const Node& node = nodes_[number];
    const Four squares = node.squares_to(at);
    std::uint32_t nearest = 0;
    for (std::uint32_t lane = 1; lane < 4; ++lane)
      if (squares[lane] < squares[nearest]) nearest = lane;
    if (number < leaves_) return node.first + nearest;
    number = node.first + nearest;
  }
}

}  // namespace isotouch::field
