#include "host/field/bricks.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>
#include <utility>

#include "host/field/brick_mask.h"
#include "host/field/parallel.h"
#include "host/field/sample_masks.h"

namespace isotouch::field {

namespace {

using Eigen::Vector3d;
using Eigen::Vector3i;

/// Brick coordinates as one number that sorts by z, then y, then x.
using Key = std::uint64_t;

constexpr Key kSteps[3] = {1, Key{1} << 21, Key{1} << 42};

Key key_of(const Vector3i& cell) {
  return static_cast<Key>(cell.x()) * kSteps[0] + static_cast<Key>(cell.y()) * kSteps[1] + static_cast<Key>(cell.z()) * kSteps[2];
}

Vector3i cell_of(Key key) {
  constexpr Key kMask = kSteps[1] - 1;
  return {static_cast<int>(key & kMask), static_cast<int>(key >> 21 & kMask), static_cast<int>(key >> 42)};
}

Vector3d centre_of(const Vector3i& cell) { return 4.0 * cell.cast<double>() + Vector3d::Constant(1.5); }

/// From a brick's centre to its corner samples.
const double kReach = 1.5 * std::sqrt(3.0);

constexpr std::uint8_t kEveryWay = 0b111111;  // to all six neighbours

/// A brick that was looked at.
struct Visited {
  Key key;
  bool listed;
  BrickMask inside;  ///< where the samples are negative; all alike when it is not listed

  bool operator<(const Visited& o) const { return key < o.key; }
};

class Walk {
 public:
  Walk(const SampledDistance& distance, const Vector3i& cells, double band) : distance_(distance), cells_(cells), band_(band) {}

  void from(std::vector<Key> front) {
    while (!front.empty()) {
      std::sort(front.begin(), front.end());
      front.erase(std::unique(front.begin(), front.end()), front.end());
      std::vector<Key> unknown;
      auto known = visited_.begin();
      for (const Key key : front) {
        known = std::lower_bound(known, visited_.end(), Visited{key, false, 0});
        if (known == visited_.end() || known->key != key) unknown.push_back(key);
      }
      std::vector<Look>& looks = looks_.emplace_back(unknown.size());
      in_parallel(unknown.size(), 16, [&](std::size_t begin, std::size_t end) {
        for (std::size_t n = begin; n < end; ++n) looks[n] = look_at(unknown[n]);
      });
      std::vector<Visited> seen;
      front.clear();
      for (const Look& look : looks) {
        seen.push_back(look.visited);
        push_neighbours(look, front);
      }
      merge(seen);
    }
  }

  /// Lists bricks on both sides of every change of sign that the list does not hold yet; their neighbours are where the walk goes on.
  std::vector<Key> mend() {
    std::vector<Key> forced;
    for (std::size_t axis = 0; axis < 3; ++axis) check_faces(axis, forced);
    check_rows(forced);
    std::sort(forced.begin(), forced.end());
    forced.erase(std::unique(forced.begin(), forced.end()), forced.end());
    std::vector<Key> front;
    std::vector<Visited> seen;
    std::vector<Look>& looks = looks_.emplace_back();
    for (const Key key : forced) {
      const auto known = std::lower_bound(visited_.begin(), visited_.end(), Visited{key, false, 0});
      const Look look = listed(key, *distance_.brick(cell_of(key), std::numeric_limits<double>::infinity()).samples, true);
      looks.push_back(look);
      if (known != visited_.end() && known->key == key)
        *known = look.visited;
      else
        seen.push_back(look.visited);
      push_neighbours(look, front);
    }
    merge(seen);
    return front;
  }

  std::vector<Brick> bricks() const {
    std::vector<std::pair<Key, const Brick*>> order;
    order.reserve(visited_.size());
    for (const std::vector<Look>& looks : looks_) {
      for (const Look& look : looks) {
        if (look.visited.listed) order.emplace_back(look.visited.key, &look.brick);
      }
    }
    std::sort(order.begin(), order.end());
    std::vector<Brick> sorted;
    sorted.reserve(order.size());
    for (const auto& [key, brick] : order) sorted.push_back(*brick);
    return sorted;
  }

 private:
  struct Look {
    Visited visited;
    Brick brick;             ///< when it is listed
    std::uint8_t leads = 0;  ///< to which neighbours: bit 2 axis below, the next one above; none when it is not listed
  };

  Look look_at(Key key) const {
    const BrickDistances found = distance_.brick(cell_of(key), band_ + distance_.slope * kReach);
    if (!found.samples) return {{key, false, found.middle < 0.0 ? ~std::uint64_t{0} : 0}, {}};
    const auto& d = *found.samples;
    const auto [least, largest] = extremes(d);
    if (static_cast<double>(least) > band_) return {{key, false, 0}, {}};
    if (static_cast<double>(largest) < -band_) return {{key, false, ~std::uint64_t{0}}, {}};
    return listed(key, d, found.jumps);
  }

  Look listed(Key key, const BrickSamples& d, bool jumps) const {
    return {{key, true, inside_of(d)}, {cell_of(key), d}, jumps ? kEveryWay : leads(d)};
  }

  /// Which neighbours hold samples of the band, as far as the last two layers before them tell.
  std::uint8_t leads(const BrickSamples& distance) const {
    constexpr double kBend = 0.5;  // by how much a distance may leave its straight course from one sample to the next
    const auto near = static_cast<float>(band_ + kBend);
    const auto leads_near = [near](Four last, Four before) { return magnitude(2.0F * last - before) <= near; };
    const auto row = [&](std::size_t y, std::size_t z) { return load(&distance[16 * z + 4 * y]); };
    unsigned x = 0;  // the outer lanes tell
    auto y_below = Four{} > 0.0F, y_above = y_below, z_below = y_below, z_above = y_below;
    for (std::size_t n = 0; n < 4; ++n) {
      for (std::size_t m = 0; m < 4; ++m) {
        const Four along = row(n, m);
        x |= true_lanes(leads_near(along, Four{along[1], along[0], along[3], along[2]}));
      }
      y_below |= leads_near(row(0, n), row(1, n));
      y_above |= leads_near(row(3, n), row(2, n));
      z_below |= leads_near(row(n, 0), row(n, 1));
      z_above |= leads_near(row(n, 3), row(n, 2));
    }
    const unsigned y = (any(y_below) ? 1U : 0U) | (any(y_above) ? 2U : 0U);
    const unsigned z = (any(z_below) ? 1U : 0U) | (any(z_above) ? 2U : 0U);
    return static_cast<std::uint8_t>((x & 1U) | (x >> 2 & 2U) | y << 2 | z << 4);
  }

  void push_neighbours(const Look& look, std::vector<Key>& keys) const {
    const Key key = look.visited.key;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto along = static_cast<Eigen::Index>(axis);
      const unsigned ways = static_cast<unsigned>(look.leads) >> (2 * axis);
      if ((ways & 1U) != 0 && look.brick.cell[along] > 0) keys.push_back(key - kSteps[axis]);
      if ((ways & 2U) != 0 && look.brick.cell[along] + 1 < cells_[along]) keys.push_back(key + kSteps[axis]);
    }
  }

  void merge(const std::vector<Visited>& seen) {
    std::vector<Visited> all;
    all.reserve(visited_.size() + seen.size());
    std::merge(visited_.begin(), visited_.end(), seen.begin(), seen.end(), std::back_inserter(all));
    visited_.swap(all);
  }

  /// Neighbours that were both looked at must agree across their common face, unless both are listed.
  void check_faces(std::size_t axis, std::vector<Key>& forced) const {
    auto high = visited_.begin();
    for (const auto& low : visited_) {
      while (high != visited_.end() && high->key < low.key + kSteps[axis]) ++high;
      if (high == visited_.end()) break;
      if (high->key != low.key + kSteps[axis] || (low.listed && high->listed) || face(low.inside, axis, 1) == face(high->inside, axis, 0))
        continue;
      if (!low.listed) forced.push_back(low.key);
      if (!high->listed) forced.push_back(high->key);
    }
  }

  /// The sign must not change along the unknown bricks of a row; beyond its ends is outside.
  void check_rows(std::vector<Key>& forced) const {
    const auto width = static_cast<Key>(cells_.x());
    for (auto brick = visited_.begin(); brick != visited_.end();) {
      const Key row = brick->key >> 21 << 21;
      Key next = row;
      bool inside = false;
      for (; brick != visited_.end() && brick->key < row + kSteps[1]; ++brick) {
        find_change(next, brick->key, inside, face(brick->inside, 0, 0) != 0, forced);
        next = brick->key + 1;
        inside = face(brick->inside, 0, 1) != 0;
      }
      find_change(next, row + width, inside, false, forced);
    }
  }

  /// [first, last): unknown bricks of a row; `left` and `right`: are the bricks beside them inside?
  void find_change(Key first, Key last, bool left, bool right, std::vector<Key>& forced) const {
    if (first == last || left == right) return;
    Key change = first;
    while (change < last && (distance_.at(centre_of(cell_of(change))) < 0.0) == left) ++change;
    if (change < last) forced.push_back(change);
    if (change > first) forced.push_back(change - 1);
  }

  const SampledDistance& distance_;
  Vector3i cells_;
  double band_;
  std::vector<Visited> visited_;  ///< sorted by key
  /// A brick stays where it was found until all are: one list that grows would copy them again and again.
  std::vector<std::vector<Look>> looks_;
};

}  // namespace

std::vector<Brick> band_bricks(const SampledDistance& distance, const Vector3i& cells, double band, const std::vector<Vector3i>& seeds) {
  std::vector<Key> front;
  for (const auto& seed : seeds) {
    if ((seed.array() >= 0).all() && (seed.array() < cells.array()).all()) front.push_back(key_of(seed));
  }
  Walk walk(distance, cells, band);
  do {
    walk.from(front);
    front = walk.mend();
  } while (!front.empty());
  return walk.bricks();
}

}  // namespace isotouch::field
