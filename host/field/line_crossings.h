/// Where lines parallel to x cross a closed surface of triangles, and with them what lies inside it.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "host/field/triangle_tree.h"

namespace isotouch::field {

/// Twice the area of the triangle that a line at (y, z) makes with an edge, in the plane across it. Both faces of an edge get the same number but
/// for its sign, because the corners enter in an order of their own; on the edge itself the line counts as left of the edge that runs upward.
/// Zero only where the line sees both ends as one point.
inline double side_of_edge(const Eigen::Vector3d& a, const Eigen::Vector3d& b, double y, double z) {
  if (a.y() == b.y() && a.z() == b.z()) return 0;
  const bool turned = a.y() > b.y() || (a.y() == b.y() && a.z() > b.z());
  const Eigen::Vector3d& p = turned ? b : a;
  const Eigen::Vector3d& q = turned ? a : b;
  const double area = (q.y() - p.y()) * (z - p.z()) - (q.z() - p.z()) * (y - p.y());
  const double decided = area != 0 ? area : 1e-300;
  return turned ? -decided : decided;
}

/// Calls use(x, turn) for every face that the line at (y, z) crosses, in no order: turn is 1 where a line that runs along +x enters, -1 where it
/// leaves. The line never falls between two faces of an edge, and never on both: see side_of_edge.
template <class Use>
void each_crossing(const TriangleTree& tree, double y, double z, const Use& use) {
  const auto meets = [&](const TriangleTree::Box& box) {
    return box.low.y() <= y && y <= box.high.y() && box.low.z() <= z && z <= box.high.z();
  };
  tree.visit(meets, [&](std::uint32_t face) {
    const auto [a, b, c] = tree.corners(face);
    const double ab = side_of_edge(a, b, y, z), bc = side_of_edge(b, c, y, z), ca = side_of_edge(c, a, y, z);
    const bool left = ab > 0 && bc > 0 && ca > 0;
    const bool right = ab < 0 && bc < 0 && ca < 0;
    // Counter-clockwise in y, z: the face looks along x, so the line leaves.
    if (left || right) use((a.x() * bc + b.x() * ca + c.x() * ab) / (ab + bc + ca), left ? -1 : 1);
  });
}

/// How often the surface turns round the points of one line: their winding numbers.
class TurnsAlong {
 public:
  TurnsAlong(const TriangleTree& tree, double y, double z) {
    each_crossing(tree, y, z, [&](double x, int turn) { crossings_.push_back({x, turn}); });
  }
  int at(double x) const {
    int turns = 0;
    for (const Crossing& crossing : crossings_) turns += crossing.x < x ? crossing.turn : 0;
    return turns;
  }

 private:
  struct Crossing {
    double x;
    int turn;
  };
  std::vector<Crossing> crossings_;
};

/// How often it turns round one point.
inline int turns_round(const TriangleTree& tree, const Eigen::Vector3d& point) {
  return TurnsAlong(tree, point.y(), point.z()).at(point.x());
}

/// Does it turn round the point once or more? So parts that run through each other are inside, and no normal has to be trusted.
inline bool is_inside(const TriangleTree& tree, const Eigen::Vector3d& point) { return turns_round(tree, point) > 0; }

}  // namespace isotouch::field
