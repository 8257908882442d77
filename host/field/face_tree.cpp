#include "host/field/face_tree.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include "host/field/face_boxes_lanes.h"
#include "host/field/parallel.h"

namespace isotouch::field {

namespace {

using Eigen::Vector3d;

constexpr float kFar = 1e18F;  // the root of kFarSquare

/// A face on its way to its place in the order.
struct Middle {
  std::array<float, 3> at;
  std::uint32_t number;
};

/// A half is a power of two: then the halves' halves are groups of four, and of sixteen, from their first face on.
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

/// The place of the least of the numbers whose bits are set, at least one.
std::uint32_t least_of(unsigned bits, const Row& numbers) {
  auto least = static_cast<std::uint32_t>(std::countr_zero(bits));
  for (unsigned rest = bits & (bits - 1); rest != 0; rest &= rest - 1) {
    const auto other = static_cast<std::uint32_t>(std::countr_zero(rest));
    if (numbers[other] < numbers[least]) least = other;
  }
  return least;
}

void put(const Vector3d& value, std::size_t place, Rows& rows) {
  for (std::size_t a = 0; a < 3; ++a) rows[a][place] = static_cast<float>(value[static_cast<Eigen::Index>(a)]);
}

/// An axis along which the face is flat. Rounding alone makes the normal of a face that is nearly a line.
Vector3d flat_axis(const Corners& corners, const Vector3d& middle) {
  const std::array<Vector3d, 3> edges = {corners[1] - corners[0], corners[2] - corners[1], corners[0] - corners[2]};
  const Vector3d& longest =
      *std::max_element(edges.begin(), edges.end(), [](const Vector3d& a, const Vector3d& b) { return a.squaredNorm() < b.squaredNorm(); });
  const Vector3d area = edges[0].cross(edges[1]);
  const double twice = area.norm();
  const double thick =
      std::max({std::abs(area.dot(corners[0] - middle)), std::abs(area.dot(corners[1] - middle)), std::abs(area.dot(corners[2] - middle))});
  if (twice > 1e-200 && thick <= 1e-6 * twice * longest.norm()) return area / twice;
  return longest.squaredNorm() > 0 ? longest.unitOrthogonal() : Vector3d::UnitX();
}

void put(const Corners& corners, std::size_t place, FlatFaces& faces) {
  const Vector3d middle = (corners[0] + corners[1] + corners[2]) / 3;
  const Vector3d normal = flat_axis(corners, middle), across = normal.unitOrthogonal(), along = normal.cross(across);
  put(middle, place, faces.middle);
  put(across, place, faces.across);
  put(along, place, faces.along);
  put(normal, place, faces.normal);
  for (std::size_t k = 0; k < 3; ++k) {
    faces.corner[k][0][place] = static_cast<float>(across.dot(corners[k] - middle));
    faces.corner[k][1][place] = static_cast<float>(along.dot(corners[k] - middle));
    const double square = (corners[(k + 1) % 3] - corners[k]).squaredNorm();
    faces.inverse[k][place] = square > 1e-30 ? static_cast<float>(1 / square) : 0;
  }
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

  // What the coordinates of a point and of a face may be off after rounding is less than half of this.
  margin_ = farthest * (64.0 / (1 << 24));
  add_leaves();
  std::uint32_t first = 0;       // of the nodes in a level's boxes
  std::size_t held = kTogether;  // faces in each of them
  for (std::size_t count = leaves_.size(); count > 1; count = (count + kTogether - 1) / kTogether) {
    const auto begin = static_cast<std::uint32_t>(leaves_.size() + nodes_.size());
    add_level(held, count, first);
    first = begin;
    held *= kTogether;
  }
}

void FaceTree::add_leaves() {
  FlatFaces empty{};
  for (Row& row : empty.middle) row.fill(kFar);
  empty.normal[0].fill(1);
  leaves_.resize((faces_.size() + kTogether - 1) / kTogether, empty);
  in_parallel(leaves_.size(), 64, [&](std::size_t begin, std::size_t end) {
    for (std::size_t face = kTogether * begin; face < std::min(kTogether * end, faces_.size()); ++face)
      put(faces_[face].corners, face % kTogether, leaves_[face / kTogether]);
  });
}

/// Boxes round so many faces each, but for the last.
void FaceTree::add_level(std::size_t held, std::size_t count, std::uint32_t first) {
  Node empty{};
  for (Row& row : empty.boxes.middle) row.fill(kFar);
  empty.boxes.axes[0][0].fill(1);
  const std::size_t start = nodes_.size();
  nodes_.resize(start + (count + kTogether - 1) / kTogether, empty);
  in_parallel(nodes_.size() - start, std::max<std::size_t>(1, 256 / held), [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n) {
      Node& node = nodes_[start + n];
      node.first = first + static_cast<std::uint32_t>(kTogether * n);
      for (std::size_t lane = 0; lane < kTogether && kTogether * n + lane < count; ++lane) {
        const std::size_t begin_face = (kTogether * n + lane) * held;
        const OrientedBox box = box_round(std::span(faces_).subspan(begin_face, std::min(held, faces_.size() - begin_face)));
        for (std::size_t a = 0; a < 3; ++a) {
          const auto axis = static_cast<Eigen::Index>(a);
          node.boxes.middle[a][lane] = static_cast<float>(box.middle[axis]);
          node.boxes.half[a][lane] = static_cast<float>(box.half[axis]);
          for (std::size_t b = 0; b < 3; ++b)
            node.boxes.axes[a][b][lane] = static_cast<float>(box.axes(static_cast<Eigen::Index>(b), axis));
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
  const std::array<float, 3> at = to_floats(point);
  const float limit = widened(distance);
  for (Part part = whole();;) {
    if (is_leaf(part.nodes[0])) return part;
    Part below{{}, 0};
    bool full = false;
    for (std::size_t n = 0; n < part.count; ++n) {
      each_child(part.nodes[n], at, limit, [&](std::uint32_t child) {
        full = full || below.count == below.nodes.size();
        if (!full) below.nodes[below.count++] = child;
      });
    }
    if (full) return part;
    if (below.count == 0) return below;
    part = below;
  }
}

FaceTree::Place FaceTree::nearest(const Vector3d& point, std::uint32_t begin, const Part& part) const {
  const std::array<float, 3> at = to_floats(point);
  Place best = on_face(point, begin);
  if (std::isnan(best.square)) best.square = 1e30;  // a face without area may know no number
  float limit = widened(std::sqrt(best.square));
  each_leaf(at, limit, part, [&](std::uint32_t leaf) {
    Row squares;
    for (unsigned bits = within_.faces(leaves_[leaf], at, limit, squares); bits != 0;) {
      const std::uint32_t next = least_of(bits, squares);  // it may make the others too far
      if (squares[next] > limit) return;
      bits &= ~(1U << next);
      const std::uint32_t face = first_face(leaf) + next;
      if (face == best.face) continue;
      const Place found = on_face(point, face);
      if (found.square < best.square) limit = widened(std::sqrt(found.square));
      if (found.square < best.square || (found.square == best.square && face < best.face)) best = found;
    }
  });
  return best;
}

std::uint32_t FaceTree::near(const Vector3d& point) const {
  const std::array<float, 3> at = to_floats(point);
  const auto nearest = [&](const auto& sixteen) {
    Row squares;
    for (std::size_t n = 0; n < kTogether; n += 4) store(squares_to(sixteen, n, at), &squares[n]);
    return static_cast<std::uint32_t>(std::min_element(squares.begin(), squares.end()) - squares.begin());
  };
  std::uint32_t node = whole().nodes[0];
  while (!is_leaf(node)) node = inner(node).first + nearest(inner(node).boxes);
  return first_face(node) + nearest(leaves_[node]);
}

}  // namespace isotouch::field
