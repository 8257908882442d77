#include "host/evaluate/wrong_side.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <vector>

#include "host/field/line_crossings.h"
#include "host/field/parallel.h"

namespace isotouch::evaluate {

using Eigen::Vector3d;

namespace {

struct Step {
  double x;
  int truth, surface;  // by how much the number of turns round a point changes here
};

}  // namespace

WrongSide wrong_side(const field::TriangleTree& surface, const field::TriangleTree& truth, double area_a_line) {
  const auto& a = surface.box(field::TriangleTree::root());
  const auto& b = truth.box(field::TriangleTree::root());
  const Vector3d low = a.low.cwiseMin(b.low);
  const Vector3d size = a.high.cwiseMax(b.high) - low;
  const double area = size.y() * size.z();
  const auto lines = std::max<std::size_t>(1, static_cast<std::size_t>(std::ceil(area / area_a_line)));

  struct Length {
    double too_much = 0, too_little = 0, truth = 0;
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
      field::each_crossing(surface, y, z, [&](double x, int turn) { steps.push_back({x, 0, turn}); });
      field::each_crossing(truth, y, z, [&](double x, int turn) { steps.push_back({x, turn, 0}); });
      std::sort(steps.begin(), steps.end(),
                [](const Step& p, const Step& q) { return std::tuple(p.x, p.truth, p.surface) < std::tuple(q.x, q.truth, q.surface); });
      int in_surface = 0, in_truth = 0;
      for (std::size_t i = 0; i + 1 < steps.size(); ++i) {
        in_surface += steps[i].surface;
        in_truth += steps[i].truth;
        const double length = steps[i + 1].x - steps[i].x;
        if (in_surface > 0 && in_truth <= 0) found[line].too_much += length;
        if (in_truth > 0) found[line].truth += length;
        if (in_surface <= 0 && in_truth > 0) found[line].too_little += length;
      }
    }
  });
  WrongSide sum;
  sum.lines = lines;
  const double share = area / static_cast<double>(lines);
  for (const Length& length : found) {
    sum.too_much += share * length.too_much;
    sum.truth += share * length.truth;
    sum.volume += share * (length.too_much + length.too_little);
  }
  return sum;
}

}  // namespace isotouch::evaluate
