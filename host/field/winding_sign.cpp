#include "host/field/winding_sign.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <numeric>
#include <span>

#include "host/field/parallel.h"

namespace isotouch::field {

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr std::size_t kHeard = 7;   // a sample and six neighbours say how far apart samples are
constexpr double kCell = 1.5;       // spacings: half the side of the square that a cell is cut from
constexpr double kBack = -0.5;      // cosine
constexpr double kBehind = 0.3;     // sine of the angle between the step and the tangent plane
constexpr std::uint32_t kLeaf = 6;  // samples
constexpr double kFarRadii = 1.6;
constexpr double kBend = 0.35;  // of the way to the nearest sample: how far a surface may bulge over a hole

/// A convex polygon round the origin that is cut smaller.
class Cell {
 public:
  explicit Cell(double half) : corners_{Vector2d(-half, -half), {half, -half}, {half, half}, {-half, half}}, count_(4) {}

  /// The squared distance of the farthest corner.
  double reach() const {
    double reach = 0.0;
    for (std::size_t n = 0; n < count_; ++n) reach = std::max(reach, corners_[n].squaredNorm());
    return reach;
  }

  /// Takes away what is nearer to q than to the origin.
  void cut(const Vector2d& q) {
    const double limit = 0.5 * q.squaredNorm();
    std::array<double, kMax> over{};
    bool any = false;
    for (std::size_t n = 0; n < count_; ++n) {
      over[n] = corners_[n].dot(q) - limit;
      any = any || over[n] > 0.0;
    }
    if (!any) return;
    std::array<Vector2d, kMax> kept;
    std::size_t count = 0;
    for (std::size_t n = 0; n < count_; ++n) {
      const std::size_t next = n + 1 == count_ ? 0 : n + 1;
      const Vector2d &a = corners_[n], &b = corners_[next];
      if (over[n] <= 0.0) kept[count++] = a;
      if ((over[n] <= 0.0) != (over[next] <= 0.0)) kept[count++] = a + over[n] / (over[n] - over[next]) * (b - a);
    }
    std::copy_n(kept.begin(), count, corners_.begin());
    count_ = count;
  }

  double area() const {
    double twice = 0.0;
    for (std::size_t n = 0; n < count_; ++n) {
      const Vector2d &a = corners_[n], &b = corners_[n + 1 == count_ ? 0 : n + 1];
      twice += a.x() * b.y() - a.y() * b.x();
    }
    return 0.5 * twice;
  }

 private:
  static constexpr std::size_t kMax = 4 + Scan::kListed + 2;  // each cut adds one corner at most
  std::array<Vector2d, kMax> corners_;
  std::size_t count_;
};

double cell_area(const Scan& scan, std::size_t i, const std::vector<double>& spacings) {
  const auto around = scan.around(i);
  // A stray sample far from the others does not stand for the emptiness round it: the neighbours' spacing counts.
  std::array<double, kHeard> near{};
  const std::size_t count = std::min(near.size(), around.size());
  for (std::size_t k = 0; k < count; ++k) near[k] = spacings[around[k].index];
  std::nth_element(near.begin(), near.begin() + static_cast<std::ptrdiff_t>(count / 2), near.begin() + static_cast<std::ptrdiff_t>(count));
  Cell cell(kCell * near[count / 2]);
  double reach = cell.reach();

  const Vector3d& n = scan.normals()[i];
  const Vector3d u = n.unitOrthogonal(), v = n.cross(u);
  for (const Neighbour& neighbour : around) {
    if (neighbour.index == i) continue;
    const Vector3d step = scan.positions()[neighbour.index] - scan.positions()[i];
    const double away = step.norm(), height = std::abs(n.dot(step));
    if (n.dot(scan.normals()[neighbour.index]) < kBack && height > kBehind * away)
      continue;  // the other side of a thin part has cells of its own
    Vector2d q(u.dot(step), v.dot(step));
    const double flat = q.norm();
    if (!(flat > 0.0)) continue;
    q *= away / flat;  // round an edge the way is longer than it seems from above
    if (away * away >= 4.0 * reach) continue;
    cell.cut(q);
    reach = cell.reach();
  }
  return cell.area();
}

}  // namespace

std::vector<double> sample_areas(const Scan& scan) {
  std::vector<double> spacings(scan.size()), areas(scan.size());
  for (std::size_t i = 0; i < scan.size(); ++i) spacings[i] = scan.spacing(i);
  in_parallel(scan.size(), 64, [&](std::size_t begin, std::size_t end) {
    for (const std::uint32_t i : scan.together(begin, end)) areas[i] = cell_area(scan, i, spacings);
  });
  return areas;
}

WindingSign::WindingSign(const Scan& scan, double noise, const Doubt& doubt) : noise_(noise), doubt_(doubt), areas_(sample_areas(scan)) {
  samples_.reserve(scan.size());
  for (std::size_t i = 0; i < scan.size(); ++i) samples_.push_back({scan.positions()[i], areas_[i] * scan.normals()[i]});
  nodes_.reserve(scan.size());
  add_node(0, static_cast<std::uint32_t>(scan.size()));
  softening_.reserve(samples_.size());
  for (const Dipole& sample : samples_) softening_.push_back(softening(sample.area.norm()));
}

void WindingSign::add_node(std::uint32_t first, std::uint32_t count) {
  const std::span<Dipole> samples = std::span(samples_).subspan(first, count);
  Dipole whole{Vector3d::Zero(), Vector3d::Zero()};
  Vector3d low = samples[0].centre, high = low;
  double weights = 0.0;
  for (const Dipole& sample : samples) {
    const double weight = sample.area.norm();
    whole.centre += weight * sample.centre;
    whole.area += sample.area;
    weights += weight;
    low = low.cwiseMin(sample.centre);
    high = high.cwiseMax(sample.centre);
  }
  whole.centre = weights > 0.0 ? Vector3d(whole.centre / weights) : Vector3d(0.5 * (low + high));
  const Vector3d reach = (high - whole.centre).cwiseMax(whole.centre - low);
  const std::size_t self = nodes_.size();
  nodes_.push_back({whole, kFarRadii * kFarRadii * reach.squaredNorm(), first, count <= kLeaf ? count : 0, 0});
  if (count > kLeaf) {
    Eigen::Index axis = 0;
    (high - low).maxCoeff(&axis);
    const std::uint32_t half = count / 2;
    const auto along = [axis](const Dipole& a, const Dipole& b) {
      for (Eigen::Index k = 0; k < 3; ++k) {
        const double x = a.centre[(axis + k) % 3], y = b.centre[(axis + k) % 3];
        if (x != y) return x < y;
      }
      return std::lexicographical_compare(a.area.begin(), a.area.end(), b.area.begin(), b.area.end());
    };
    std::nth_element(samples.begin(), samples.begin() + static_cast<std::ptrdiff_t>(half), samples.end(), along);
    add_node(first, half);
    add_node(first + half, count - half);
  }
  nodes_[self].next = static_cast<std::uint32_t>(nodes_.size());
}

double WindingSign::operator()(const Vector3d& place) const {
  double sum = 0.0;
  for (std::uint32_t n = 0; n < nodes_.size();) {
    const Node& node = nodes_[n];
    const Vector3d way = node.whole.centre - place;
    const double square = way.squaredNorm();
    if (square > node.far && node.count != 1) {
      sum += node.whole.area.dot(way) / (square * std::sqrt(square));
      n = node.next;
      continue;
    }
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
      const Vector3d to = samples_[i].centre - place;
      const double softened = to.squaredNorm() + softening_[i];
      if (softened > 0.0) sum += samples_[i].area.dot(to) / (softened * std::sqrt(softened));
    }
    ++n;
  }
  return sum / (4.0 * std::numbers::pi);
}

double signed_by_winding(double distance, const Vector3d& place, double nearest, double ninth, const WindingSign& enclosure) {
  if (!enclosure.in_doubt(nearest, ninth)) return distance;
  const double way = std::sqrt(nearest);
  const double guess = way * (1.0 - 2.0 * enclosure(place));
  const double slack = std::max(enclosure.doubt().beyond(ninth - nearest) / way, kBend * way);
  if (guess > slack) return std::max(distance, guess - slack);
  if (guess < -slack) return std::min(distance, guess + slack);
  return distance;
}

}  // namespace isotouch::field
