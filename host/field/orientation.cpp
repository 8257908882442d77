#include "host/field/orientation.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <numeric>
#include <tuple>

#include "host/field/nearest.h"
#include "host/field/parallel.h"
#include "host/field/quadric_fit.h"
#include "host/field/winding_sign.h"

namespace isotouch::field {

namespace {

using Eigen::Vector3d;

constexpr std::size_t kEstimated = 12;  // neighbours of an estimated normal
constexpr std::size_t kJoined = 11;     // a sample's list as far as it is asked for agreement, itself among them
constexpr double kClear = 0.5;          // of an agreement
constexpr double kDoubtful = 0.3;       // less than full agreement
constexpr std::int64_t kSure = 6;       // squared standard deviations of a vote by chance

/// For 98 directions the outermost sample is asked whether its normal points that way. On a closed surface it does, whatever the sampling, the cavities
/// or the holes elsewhere. An answer is near 1 or -1, and near 0 at the rim of an open scan, which so counts little.
double outwardness(const Scan& scan) {
  double agreed = 0.0, asked = 0.0;
  const auto ask = [&](double answer) {
    agreed += answer;
    asked += std::abs(answer);
  };
  for (const Vector3d& direction : half_directions()) {
    std::size_t first = 0, last = 0;
    double least = scan.positions()[0].dot(direction);
    double greatest = least;
    for (std::size_t i = 1; i < scan.size(); ++i) {
      const double reach = scan.positions()[i].dot(direction);
      if (reach > greatest) {
        greatest = reach;
        last = i;
      } else if (reach < least) {
        least = reach;
        first = i;
      }
    }
    ask(scan.normals()[last].dot(direction));
    ask(-scan.normals()[first].dot(direction));
  }
  return asked > 0.0 ? agreed / asked : 0.0;
}

/// An edge of the graph of neighbours.
struct Pair {
  double doubt;  ///< 0 to 1
  std::uint32_t a, b;
  bool opposed;  ///< the normals contradict each other as they stand
  bool operator<(const Pair& other) const { return std::tie(doubt, a, b) < std::tie(other.doubt, other.a, other.b); }
};

}  // namespace

std::vector<Vector3d> half_directions() {
  std::vector<Vector3d> all;
  for (int x = -2; x <= 2; ++x) {
    for (int y = -2; y <= 2; ++y) {
      for (int z = -2; z <= 2; ++z) {
        if (std::gcd(std::gcd(x, y), z) == 1 && std::tuple(x, y, z) > std::tuple(0, 0, 0)) all.push_back(Vector3d(x, y, z).normalized());
      }
    }
  }
  return all;
}

std::vector<Vector3d> estimated_normals(const std::vector<Vector3d>& points) {
  const Nearest tree(points);
  std::vector<Vector3d> normals(points.size());
  in_parallel(points.size(), 64, [&](std::size_t begin, std::size_t end) {
    std::vector<Neighbour> found;
    for (std::size_t i = begin; i < end; ++i) {
      tree.nearest(points[i], kEstimated, found);
      normals[i] = fit_quadric(points, found).normal;
    }
  });
  return normals;
}

double agreement(const Vector3d& normal, const Vector3d& other, const Vector3d& step) {
  const double square = step.squaredNorm();
  const double alike = normal.dot(other);
  return square > 0.0 ? alike - 2.0 * normal.dot(step) * other.dot(step) / square : alike;
}

double contradictions(const Scan& scan) {
  std::size_t clear = 0, opposed = 0;
  for (std::size_t i = 0; i < scan.size(); ++i) {
    const auto around = scan.around(i);
    for (const Neighbour& n : around.first(std::min(kJoined, around.size()))) {
      if (n.index == i) continue;
      const double agreed = agreement(scan.normals()[i], scan.normals()[n.index], scan.positions()[n.index] - scan.positions()[i]);
      clear += std::abs(agreed) > kClear ? 1U : 0U;
      opposed += agreed < -kClear ? 1U : 0U;
    }
  }
  return clear > 0 ? static_cast<double>(opposed) / static_cast<double>(clear) : 0.0;
}

std::size_t orient_by_neighbours(Scan& scan, bool heard) {
  std::vector<Pair> pairs;
  for (std::uint32_t i = 0; i < scan.size(); ++i) {
    const auto around = scan.around(i);
    for (const Neighbour& n : around.first(std::min(kJoined, around.size()))) {
      if (n.index == i) continue;
      const double agreed = agreement(scan.normals()[i], scan.normals()[n.index], scan.positions()[n.index] - scan.positions()[i]);
      pairs.push_back({1.0 - std::abs(agreed), std::min(i, n.index), std::max(i, n.index), agreed < 0.0});
    }
  }
  std::sort(pairs.begin(), pairs.end());
  // Union and find; each sample remembers whether it is to be turned when its root is not.
  std::vector<std::uint32_t> above(scan.size());
  std::iota(above.begin(), above.end(), 0U);
  std::vector<std::uint8_t> turned(scan.size(), 0);
  const auto root = [&](std::uint32_t i) {
    std::uint32_t top = i;
    std::uint8_t turn = 0;
    for (; above[top] != top; top = above[top]) turn ^= turned[top];
    for (std::uint32_t next = i; above[next] != top && next != top;) {
      const std::uint32_t up = above[next];
      const std::uint8_t own = turned[next];
      above[next] = top;
      turned[next] = turn;
      turn ^= own;
      next = up;
    }
    return top;
  };
  // Of the samples below a root: how many more keep their normal than turn it, when the root keeps its own.
  std::vector<std::int64_t> votes(scan.size(), 1), members(scan.size(), 1);
  const auto sure = [&](std::uint32_t i) { return votes[i] * votes[i] > kSure * members[i]; };
  for (const Pair& pair : pairs) {
    const std::uint32_t a = root(pair.a), b = root(pair.b);
    if (a == b) continue;
    const std::uint8_t of_a = pair.a == a ? 0 : turned[pair.a], of_b = pair.b == b ? 0 : turned[pair.b];
    bool turn = (of_a ^ of_b ^ (pair.opposed ? 1 : 0)) != 0;
    // Where neighbours hardly tell, two parts that each know their side by their own votes keep it.
    if (heard && pair.doubt > kDoubtful && sure(a) && sure(b)) turn = (votes[a] < 0) != (votes[b] < 0);
    above[b] = a;
    turned[b] = turn ? 1 : 0;
    votes[a] += turn ? -votes[b] : votes[b];
    members[a] += members[b];
  }
  std::vector<std::uint8_t> turn(scan.size());
  std::vector<std::uint32_t> roots(scan.size()), size(scan.size(), 0), turns(scan.size(), 0);
  for (std::uint32_t i = 0; i < scan.size(); ++i) {
    roots[i] = root(i);
    turn[i] = roots[i] == i ? 0 : turned[i];
    ++size[roots[i]];
    turns[roots[i]] += turn[i];
  }
  std::size_t count = 0;
  for (std::uint32_t i = 0; i < scan.size(); ++i) {
    const bool most = 2 * turns[roots[i]] > size[roots[i]];
    if ((turn[i] != 0) == most) continue;
    scan.turn_normal(i);
    ++count;
  }
  return count;
}

Facing facing(const Scan& scan) {
  const std::vector<double> areas = sample_areas(scan);
  double area = 0.0;
  Vector3d middle = Vector3d::Zero(), flux = Vector3d::Zero();
  for (std::size_t i = 0; i < scan.size(); ++i) {
    area += areas[i];
    middle += areas[i] * scan.positions()[i];
    flux += areas[i] * scan.normals()[i];
  }
  Facing result;
  if (!(area > 0.0)) return result;
  middle /= area;
  double volume = 0.0;
  for (std::size_t i = 0; i < scan.size(); ++i) volume += areas[i] * scan.normals()[i].dot(scan.positions()[i] - middle) / 3.0;
  result.enclosed = volume;
  const double radius = std::sqrt(area / (4.0 * std::numbers::pi));
  result.volume = volume / (area * radius / 3.0);
  result.one_sided = flux.norm() / area;
  if (result.one_sided > 0.0) result.front = flux.normalized();
  result.outward = outwardness(scan);
  return result;
}

}  // namespace isotouch::field
