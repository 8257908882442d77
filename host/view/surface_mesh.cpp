#include "host/view/surface_mesh.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <unordered_map>

#include "host/view/field_ray.h"
#include "host/view/invented.h"

namespace isotouch::view {

namespace {

using Eigen::Vector3d;
using Eigen::Vector3i;

constexpr int kBrickSide = 1 << image_layout::kBrickShift;
constexpr int kNodeSide = 1 << image_layout::kNodeShift;
constexpr std::size_t kVerticesPerBrick = 24;  ///< about, at a step of one voxel

/// Corner n of a cube: bit 0 is x, bit 1 y, bit 2 z.
Vector3i corner(int n) { return {n & 1, n >> 1 & 1, n >> 2}; }

struct BySamples {
  bool operator()(const Vector3i& a, const Vector3i& b) const {
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
  }
};
using Bricks = std::set<Vector3i, BySamples>;

/// The first sample of each brick that the surface passes through.
Bricks crossed_bricks(const FieldView& field) {
  Bricks bricks;
  for (int k = 0; k < field.size[2]; k += kNodeSide) {
    for (int j = 0; j < field.size[1]; j += kNodeSide) {
      for (int i = 0; i < field.size[0]; i += kNodeSide) {
        const std::uint32_t node = field.root[field.root_entry(i, j, k)];
        if (node == image_layout::kOutside || node == image_layout::kInside) continue;
        for (int slot = 0; slot < static_cast<int>(image_layout::kBricksPerNode); ++slot) {
          const Vector3i first(i + kBrickSide * (slot & 3), j + kBrickSide * (slot >> 2 & 3), k + kBrickSide * (slot >> 4));
          if (first.x() >= field.size[0] || first.y() >= field.size[1] || first.z() >= field.size[2]) continue;
          const std::uint32_t brick = field.brick_number(first.x(), first.y(), first.z());
          if (brick != image_layout::kOutside && brick != image_layout::kInside && field_file::is_crossed(field, brick))
            bricks.insert(first);
        }
      }
    }
  }
  return bricks;
}

class Net {
 public:
  Net(const FieldView& field, const field_file::Marks& marks, SurfaceMesh& mesh) : rays_(field), invented_(field, marks), mesh_(mesh) {}

  /// The cubes whose lower corner lies in this brick.
  void visit(const Vector3i& brick) {
    const int step = mesh_.step, side = kBrickSide / step + 1;
    std::vector<double> distance(static_cast<std::size_t>(side * side * side));
    const auto at = [&](const Vector3i& p) { return static_cast<std::size_t>((p.z() * side + p.y()) * side + p.x()); };
    for (int n = 0; n < side * side * side; ++n) {
      const Vector3i p(n % side, n / side % side, n / side / side);
      distance[at(p)] = rays_.value(to_mm(brick + step * p)).distance;
    }
    for (int n = 0; n < (side - 1) * (side - 1) * (side - 1); ++n) {
      const Vector3i p(n % (side - 1), n / (side - 1) % (side - 1), n / (side - 1) / (side - 1));
      std::array<double, 8> corners{};
      for (int c = 0; c < 8; ++c) corners[static_cast<std::size_t>(c)] = distance[at(p + corner(c))];
      add_cube(brick + step * p, corners);
    }
  }

  /// Four cubes round each edge that the surface crosses give two triangles.
  void join() {
    for (const auto& [lower, axis, outward] : edges_) {
      const int u = (axis + 1) % 3, v = (axis + 2) % 3;
      std::array<std::uint32_t, 4> quad{};
      bool whole = true;
      for (int n = 0; n < 4; ++n) {
        Vector3i cube = lower;
        if (n == 1 || n == 2) cube[u] -= mesh_.step;
        if (n == 2 || n == 3) cube[v] -= mesh_.step;
        const auto found = vertices_.find(key(cube));
        whole = whole && found != vertices_.end();
        if (whole) quad[static_cast<std::size_t>(n)] = found->second;
      }
      if (!whole) continue;
      if (!outward) std::swap(quad[1], quad[3]);
      mesh_.faces.push_back({quad[0], quad[1], quad[2]});
      mesh_.faces.push_back({quad[0], quad[2], quad[3]});
    }
  }

 private:
  struct Edge {
    Vector3i lower;
    int axis;
    bool outward;  ///< the surface faces along the axis
  };

  Vector3d to_mm(const Vector3i& sample) const {
    const FieldView& field = rays_.field();
    const double fine = static_cast<double>(1 << Mm::kFractionBits);
    return Vector3d(field.origin.x.raw(), field.origin.y.raw(), field.origin.z.raw()) / fine + rays_.edge() * sample.cast<double>();
  }
  std::uint64_t key(const Vector3i& p) const {  // bricks begin at 0; cubes below it have no vertex
    const auto number = [](int value) { return static_cast<std::uint64_t>(value + 8); };
    return number(p.x()) | number(p.y()) << 20 | number(p.z()) << 40;
  }

  void add_cube(const Vector3i& lower, const std::array<double, 8>& corners) {
    Vector3d sum = Vector3d::Zero();
    int crossings = 0;
    for (int c = 0; c < 8; ++c) {
      for (int axis = 0; axis < 3; ++axis) {
        const int other = c | 1 << axis;
        const double a = corners[static_cast<std::size_t>(c)], b = corners[static_cast<std::size_t>(other)];
        if (other == c || (a <= 0) == (b <= 0)) continue;
        Vector3d place = corner(c).cast<double>();
        place[axis] = a / (a - b);
        sum += place;
        ++crossings;
        if (c == 0) edges_.push_back({lower, axis, a <= 0});
      }
    }
    if (crossings == 0) return;
    const Vector3d middle = to_mm(lower) + rays_.edge() * mesh_.step * (sum / crossings);
    vertices_.emplace(key(lower), static_cast<std::uint32_t>(mesh_.positions.size()));
    add_vertex(middle);
  }

  void add_vertex(const Vector3d& middle) {
    Vector3d place = middle;
    FieldRays::Value value = rays_.value(place);
    const double most = 0.5 * mesh_.step * rays_.edge();  // it stays in or near its cube
    for (int i = 0; i < 2 && value.gradient.squaredNorm() > 0.01; ++i) {
      const Vector3d next = place - rays_.edge() * value.distance / value.gradient.squaredNorm() * value.gradient;
      if ((next - middle).norm() > most) break;
      place = next;
      value = rays_.value(place);
    }
    const double length = value.gradient.norm();
    mesh_.positions.push_back(place.cast<float>());
    mesh_.normals.emplace_back(length > 0 ? Vector3d(value.gradient / length).cast<float>() : Eigen::Vector3f(0, 0, 1));
    mesh_.invented.push_back(invented_.at(rays_.to_index(place)) ? 1 : 0);
  }

  FieldRays rays_;
  Invented invented_;
  SurfaceMesh& mesh_;
  std::unordered_map<std::uint64_t, std::uint32_t> vertices_;
  std::vector<Edge> edges_;
};

}  // namespace

SurfaceMesh surface_mesh(const FieldView& field, const field_file::Marks& invented, std::size_t vertices) {
  const Bricks crossed = crossed_bricks(field);
  SurfaceMesh mesh;
  for (std::size_t about = kVerticesPerBrick * crossed.size(); about > vertices && mesh.step < kBrickSide; about /= 4) mesh.step *= 2;
  Bricks visited = crossed;  // a cube may begin in the brick below
  for (const Vector3i& brick : crossed) {
    for (int n = 1; n < 8; ++n) {
      const Vector3i below = brick - kBrickSide * corner(n);
      if (below.minCoeff() >= 0) visited.insert(below);
    }
  }
  Net net(field, invented, mesh);
  for (const Vector3i& brick : visited) net.visit(brick);
  net.join();
  return mesh;
}

}  // namespace isotouch::view
