#include "host/field/orientation.h"

#include <algorithm>
#include <array>
#include <atomic>
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
constexpr double kFewestWrong = 0.001;  // share of signs
constexpr int kPasses = 8;
constexpr double kLeastGain = 1e-9;  // more than rounding
constexpr double kVote = 0.25;       // of a normal's log-odds to be right, beside a full agreement of neighbours

/// For 98 directions the outermost sample is asked whether its normal points that way. On a closed surface it does, whatever the sampling, the cavities
/// or the holes elsewhere. An answer is near 1 or -1, and near 0 at the rim of an open scan, which so counts little.
double outwardness(const Scan& scan) {
  const std::vector<Vector3d> directions = half_directions();
  std::vector<std::array<double, 2>> answers(directions.size());
  in_parallel(directions.size(), 16, [&](std::size_t begin, std::size_t end) {
    for (std::size_t d = begin; d < end; ++d) {
      const Vector3d& direction = directions[d];
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
      answers[d] = {scan.normals()[last].dot(direction), -scan.normals()[first].dot(direction)};
    }
  });
  double agreed = 0.0, asked = 0.0;
  for (const auto& both : answers) {
    for (const double answer : both) {
      agreed += answer;
      asked += std::abs(answer);
    }
  }
  return asked > 0.0 ? agreed / asked : 0.0;
}

/// An edge of the graph of neighbours.
struct Pair {
  std::uint32_t a, b;
  double agreed;  ///< squared, with its sign: agreements near 0 are chance
};

/// Each once, ascending.
std::vector<Pair> pairs_of_neighbours(const Scan& scan) {
  std::vector<Pair> pairs;
  for (std::uint32_t i = 0; i < scan.size(); ++i) {
    for (const Neighbour& n : scan.around(i, kJoined)) {
      if (n.index == i) continue;
      const std::uint32_t a = std::min(i, n.index), b = std::max(i, n.index);
      const double agreed = agreement(scan.normals()[a], scan.normals()[b], scan.positions()[b] - scan.positions()[a]);
      pairs.push_back({a, b, agreed * std::abs(agreed)});
    }
  }
  const auto place = [](const Pair& pair) { return std::tie(pair.a, pair.b); };
  std::sort(pairs.begin(), pairs.end(), [&](const Pair& p, const Pair& q) { return place(p) < place(q); });
  pairs.erase(std::unique(pairs.begin(), pairs.end(), [&](const Pair& p, const Pair& q) { return place(p) == place(q); }), pairs.end());
  return pairs;
}

/// The signs of all normals, and how well they suit neighbours and votes.
class Signs {
 public:
  /// vote      what a sample counts that keeps its sign, beside a full agreement of two neighbours
  Signs(const Scan& scan, double vote) : pairs_(pairs_of_neighbours(scan)), vote_(vote), sign_(scan.size(), 1) {
    first_.assign(scan.size() + 1, 0);
    for (const Pair& pair : pairs_) {
      ++first_[pair.a + 1];
      ++first_[pair.b + 1];
    }
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
    beside_.resize(2 * pairs_.size());
    std::vector<std::uint32_t> filled(first_.begin(), first_.end() - 1);
    for (std::uint32_t p = 0; p < pairs_.size(); ++p) beside_[filled[pairs_[p].a]++] = beside_[filled[pairs_[p].b]++] = p;
    order_.resize(pairs_.size());
    std::iota(order_.begin(), order_.end(), 0U);
    std::stable_sort(order_.begin(), order_.end(),
                     [&](std::uint32_t p, std::uint32_t q) { return std::abs(pairs_[p].agreed) > std::abs(pairs_[q].agreed); });
  }

  /// Joins samples in the order of their clearest agreements. Two parts that meet are turned against each other as all pairs between them and their
  /// votes ask for.
  void grow() {
    join([&](Part& to, Part& from, double between) {
      const double votes = 0.5 * static_cast<double>(std::abs(to.votes + from.votes) - std::abs(to.votes - from.votes));
      if (between + vote_ * votes < 0.0) turn(from);
    });
  }

  /// Joins them again, and turns each part that all its neighbours as they stand ask to turn. Returns whether it turned any.
  bool improve() {
    bool any = false;
    join([&](Part& to, Part& from, double) {
      for (Part* part : {&to, &from}) {
        if (suits(*part) >= -kLeastGain) continue;
        turn(*part);
        any = true;
      }
    });
    return any;
  }

  bool turned(std::size_t sample) const { return sign_[sample] < 0; }

 private:
  /// Samples that were joined.
  struct Part {
    std::vector<std::uint32_t> members;
    std::int64_t votes = 0;  ///< how many more of them keep their sign than turn it
    double cut = 0;          ///< agreement with all samples that are not of the part
  };

  double suits(const Part& part) const { return part.cut + vote_ * static_cast<double>(part.votes); }

  void turn(Part& part) {
    for (const std::uint32_t i : part.members) sign_[i] = static_cast<std::int8_t>(-sign_[i]);
    part.votes = -part.votes;
    part.cut = -part.cut;
    for (const std::uint32_t i : part.members) {
      for (std::uint32_t at = first_[i]; at < first_[i + 1]; ++at) {
        const Pair& pair = pairs_[beside_[at]];
        const std::uint32_t other = part_of_[pair.a == i ? pair.b : pair.a];
        if (other != part_of_[i]) parts_[other].cut += 2.0 * agreed(pair);
      }
    }
  }

  double agreed(const Pair& pair) const { return pair.agreed * sign_[pair.a] * sign_[pair.b]; }

  template <typename Decide>
  void join(const Decide& decide) {
    parts_.assign(sign_.size(), {});
    part_of_.resize(sign_.size());
    for (std::uint32_t i = 0; i < sign_.size(); ++i) {
      parts_[i].members = {i};
      parts_[i].votes = sign_[i];
      part_of_[i] = i;
    }
    for (const Pair& pair : pairs_) {
      parts_[pair.a].cut += agreed(pair);
      parts_[pair.b].cut += agreed(pair);
    }
    const auto between = [&](const Part& from, std::uint32_t to) {
      double sum = 0.0;
      for (const std::uint32_t i : from.members) {
        for (std::uint32_t at = first_[i]; at < first_[i + 1]; ++at) {
          const Pair& pair = pairs_[beside_[at]];
          if (part_of_[pair.a == i ? pair.b : pair.a] == to) sum += agreed(pair);
        }
      }
      return sum;
    };
    for (const std::uint32_t p : order_) {
      std::uint32_t large = part_of_[pairs_[p].a], small = part_of_[pairs_[p].b];
      if (large == small) continue;
      if (parts_[large].members.size() < parts_[small].members.size()) std::swap(large, small);
      Part &to = parts_[large], &from = parts_[small];
      decide(to, from, between(from, large));
      to.cut += from.cut - 2.0 * between(from, large);
      to.votes += from.votes;
      for (const std::uint32_t i : from.members) part_of_[i] = large;
      to.members.insert(to.members.end(), from.members.begin(), from.members.end());
      from = {};
    }
    for (Part& part : parts_) {
      if (part.votes < 0) turn(part);
    }
  }

  std::vector<Pair> pairs_;  ///< by their samples
  double vote_;
  std::vector<std::uint32_t> order_;           ///< the pairs, clearest first
  std::vector<std::uint32_t> first_, beside_;  ///< of each sample, its pairs
  std::vector<std::int8_t> sign_;              ///< -1: turned
  std::vector<Part> parts_;
  std::vector<std::uint32_t> part_of_;
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

namespace {

/// What the clear pairs of neighbours say; each pair is asked from both ends.
struct ClearPairs {
  std::int64_t clear = 0, opposed = 0;
  std::int64_t behind = 0;  ///< of the opposed: how many more lie behind each other than before each other

  double share(std::int64_t count) const { return clear > 0 ? static_cast<double>(count) / static_cast<double>(clear) : 0.0; }
};

ClearPairs clear_pairs(const Scan& scan) {
  std::atomic<std::int64_t> clear{0}, opposed{0}, behind{0};
  in_parallel(scan.size(), 256, [&](std::size_t begin, std::size_t end) {
    ClearPairs here;
    for (const std::uint32_t i : scan.together(begin, end)) {
      for (const Neighbour& n : scan.around(i, kJoined)) {
        if (n.index == i) continue;
        const Vector3d &own = scan.normals()[i], &other = scan.normals()[n.index];
        const Vector3d step = scan.positions()[n.index] - scan.positions()[i];
        const double agreed = agreement(own, other, step);
        here.clear += std::abs(agreed) > kClear ? 1 : 0;
        if (agreed >= -kClear) continue;
        ++here.opposed;
        const double ahead = own.dot(step), back = -other.dot(step);
        here.behind += ahead < 0.0 && back < 0.0 ? 1 : ahead > 0.0 && back > 0.0 ? -1 : 0;
      }
    }
    clear += here.clear;
    opposed += here.opposed;
    behind += here.behind;
  });
  return {clear, opposed, behind};
}

}  // namespace

double contradictions(const Scan& scan) {
  const ClearPairs pairs = clear_pairs(scan);
  return pairs.share(pairs.opposed);
}

double behind_each_other(const Scan& scan) {
  const ClearPairs pairs = clear_pairs(scan);
  return pairs.share(pairs.behind);
}

std::size_t orient_by_neighbours(Scan& scan, bool heard) {
  // Where a share w of the signs is wrong by chance, 2 w (1 - w) of the pairs contradict each other.
  const double opposed = std::min(0.5, contradictions(scan));
  const double wrong = std::max(0.5 * (1.0 - std::sqrt(1.0 - 2.0 * opposed)), kFewestWrong);
  Signs signs(scan, heard ? kVote * std::log((1.0 - wrong) / wrong) : 0.0);
  signs.grow();
  for (int pass = 0; pass < kPasses && signs.improve(); ++pass) {
  }
  std::size_t turned = 0;
  for (std::size_t i = 0; i < scan.size(); ++i) {
    if (!signs.turned(i)) continue;
    scan.turn_normal(i);
    ++turned;
  }
  return turned;
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
  result.area = area;
  result.enclosed = volume;
  const double radius = std::sqrt(area / (4.0 * std::numbers::pi));
  result.volume = volume / (area * radius / 3.0);
  result.one_sided = flux.norm() / area;
  if (result.one_sided > 0.0) result.front = flux.normalized();
  result.outward = outwardness(scan);
  return result;
}

}  // namespace isotouch::field
