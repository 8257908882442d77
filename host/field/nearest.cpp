#include "host/field/nearest.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <limits>
#include <numeric>
#include <span>
#include <utility>

#include "host/field/simd.h"

namespace isotouch::field {

namespace {

using Eigen::Vector3d;

constexpr std::size_t kLeaf = 8;
constexpr std::size_t kMaxDepth = 32;  // of 2^32 positions

/// Two numbers at once.
using Two = double __attribute__((vector_size(16)));

Two larger(Two a, Two b) {
#ifdef __SSE2__
  return __builtin_ia32_maxpd(a, b);
#else
  return a > b ? a : b;
#endif
}

/// The boxes of two nodes that hang together.
struct Boxes {
  std::array<Two, 3> low, high;

  /// At most the squared distances of every position in each, also as these are rounded: each step rounds larger numbers to larger ones.
  Two away(const std::array<Two, 3>& point) const {
    const auto beyond = [&](std::size_t axis) { return larger(larger(low[axis] - point[axis], point[axis] - high[axis]), Two{}); };
    const Two x = beyond(0), y = beyond(1), z = beyond(2);
    return (x * x + y * y) + z * z;
  }
};

/// Positions beside each other in memory; places that are left over are no numbers, and so are distances to them.
struct Leaf {
  std::array<Two, kLeaf / 2> x, y, z;
  std::array<std::uint32_t, kLeaf> index;
};

struct Box {
  Vector3d low, high;
};

/// Keeps the smallest, ascending, in as many places as it is given.
class NearestFew {
 public:
  explicit NearestFew(std::vector<Neighbour>& found) : found_(found.data()), capacity_(found.size()) {}
  double worst() const { return size_ == capacity_ ? found_[size_ - 1].squared_distance : std::numeric_limits<double>::max(); }
  void add(const Neighbour& candidate) {
    if (size_ < capacity_)
      ++size_;
    else if (!(candidate < found_[size_ - 1]))
      return;
    std::size_t place = size_ - 1;
    for (; place > 0 && candidate < found_[place - 1]; --place) found_[place] = found_[place - 1];
    found_[place] = candidate;
  }

 private:
  Neighbour* found_;
  std::size_t capacity_, size_ = 0;
};

/// Neighbours at the beginning of room that grows.
struct Found {
  std::vector<Neighbour>& room;
  std::size_t size = 0;

  /// Of a whole leaf, for a processor cannot foretell which of its positions are near: each is written, and stays where it is.
  void add_within(double square, const std::array<double, kLeaf>& away, const std::array<std::uint32_t, kLeaf>& index) {
    if (room.size() < size + kLeaf) room.resize(2 * room.size() + kLeaf);
    for (std::size_t n = 0; n < kLeaf; ++n) {
      room[size] = {away[n], index[n]};
      size += away[n] <= square ? 1U : 0U;
    }
  }
};

class Within {
 public:
  Within(double radius, std::vector<Neighbour>& room) : squared_radius_(radius * radius), found_{room} {}
  double worst() const { return squared_radius_; }
  std::size_t size() const { return found_.size; }

  void add(const std::array<double, kLeaf>& away, const std::array<std::uint32_t, kLeaf>& index) {
    found_.add_within(squared_radius_, away, index);
  }

 private:
  double squared_radius_;
  Found found_;
};

/// Keeps what is at most `margin` farther away than the `count` nearest, as far as these are known, and some more.
class NearestAndBeyond {
 public:
  NearestAndBeyond(std::size_t count, double margin, std::vector<Neighbour>& room) : count_(count), margin_(margin), found_{room} {
    nearest_.fill(std::numeric_limits<double>::max());
  }
  double worst() const { return worst_; }
  std::size_t size() const { return found_.size; }

  void add(const std::array<double, kLeaf>& away, const std::array<std::uint32_t, kLeaf>& index) {
    found_.add_within(worst_, away, index);
    bool nearer = false;
    for (const double square : away) {
      if (!(square < nearest_[count_ - 1])) continue;
      double larger = square;  // no place is asked for: a processor cannot foretell it
      for (std::size_t place = 0; place < count_; ++place) {
        const double here = nearest_[place];
        nearest_[place] = std::min(larger, here);
        larger = std::max(larger, here);
      }
      nearer = true;
    }
    if (!nearer || found_.size < count_) return;
    const double radius = std::sqrt(nearest_[count_ - 1]) + margin_;
    worst_ = radius * radius;
  }

 private:
  std::size_t count_;
  double margin_, worst_ = std::numeric_limits<double>::max();
  std::array<double, Nearest::kMaxWithBeyond> nearest_{};  ///< squared distances, ascending
  Found found_;
};

/// Sorts some tens by counting how many are nearer than each: more comparisons, but hardly any that a processor has to foretell. They are compared as
/// floats, four at once; what seems equal then is put in order at the end.
void sort_few(std::span<const Neighbour> items, std::vector<Neighbour>& sorted) {
  constexpr std::size_t kFew = 80;
  if (items.size() > kFew) {
    sorted.assign(items.begin(), items.end());
    std::sort(sorted.begin(), sorted.end());
    return;
  }
  constexpr double kFree = -1.0;
  sorted.assign(items.size(), {kFree, 0});
  std::array<float, kFew + 3> squares;
  for (std::size_t i = 0; i < items.size(); ++i) squares[i] = static_cast<float>(items[i].squared_distance);
  std::fill_n(&squares[items.size()], 3, std::numeric_limits<float>::max());
  for (std::size_t i = 0; i < items.size(); ++i) {
    decltype(Four{} < Four{}) nearer{};
    for (std::size_t four = 0; four < items.size(); four += 4) nearer += load(&squares[four]) < squares[i];  // a true comparison is -1
    auto place = static_cast<std::size_t>(-(nearer[0] + nearer[1] + nearer[2] + nearer[3]));
    while (sorted[place].squared_distance != kFree) ++place;  // of equally near ones
    sorted[place] = items[i];
  }
  for (std::size_t n = 1; n < sorted.size(); ++n) {
    for (std::size_t place = n; place > 0 && sorted[place] < sorted[place - 1]; --place) std::swap(sorted[place], sorted[place - 1]);
  }
}

}  // namespace

/// A complete binary tree: node n has the children 2n and 2n + 1, node 1 is the root, and the last half of the nodes are leaves.
class Nearest::Tree {
 public:
  explicit Tree(const std::vector<Vector3d>& positions) {
    std::size_t leaves = 1;
    while (leaves * kLeaf < positions.size()) leaves *= 2;
    children_.resize(leaves);
    leaves_.resize(leaves);
    order_.resize(positions.size());
    std::iota(order_.begin(), order_.end(), 0U);
    build(1, positions, order_.data(), order_.data() + order_.size());
  }

  const std::vector<std::uint32_t>& order() const { return order_; }

  template <class Result>
  void search(const Vector3d& point, Result& result) const {
    struct Later {
      std::size_t node;
      double away;
    };
    std::array<Later, kMaxDepth> later;
    std::size_t waiting = 0;
    const std::array<Two, 3> twice = {Two{} + point.x(), Two{} + point.y(), Two{} + point.z()};
    for (std::size_t node = 1;;) {
      while (node < leaves_.size()) {
        const Two away = children_[node].away(twice);
        const std::size_t near = away[1] < away[0] ? 1 : 0;
        const double far = near == 1 ? away[0] : away[1];
        later[waiting] = {2 * node + 1 - near, far};
        waiting += far <= result.worst() ? 1U : 0U;
        node = 2 * node + near;
      }
      add(leaves_[node - leaves_.size()], twice, result);
      do {
        if (waiting == 0) return;
        --waiting;
      } while (later[waiting].away > result.worst());
      node = later[waiting].node;
    }
  }

 private:
  template <class Result>
  static void add(const Leaf& leaf, const std::array<Two, 3>& point, Result& result) {
    std::array<double, kLeaf> away;
    for (std::size_t n = 0; n < kLeaf; n += 2) {
      const Two x = leaf.x[n / 2] - point[0], y = leaf.y[n / 2] - point[1], z = leaf.z[n / 2] - point[2];
      const Two square = (x * x + y * y) + z * z;
      std::memcpy(&away[n], &square, sizeof square);
    }
    if constexpr (requires { result.add(away, leaf.index); }) {
      result.add(away, leaf.index);
    } else {
      for (std::size_t n = 0; n < kLeaf; ++n) {
        if (away[n] <= result.worst()) result.add({away[n], leaf.index[n]});
      }
    }
  }

  /// Of the positions from `first` on, returns their box.
  Box build(std::size_t node, const std::vector<Vector3d>& positions, std::uint32_t* first, std::uint32_t* last) {
    Box box{positions[*first], positions[*first]};
    for (const std::uint32_t* i = first; i != last; ++i) {
      box.low = box.low.cwiseMin(positions[*i]);
      box.high = box.high.cwiseMax(positions[*i]);
    }
    if (node >= leaves_.size()) {
      fill(leaves_[node - leaves_.size()], positions, {first, last});
      return box;
    }
    Eigen::Index axis = 0;
    (box.high - box.low).maxCoeff(&axis);
    std::uint32_t* const middle = first + (last - first + 1) / 2;
    std::nth_element(first, middle, last, [&](std::uint32_t a, std::uint32_t b) { return positions[a][axis] < positions[b][axis]; });
    const std::array<Box, 2> halves = {build(2 * node, positions, first, middle), build(2 * node + 1, positions, middle, last)};
    for (std::size_t a = 0; a < 3; ++a) {
      const auto along = static_cast<Eigen::Index>(a);
      children_[node].low[a] = Two{halves[0].low[along], halves[1].low[along]};
      children_[node].high[a] = Two{halves[0].high[along], halves[1].high[along]};
    }
    return box;
  }

  static void fill(Leaf& leaf, const std::vector<Vector3d>& positions, std::span<const std::uint32_t> indices) {
    leaf.x.fill(Two{} + std::numeric_limits<double>::quiet_NaN());
    for (std::size_t n = 0; n < indices.size(); ++n) {
      const Vector3d& position = positions[indices[n]];
      leaf.x[n / 2][n % 2] = position.x();
      leaf.y[n / 2][n % 2] = position.y();
      leaf.z[n / 2][n % 2] = position.z();
      leaf.index[n] = indices[n];
    }
  }

  std::vector<Boxes> children_;  ///< of each node that is no leaf
  std::vector<Leaf> leaves_;
  std::vector<std::uint32_t> order_;
};

Nearest::Nearest(const std::vector<Vector3d>& positions) : tree_(std::make_unique<Tree>(positions)), size_(positions.size()) {}
Nearest::~Nearest() = default;

const std::vector<std::uint32_t>& Nearest::order() const { return tree_->order(); }

void Nearest::nearest(const Vector3d& point, std::size_t count, std::vector<Neighbour>& found) const {
  found.resize(std::min(count, size_));
  if (found.empty()) return;
  NearestFew result(found);
  tree_->search(point, result);
}

void Nearest::nearest_and_beyond(const Vector3d& point, std::size_t count, double margin, std::vector<Neighbour>& found) const {
  assert(count > 0 && count <= kMaxWithBeyond);
  thread_local std::vector<Neighbour> reached;  // keeps its memory
  NearestAndBeyond result(std::min(count, size_), margin, reached);
  tree_->search(point, result);
  const auto end = std::remove_if(reached.begin(), reached.begin() + static_cast<std::ptrdiff_t>(result.size()),
                                  [&](const Neighbour& n) { return n.squared_distance > result.worst(); });
  sort_few({reached.begin(), end}, found);
}

void Nearest::within(const Vector3d& point, double radius, std::vector<Neighbour>& found) const {
  within_in_any_order(point, radius, found);
  std::sort(found.begin(), found.end());
}

void Nearest::within_in_any_order(const Vector3d& point, double radius, std::vector<Neighbour>& found) const {
  Within result(radius, found);
  tree_->search(point, result);
  found.resize(result.size());
}

}  // namespace isotouch::field
