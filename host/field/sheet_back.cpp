#include "host/field/sheet_back.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "host/field/behind_occlusions.h"
#include "host/field/default_grid.h"
#include "host/field/front_view.h"

namespace isotouch::field {

namespace {

using Eigen::Vector2d;
using Eigen::Vector2i;
using Eigen::Vector3d;

constexpr int kFilled = 2;         // cells: gaps up to twice as wide are filled
constexpr double kSideways = 0.5;  // length of a rim normal's part across the front, from which on the wall follows it
constexpr double kBeyond = 2.5;    // spacings from the last sample to a wall that does not follow it
constexpr int kMargin = kFilled + 2;
constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

/// A flag a cell of a picture seen from the front.
struct Mask {
  Vector2i size;
  std::vector<std::uint8_t> cells;

  explicit Mask(const Vector2i& extent)
      : size(extent), cells(static_cast<std::size_t>(extent.x()) * static_cast<std::size_t>(extent.y()), 0) {}
  std::size_t at(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(size.x()) + static_cast<std::size_t>(x);
  }
  bool holds(int x, int y) const { return x >= 0 && y >= 0 && x < size.x() && y < size.y() && cells[at(x, y)] != 0; }
};

/// Sets each cell that has one of `value` within `reach` cells, along the axes first and then across.
Mask spread(const Mask& mask, int reach, std::uint8_t value) {
  Mask result = mask;
  for (int step = 0; step < reach; ++step) {
    const Mask before = result;
    for (int y = 1; y + 1 < mask.size.y(); ++y) {
      for (int x = 1; x + 1 < mask.size.x(); ++x) {
        const auto beside = [&](int dx, int dy) { return before.cells[before.at(x + dx, y + dy)] == value; };
        bool any = beside(1, 0) || beside(-1, 0) || beside(0, 1) || beside(0, -1);
        if (step % 2 == 1) any = any || beside(1, 1) || beside(-1, 1) || beside(1, -1) || beside(-1, -1);
        if (any) result.cells[result.at(x, y)] = value;
      }
    }
  }
  return result;
}

/// Cells that hold samples.
Mask seen_cells(const Scan& scan, const FrontView& view) {
  Mask mask(view.size());
  for (const Vector3d& p : scan.positions()) {
    const Vector2i c = view.cell_of(p);
    mask.cells[mask.at(c.x(), c.y())] = 1;
  }
  return mask;
}

/// Fills the holes of the body whose rim looks to the front: nobody saw through them, they were missed.
void fill_missed(Mask& body, const Mask& seen, const std::vector<double>& facing) {
  std::vector<std::uint8_t> visited(body.cells.size(), 0);
  std::vector<Vector2i> front, hole;
  for (int y = 0; y < body.size.y(); ++y) {
    for (int x = 0; x < body.size.x(); ++x) {
      if (body.cells[body.at(x, y)] != 0 || visited[body.at(x, y)] != 0) continue;
      bool open = false;  // reaches the border of the picture
      double sum = 0.0;
      std::size_t count = 0;
      front.assign(1, {x, y});
      hole.clear();
      visited[body.at(x, y)] = 1;
      while (!front.empty()) {
        const Vector2i c = front.back();
        front.pop_back();
        hole.push_back(c);
        for (const Vector2i& way : {Vector2i(1, 0), Vector2i(-1, 0), Vector2i(0, 1), Vector2i(0, -1)}) {
          const Vector2i next = c + way;
          if ((next.array() < 0).any() || (next.array() >= body.size.array()).any()) {
            open = true;
            continue;
          }
          const std::size_t at = body.at(next.x(), next.y());
          if (body.cells[at] != 0) {
            if (seen.cells[at] != 0) {
              sum += facing[at];
              ++count;
            }
          } else if (visited[at] == 0) {
            visited[at] = 1;
            front.push_back(next);
          }
        }
      }
      if (open || count == 0 || sum < kSideways * static_cast<double>(count)) continue;
      for (const Vector2i& c : hole) body.cells[body.at(c.x(), c.y())] = 1;
    }
  }
}

}  // namespace

cloud::OrientedPoints sheet_back(const Scan& scan, const Vector3d& front) {
  const double spacing = scan.median_spacing() / 1.4;  // to the sixth neighbour it is that much farther than to the first
  const FrontView view(scan.positions(), front, spacing, kMargin);
  const Mask seen = seen_cells(scan, view);
  Mask body = spread(spread(seen, kFilled, 1), kFilled, 0);
  for (std::size_t c = 0; c < body.cells.size(); ++c) body.cells[c] |= seen.cells[c];

  double deepest = std::numeric_limits<double>::infinity();
  Vector3d low = scan.positions()[0], high = low;
  std::vector<double> facing(body.cells.size(), 0.0);
  std::vector<std::uint32_t> samples(body.cells.size(), 0);
  for (std::size_t i = 0; i < scan.size(); ++i) {
    const Vector3d& p = scan.positions()[i];
    deepest = std::min(deepest, front.dot(p));
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
    const Vector2i c = view.cell_of(p);
    facing[body.at(c.x(), c.y())] += scan.normals()[i].dot(front);
    ++samples[body.at(c.x(), c.y())];
  }
  for (std::size_t c = 0; c < facing.size(); ++c) facing[c] /= std::max(samples[c], 1U);
  fill_missed(body, seen, facing);
  const double back = deepest - kBackDepth * (high - low).maxCoeff();

  // Away from the body, from how much of it lies on each side of a cell.
  const auto outward = [&](int x, int y) {
    Vector2d way = Vector2d::Zero();
    for (int dy = -3; dy <= 3; ++dy) {
      for (int dx = -3; dx <= 3; ++dx) {
        if (body.holds(x + dx, y + dy) && dx * dx + dy * dy <= 10) way -= Vector2d(dx, dy);
      }
    }
    return way.norm() > 1e-9 ? Vector2d(way.normalized()) : Vector2d(0, 0);
  };

  // The outermost sample of every cell at the body's border carries a wall.
  std::vector<std::uint32_t> carrier(body.cells.size(), kNone);
  const auto at_border = [&](int x, int y) {
    return !(body.holds(x - 1, y) && body.holds(x + 1, y) && body.holds(x, y - 1) && body.holds(x, y + 1));
  };
  std::vector<double> farthest(body.cells.size(), 0.0);
  for (std::uint32_t i = 0; i < scan.size(); ++i) {
    const Vector2i c = view.cell_of(scan.positions()[i]);
    if (!at_border(c.x(), c.y())) continue;
    const std::size_t at = body.at(c.x(), c.y());
    const double reach = outward(c.x(), c.y()).dot(view.flat(scan.positions()[i]));
    if (carrier[at] != kNone && reach <= farthest[at]) continue;
    carrier[at] = i;
    farthest[at] = reach;
  }
  cloud::OrientedPoints invented;
  const auto add = [&](const Vector3d& position, const Vector3d& normal) {
    invented.positions.push_back(position);
    invented.normals.push_back(normal);
  };
  for (int y = 0; y < body.size.y(); ++y) {
    for (int x = 0; x < body.size.x(); ++x) {
      if (body.cells[body.at(x, y)] == 0) continue;
      if ((x + y) % 2 == 0 && !at_border(x, y)) add(view.solid(view.middle(x, y), back), -front);
      const std::uint32_t i = carrier[body.at(x, y)];
      if (i == kNone) continue;
      const Vector3d& p = scan.positions()[i];
      const Vector3d across = scan.normals()[i] - scan.normals()[i].dot(front) * front;
      const Vector2d away = outward(x, y);
      if (away.norm() < 0.5) continue;
      const bool follows = across.norm() > kSideways && view.flat(across).dot(away) > 0.0;
      const Vector3d normal = follows ? Vector3d(across.normalized()) : view.solid(away, 0.0);
      // First on as the sheet runs, so that what lies behind its last samples is inside.
      const Vector3d along = (normal - normal.dot(scan.normals()[i]) * scan.normals()[i]).normalized();
      for (const double beyond : {1.0, 2.0}) add(p + beyond * spacing * along, scan.normals()[i]);
      Vector3d end = p + kBeyond * spacing * along;
      // A sheet that rises there gets a roof, so that the wall does not cut off what is behind it.
      while (!follows && normal.dot(end - p) < (kBeyond - 0.5) * spacing) {
        end += spacing * normal;
        add(end - 0.5 * spacing * normal, front);
      }
      const Vector2d foot = view.flat(end);
      for (double height = front.dot(end) - spacing; height > back + 0.5 * spacing; height -= spacing)
        add(view.solid(foot, height), normal);
    }
  }
  invented.append(behind_occlusions(scan, view, spacing, (high - low).maxCoeff() / kCoarseGrid));
  if (!scan.stiffness().empty()) {
    const double softest = *std::min_element(scan.stiffness().begin(), scan.stiffness().end());
    invented.stiffness.assign(invented.size(), softest);
  }
  return invented;
}

}  // namespace isotouch::field
