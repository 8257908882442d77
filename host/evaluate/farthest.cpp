#include "host/evaluate/farthest.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace isotouch::evaluate {

using Eigen::Vector3d;
using field::Corners;
using field::TriangleTree;

namespace {

constexpr std::size_t kFirstLook = 16;  // every so many faces are asked before anything is left out

/// A node of the tree that is still to be looked at.
struct Open {
  double bound;  // no point in it is farther
  std::size_t node;

  bool operator<(const Open& o) const { return bound != o.bound ? bound < o.bound : node > o.node; }
};

class Search {
 public:
  Search(const TriangleTree& surface, const TriangleTree& other, double fineness)
      : surface_(surface), other_(other), fineness_(fineness), slack_(fineness / 8), asked_(surface.mesh().vertices.size(), false) {}

  Farthest run() {
    const Vector3d& first = surface_.mesh().vertices[surface_.mesh().faces[0][0]];
    best_ = {first, other_.nearest(first).distance};
    for (std::size_t face = 0; face < surface_.mesh().faces.size(); face += kFirstLook) {
      ask(surface_.mesh().vertices[surface_.mesh().faces[face][0]], slack_);
    }
    add_node(TriangleTree::root());
    while (!open_.empty() && open_.top().bound > best_.distance + fineness_) {
      const std::size_t node = open_.top().node;
      open_.pop();
      if (!surface_.is_leaf(node)) {
        add_node(2 * node);
        add_node(2 * node + 1);
      } else {
        for (const std::uint32_t face : surface_.faces(node)) {
          for (const std::uint32_t vertex : surface_.mesh().faces[face]) {
            if (!asked_[vertex]) ask(surface_.mesh().vertices[vertex], slack_);
            asked_[vertex] = true;
          }
          search(surface_.corners(face));
        }
      }
    }
    return best_;
  }

 private:
  /// So large that hardly an answer could leave it out: it is divided without a question that would have to be answered to the end.
  bool coarse(double reach) const { return reach > best_.distance / 2; }

  /// At least the distance from a place, and exact where it is more than `more` above the farthest so far. Neighbours follow each other mostly, so
  /// the last answer's face is often near enough at once.
  double measure(const Vector3d& place, double more) {
    const TriangleTree::Foot foot = other_.nearest(place, best_.distance + more, last_face_);
    last_face_ = foot.face;
    return foot.distance;
  }

  double ask(const Vector3d& place, double more) {
    const double distance = measure(place, more);
    if (distance > best_.distance + more) best_ = {place, distance};
    return distance;
  }

  /// By how much the middle of a part may be farther, and no point of the part too far.
  double more_for(double reach) const { return coarse(reach) ? slack_ : std::max(slack_, fineness_ - reach); }

  /// The middle of a box lies on no surface: it bounds, but it is no place that counts.
  void add_node(std::size_t node) {
    if (surface_.is_empty(node)) return;
    const auto& box = surface_.box(node);
    const double reach = (box.high - box.low).norm() / 2;
    const double bound = coarse(reach) ? std::numeric_limits<double>::max() : measure((box.low + box.high) / 2, fineness_ - reach) + reach;
    if (bound > best_.distance + fineness_) open_.push({bound, node});
  }

  void search(const Corners& triangle) {
    const Vector3d middle = (triangle[0] + triangle[1] + triangle[2]) / 3;
    double reach = 0;
    double longest = 0;
    std::size_t first = 0;  // of the longest side
    for (std::size_t i = 0; i < 3; ++i) {
      reach = std::max(reach, (triangle[i] - middle).norm());
      const double length = (triangle[(i + 1) % 3] - triangle[i]).squaredNorm();
      if (length > longest) longest = length, first = i;
    }
    const double distance = ask(middle, more_for(reach));
    if (distance + reach <= best_.distance + fineness_) return;
    const Vector3d &a = triangle[first], &b = triangle[(first + 1) % 3], &c = triangle[(first + 2) % 3];
    const Vector3d half = (a + b) / 2;
    search({c, a, half});
    search({half, b, c});
  }

  const TriangleTree& surface_;
  const TriangleTree& other_;
  double fineness_;
  double slack_;             // what a place may be farther without being measured to the end
  std::vector<bool> asked_;  // of the mesh's vertices
  Farthest best_;            // exact
  std::priority_queue<Open> open_;
  std::uint32_t last_face_ = 0;
};

}  // namespace

Farthest farthest(const TriangleTree& surface, const TriangleTree& other, double fineness) {
  return Search(surface, other, fineness).run();
}

}  // namespace isotouch::evaluate
