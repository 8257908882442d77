#include "host/field/outer_faces.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <numeric>
#include <utility>
#include <vector>

#include "host/field/face_edges.h"
#include "host/field/face_pairs.h"
#include "host/field/line_crossings.h"
#include "host/field/parallel.h"
#include "host/field/sets.h"

namespace isotouch::field {

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kReach = 1e-6;             // of the mesh's size: meetings are as exact as this
constexpr double kFinest = 1.0 / 2048;      // of the mesh's size: parts of a face are not cut further
constexpr std::size_t kMaxParts = 500'000;  // of all faces: bounds memory and time

/// A part of the line along which another face meets this one, in this one's plane.
struct Meeting {
  Vector2d begin, end;
};

class Plane {
 public:
  explicit Plane(const Corners& face)
      : origin_(face[0]),
        normal_((face[1] - face[0]).cross(face[2] - face[0]).normalized()),
        x_((face[1] - face[0]).normalized()),
        y_(normal_.cross(x_)) {}
  Vector2d seen(const Vector3d& p) const { return {x_.dot(p - origin_), y_.dot(p - origin_)}; }
  double height(const Vector3d& p) const { return normal_.dot(p - origin_); }
  const Vector3d& normal() const { return normal_; }

 private:
  Vector3d origin_, normal_, x_, y_;
};

/// Appends where another face meets the plane: a segment; or, where it lies in it, its edges. Corners as near as `near` lie in the plane.
void add_meetings(const Plane& plane, const Corners& other, double near, std::vector<Meeting>& meetings) {
  std::array<double, 3> height;
  for (std::size_t i = 0; i < 3; ++i) {
    height[i] = plane.height(other[i]);
    if (std::abs(height[i]) <= near) height[i] = 0;
  }
  std::array<Vector2d, 3> places;
  std::size_t count = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    if (height[i] == 0) places[count++] = plane.seen(other[i]);
    if ((height[i] < 0 && height[j] > 0) || (height[i] > 0 && height[j] < 0))
      places[count++] = plane.seen(other[i] + height[i] / (height[i] - height[j]) * (other[j] - other[i]));
  }
  if (count == 2) meetings.push_back({places[0], places[1]});
  for (std::size_t i = 0; i < 3 && count == 3; ++i) meetings.push_back({places[i], places[(i + 1) % 3]});
}

/// How much of a segment lies in a triangle whose sides are moved inward by `inset`. The corners run counter-clockwise.
double length_in(const Meeting& meeting, const std::array<Vector2d, 3>& corners, double inset) {
  const Vector2d way = meeting.end - meeting.begin;
  double from = 0, until = 1;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector2d side = (corners[(i + 1) % 3] - corners[i]).normalized(), inward(-side.y(), side.x());
    const double before = inward.dot(meeting.begin - corners[i]) - inset, change = inward.dot(way);
    if (change == 0 && before < 0) return 0;
    if (change > 0) from = std::max(from, -before / change);
    if (change < 0) until = std::min(until, -before / change);
  }
  return std::max(until - from, 0.0) * way.norm();
}

/// A side of a face: from the corner of this number to the next.
struct Side {
  std::size_t from = 0;
  double length = 0;
};

/// The first of equally long ones.
Side longest_side(const Corners& face) {
  Side longest;
  for (std::size_t i = 0; i < 3; ++i) {
    const double length = (face[(i + 1) % 3] - face[i]).norm();
    if (length > longest.length) longest = {i, length};
  }
  return longest;
}

/// Is the union on one side of a face alone?
class Sides {
 public:
  Sides(const TriangleTree& turns, double size) : turns_(turns), step_(kThinnest * size) {}
  bool differ(const Vector3d& place, const Vector3d& normal) const {
    return is_inside(turns_, place + step_ * normal) != is_inside(turns_, place - step_ * normal);
  }

 private:
  const TriangleTree& turns_;
  double step_;
};

/// Cuts one face.
class Cutter {
 public:
  Cutter(const Corners& face, double reach, double finest) : plane_(face), reach_(reach), finest_(finest) {}

  /// Appends what stays of a part. Does all of it?
  bool cut(const Corners& part, const std::vector<Meeting>& near, const Sides& sides, std::vector<Corners>& stay) const {
    const std::vector<Meeting> meetings = those_in(part, near);
    if (is_last(part, meetings)) {
      const Vector3d middle = (part[0] + part[1] + part[2]) / 3;
      bool stays = sides.differ(middle, plane_.normal());
      // A straight cut leaves a corner on each side. Where none is left, a tip may still stand on the middle.
      const double outward = meetings.empty() ? 0.5 : 0.999;
      for (std::size_t i = 0; i < 3; ++i) stays = stays || sides.differ(middle + outward * (part[i] - middle), plane_.normal());
      if (stays) stay.push_back(part);
      return stays;
    }
    const std::size_t before = stay.size();
    bool all = true;
    for (const Corners& half : halves(part)) all = cut(half, meetings, sides, stay) && all;
    if (!all) return false;
    stay.resize(before);
    stay.push_back(part);
    return true;
  }

  /// Counts the parts that it is cut into, up to a number.
  void count(const Corners& part, const std::vector<Meeting>& near, std::size_t most, std::size_t& parts) const {
    if (parts > most) return;
    const std::vector<Meeting> meetings = those_in(part, near);
    if (is_last(part, meetings)) {
      ++parts;
      return;
    }
    for (const Corners& half : halves(part)) count(half, meetings, most, parts);
  }

 private:
  std::vector<Meeting> those_in(const Corners& part, const std::vector<Meeting>& near) const {
    const std::array<Vector2d, 3> seen = {plane_.seen(part[0]), plane_.seen(part[1]), plane_.seen(part[2])};
    std::vector<Meeting> meetings;
    std::copy_if(near.begin(), near.end(), std::back_inserter(meetings),
                 [&](const Meeting& meeting) { return length_in(meeting, seen, reach_) > reach_; });
    return meetings;
  }
  bool is_last(const Corners& part, const std::vector<Meeting>& meetings) const {
    return meetings.empty() || longest_side(part).length <= finest_;
  }
  static std::array<Corners, 2> halves(const Corners& part) {
    const std::size_t from = longest_side(part).from;
    const Vector3d &a = part[from], &b = part[(from + 1) % 3], &c = part[(from + 2) % 3], middle = (a + b) / 2;
    return {Corners{a, middle, c}, {middle, b, c}};
  }

  Plane plane_;
  double reach_, finest_;
};

/// Where others meet a face.
struct Met {
  std::vector<Meeting> within;  ///< through its inside
  bool touched = false;         ///< it, or its rim elsewhere than where faces share a corner or an edge
};

/// Do two faces with one common corner meet elsewhere? Only if one's edge opposite that corner meets the other.
bool meet_elsewhere(const Corners& a, const Corners& b, const Common& common, double near) {
  return edge_touches(a[(common.of_a + 1) % 3], a[(common.of_a + 2) % 3], b, near) ||
         edge_touches(b[(common.of_b + 1) % 3], b[(common.of_b + 2) % 3], a, near);
}

/// What meets each face. All that `Sides` can reach is near.
std::vector<Met> meetings_of(const cloud::TriangleMesh& mesh, const FaceTree& tree, double size) {
  constexpr std::size_t kGroup = 8;  // faces that follow each other lie together
  const double reach = kReach * size, near = kNear * size;
  const std::span faces(tree.faces());
  std::vector<Met> all(faces.size());
  in_parallel((faces.size() + kGroup - 1) / kGroup, 32, [&](std::size_t begin, std::size_t end) {
    std::vector<BoxedFace> others;
    std::vector<Meeting> meetings;
    for (std::size_t group = begin; group < end; ++group) {
      const auto together = faces.subspan(kGroup * group, std::min(kGroup, faces.size() - kGroup * group));
      faces_near(tree, together, near, others);
      for (const FaceTree::Face& face : together) {
        const Corners& corners = face.corners;
        const BoxedFace boxed(face);
        const Plane plane(corners);
        if (!(plane.normal().squaredNorm() > 0.5)) continue;  // no area
        const std::array<Vector2d, 3> seen = {plane.seen(corners[0]), plane.seen(corners[1]), plane.seen(corners[2])};
        Met& met = all[face.number];
        for (const BoxedFace& other : others) {
          if (other.number == face.number || !boxes_meet(boxed, other, near)) continue;
          const Common common = common_corners(mesh.faces[face.number], mesh.faces[other.number]);
          if (common.count == 3 || (common.count == 1 && !meet_elsewhere(corners, other.face->corners, common, near))) continue;
          meetings.clear();
          add_meetings(plane, other.face->corners, near, meetings);
          if (common.count == 2 && meetings.size() < 3) continue;  // an edge
          for (const Meeting& meeting : meetings) {
            const double within = length_in(meeting, seen, reach);
            if (within > reach) met.within.push_back(meeting);
            met.touched = met.touched || within > reach || (common.count < 2 && length_in(meeting, seen, -near) > 10 * reach);
          }
        }
      }
    }
  });
  return all;
}

/// Of each face the one to ask for it: faces that nothing touches have the union on the same sides as their neighbours, so the largest of each sheet
/// of them stands for all.
std::vector<std::uint32_t> spokesmen(const cloud::TriangleMesh& mesh, const std::vector<FaceEdge>& edges, const std::vector<Met>& met) {
  Sets sheets(mesh.faces.size());
  for (std::size_t begin = 0, end = 0; begin < edges.size(); begin = end) {
    while (end < edges.size() && edges[end].same_edge(edges[begin])) ++end;
    const std::uint32_t a = edges[begin].face, b = edges[end - 1].face;
    if (end - begin != 2 || met[a].touched || met[b].touched) continue;
    const std::uint32_t root = sheets.of(a), other = sheets.of(b);
    if (root != other) sheets.join(root, other);
  }
  const auto area = [&](std::uint32_t face) {
    const auto& [a, b, c] = mesh.faces[face];
    return (mesh.vertices[b] - mesh.vertices[a]).cross(mesh.vertices[c] - mesh.vertices[a]).squaredNorm();
  };
  std::vector<std::uint32_t> largest(mesh.faces.size());
  std::iota(largest.begin(), largest.end(), 0U);
  for (std::uint32_t face = 0; face < mesh.faces.size(); ++face) {
    std::uint32_t& of_sheet = largest[sheets.of(face)];
    if (area(face) > area(of_sheet)) of_sheet = face;
  }
  std::vector<std::uint32_t> all(mesh.faces.size());
  for (std::uint32_t face = 0; face < mesh.faces.size(); ++face) all[face] = largest[sheets.of(face)];
  return all;
}

/// Would the faces asked be cut into more parts than are allowed? One that is not cut adds none.
bool are_too_many(const TriangleTree& turns, const std::vector<std::uint32_t>& asked, const std::vector<Met>& met, double reach,
                  double finest) {
  std::atomic<std::size_t> all{0};
  in_parallel(asked.size(), 16, [&](std::size_t begin, std::size_t end) {
    for (auto face = static_cast<std::uint32_t>(begin); face < end && all <= kMaxParts; ++face) {
      if (asked[face] != face || met[face].within.empty()) continue;
      const Corners corners = turns.corners(face);
      std::size_t parts = 0;
      Cutter(corners, reach, finest).count(corners, met[face].within, kMaxParts, parts);
      all += parts - 1;
    }
  });
  return all > kMaxParts;
}

/// Is there an edge of more than two faces?
bool any_branches(const std::vector<FaceEdge>& edges) {
  for (std::size_t n = 2; n < edges.size(); ++n)
    if (edges[n].same_edge(edges[n - 2])) return true;
  return false;
}

}  // namespace

OuterFaces outer_faces(const cloud::TriangleMesh& mesh, const FaceTree& tree, const TriangleTree& turns, bool meet) {
  const auto& box = turns.box(TriangleTree::root());
  const double size = (box.high - box.low).norm(), reach = kReach * size;
  const std::vector<FaceEdge> edges = face_edges(mesh);
  const std::vector<Met> met = meet || any_branches(edges) ? meetings_of(mesh, tree, size) : std::vector<Met>(mesh.faces.size());
  const Sides sides(turns, size);

  const std::vector<std::uint32_t> asked = spokesmen(mesh, edges, met);
  double finest = kFinest * size;
  while (are_too_many(turns, asked, met, reach, finest)) finest *= 2;
  std::vector<std::vector<Corners>> stay(mesh.faces.size());  // one part: all of the face
  std::vector<std::uint8_t> whole(mesh.faces.size());
  in_parallel(mesh.faces.size(), 16, [&](std::size_t begin, std::size_t end) {
    for (auto face = static_cast<std::uint32_t>(begin); face < end; ++face) {
      if (asked[face] != face) continue;
      const Corners corners = turns.corners(face);
      whole[face] = Cutter(corners, reach, finest).cut(corners, met[face].within, sides, stay[face]) ? 1 : 0;
    }
  });
  cloud::TriangleMesh outer{mesh.vertices, {}};
  for (std::size_t face = 0; face < mesh.faces.size(); ++face) {
    if (whole[asked[face]] != 0) {
      outer.faces.push_back(mesh.faces[face]);
      continue;
    }
    for (const Corners& part : stay[face]) {
      const auto first = static_cast<std::uint32_t>(outer.vertices.size());
      outer.vertices.insert(outer.vertices.end(), part.begin(), part.end());
      outer.faces.push_back({first, first + 1, first + 2});
    }
  }
  if (outer.faces.empty() || (outer.faces.size() == mesh.faces.size() && outer.vertices.size() == mesh.vertices.size())) return {};
  return {std::move(outer), finest > kFinest * size ? finest / size : 0.0};
}

}  // namespace isotouch::field
