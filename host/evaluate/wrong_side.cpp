#include "host/evaluate/wrong_side.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <vector>

#include "host/field/parallel.h"

namespace isotouch::evaluate {

using Eigen::Vector3d;

namespace {

struct Step {
  double x;
  int truth, surface;  // by how much the number of turns round a point changes here
};

/// Twice the area of the triangle that the line makes with an edge, in the plane across it. Both faces of an edge get the same number but for its
/// sign, because the corners enter in an order of their own; on the edge itself the line counts as left of the edge that runs upward. Zero only
/// where the line sees both ends as one point.
double side_of(const Vector3d& a, const Vector3d& b, double y, double z) {
  if (a.y() == b.y() && a.z() == b.z()) return 0;
  const bool turned = std::tuple(a.y(), a.z()) > std::tuple(b.y(), b.z());
  const Vector3d& p = turned ? b : a;
  const Vector3d& q = turned ? a : b;
  const double area = (q.y() - p.y()) * (z - p.z()) - (q.z() - p.z()) * (y - p.y());
  const double decided = area != 0 ? area : 1e-300;
  return turned ? -decided : decided;
}

void add_crossings(const field::TriangleTree& tree, double y, double z, bool is_truth, std::vector<Step>& steps) {
  const auto meets = [&](const field::TriangleTree::Box& box) {
    return box.low.y() <= y && y <= box.high.y() && box.low.z() <= z && z <= box.high.z();
  };
  tree.visit(meets, [&](std::uint32_t face) {
    const auto [a, b, c] = tree.corners(face);
    const double ab = side_of(a, b, y, z), bc = side_of(b, c, y, z), ca = side_of(c, a, y, z);
    const bool left = ab > 0 && bc > 0 && ca > 0;
    const bool right = ab < 0 && bc < 0 && ca < 0;
    if (!left && !right) return;
    const double x = (a.x() * bc + b.x() * ca + c.x() * ab) / (ab + bc + ca);
    const int turn = left ? -1 : 1;  // counter-clockwise in y, z: the face looks along x, so the line leaves
    steps.push_back({x, is_truth ? turn : 0, is_truth ? 0 : turn});
  });
}

}  // namespace

WrongSide wrong_side(const field::TriangleTree& surface, const field::TriangleTree& truth, double area_a_line) {
  const auto& a = surface.box(field::TriangleTree::root());
  const auto& b = truth.box(field::TriangleTree::root());
  const Vector3d low = a.low.cwiseMin(b.low);
  const Vector3d size = a.high.cwiseMax(b.high) - low;
  const double area = size.y() * size.z();
  const auto lines = std::max<std::size_t>(1, static_cast<std::size_t>(std::ceil(area / area_a_line)));

  struct Length {
    double too_much = 0, too_little = 0;
  };
  std::vector<Length> found(lines);
  field::in_parallel(lines, 256, [&](std::size_t begin, std::size_t end) {
    std::vector<Step> steps;
    for (std::size_t line = begin; line < end; ++line) {
      constexpr double kGolden = 0.61803398874989484820;
      const double place = static_cast<double>(line) + 0.5;
      const double y = low.y() + size.y() * (place * kGolden - std::floor(place * kGolden));
      const double z = low.z() + size.z() * place / static_cast<double>(lines);
      steps.clear();
      add_crossings(surface, y, z, false, steps);
      add_crossings(truth, y, z, true, steps);
      std::sort(steps.begin(), steps.end(),
                [](const Step& p, const Step& q) { return std::tuple(p.x, p.truth, p.surface) < std::tuple(q.x, q.truth, q.surface); });
      int in_surface = 0, in_truth = 0;
      for (std::size_t i = 0; i + 1 < steps.size(); ++i) {
        in_surface += steps[i].surface;
        in_truth += steps[i].truth;
        const double length = steps[i + 1].x - steps[i].x;
        if (in_surface > 0 && in_truth <= 0) found[line].too_much += length;
        if (in_surface <= 0 && in_truth > 0) found[line].too_little += length;
      }
    }
  });
  WrongSide sum;
  sum.lines = lines;
  const double share = area / static_cast<double>(lines);
  for (const Length& length : found) {
    sum.too_much += share * length.too_much;
    sum.volume += share * (length.too_much + length.too_little);
  }
  return sum;
}

}  // namespace isotouch::evaluate
