#include "host/field/debris.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <tuple>

namespace isotouch::field {

namespace {

constexpr std::size_t kFewest = 4;  // points that a piece stands on
constexpr float kClear = 1.0F;      // voxels: what is left of a dropped piece, and
constexpr float kBeside = 0.5F;     // of what lay beside it, is no surface, and none for a spline that swings below its samples
constexpr std::uint32_t kNone = 0xFFFFFFFF;
constexpr std::array<std::size_t, 3> kStep = {1, 4, 16};

auto place(const Eigen::Vector3i& cell) { return std::tuple(cell.z(), cell.y(), cell.x()); }

/// Of every brick the one that follows it along each axis.
std::vector<std::array<std::uint32_t, 3>> followers(const std::vector<Brick>& bricks) {
  std::vector<std::array<std::uint32_t, 3>> next(bricks.size(), {kNone, kNone, kNone});
  for (int axis = 0; axis < 3; ++axis) {
    std::size_t ahead = 0;
    for (std::size_t b = 0; b < bricks.size(); ++b) {
      const Eigen::Vector3i wanted = bricks[b].cell + Eigen::Vector3i::Unit(axis);
      while (ahead < bricks.size() && place(bricks[ahead].cell) < place(wanted)) ++ahead;
      if (ahead < bricks.size() && bricks[ahead].cell == wanted)
        next[b][static_cast<std::size_t>(axis)] = static_cast<std::uint32_t>(ahead);
    }
  }
  return next;
}

/// Calls pair(a, b) for samples 64 * brick + place that lie face to face, a before b, and end(a) for one with nothing listed beside it.
template <class Pair, class End>
void walk_faces(const std::vector<Brick>& bricks, const Pair& pair, const End& end) {
  const auto next = followers(bricks);
  std::vector<std::array<bool, 3>> has_before(bricks.size(), {false, false, false});
  for (std::size_t b = 0; b < bricks.size(); ++b) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (next[b][axis] != kNone) has_before[next[b][axis]][axis] = true;
    }
  }
  for (std::size_t b = 0; b < bricks.size(); ++b) {
    for (std::size_t s = 0; s < 64; ++s) {
      const std::size_t a = 64 * b + s;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::size_t along = s / kStep[axis] % 4;
        if (along == 0 && !has_before[b][axis]) end(a);
        if (along < 3) {
          pair(a, a + kStep[axis]);
        } else if (next[b][axis] == kNone) {
          end(a);
        } else {
          pair(a, 64 * std::size_t{next[b][axis]} + s - 3 * kStep[axis]);
        }
      }
    }
  }
}

float& value(std::vector<Brick>& bricks, std::size_t sample) { return bricks[sample / 64].distance[sample % 64]; }

/// Sets of samples of one sign; two more for what lies beyond the listed bricks, inside and outside.
class Pieces {
 public:
  explicit Pieces(const std::vector<Brick>& bricks) : parent_(64 * bricks.size() + 2) {
    for (std::size_t n = 0; n < parent_.size(); ++n) parent_[n] = static_cast<std::uint32_t>(n);
    const auto inside = [&](std::size_t sample) { return bricks[sample / 64].distance[sample % 64] < 0.0F; };
    walk_faces(
        bricks,
        [&](std::size_t a, std::size_t b) {
          if (inside(a) == inside(b)) join(a, b);
        },
        [&](std::size_t a) { join(a, beyond(inside(a))); });
  }

  std::size_t of(std::size_t sample) {
    auto n = static_cast<std::uint32_t>(sample);
    while (parent_[n] != n) n = parent_[n] = parent_[parent_[n]];
    return n;
  }
  std::size_t beyond(bool inside) const { return parent_.size() - (inside ? 1 : 2); }
  std::size_t count() const { return parent_.size(); }

 private:
  void join(std::size_t a, std::size_t b) {
    const std::size_t first = of(a), second = of(b);
    parent_[std::min(first, second)] = static_cast<std::uint32_t>(std::max(first, second));  // the last ones, beyond, stay roots
  }
  std::vector<std::uint32_t> parent_;
};

/// How many points lie in a cell of eight samples that belongs to each piece.
std::vector<std::uint32_t> support(const std::vector<Brick>& bricks, Pieces& pieces, const std::vector<Eigen::Vector3d>& points) {
  std::vector<std::uint32_t> voices(pieces.count(), 0);
  for (const Eigen::Vector3d& point : points) {
    const Eigen::Vector3i low = point.array().floor().cast<int>();
    std::array<std::size_t, 8> heard{};
    std::size_t count = 0;
    for (int corner = 0; corner < 8; ++corner) {
      const Eigen::Vector3i sample = low + Eigen::Vector3i(corner & 1, corner >> 1 & 1, corner >> 2);
      const Eigen::Vector3i cell(sample.x() >> 2, sample.y() >> 2, sample.z() >> 2);
      const auto brick = std::lower_bound(bricks.begin(), bricks.end(), cell,
                                          [](const Brick& b, const Eigen::Vector3i& c) { return place(b.cell) < place(c); });
      if (brick == bricks.end() || brick->cell != cell) continue;
      const auto in_brick = static_cast<std::size_t>(((sample.z() & 3) * 4 + (sample.y() & 3)) * 4 + (sample.x() & 3));
      const std::size_t piece = pieces.of(64 * static_cast<std::size_t>(brick - bricks.begin()) + in_brick);
      if (std::find(heard.begin(), heard.begin() + count, piece) == heard.begin() + count) heard[count++] = piece;
    }
    for (std::size_t n = 0; n < count; ++n) ++voices[heard[n]];
  }
  return voices;
}

}  // namespace

Debris drop_debris(BandField& field, const std::vector<Eigen::Vector3d>& points) {
  Debris dropped;
  if (field.bricks.empty()) return dropped;
  Pieces pieces(field.bricks);
  const std::vector<std::uint32_t> voices = support(field.bricks, pieces, points);
  const std::size_t far_inside = pieces.of(pieces.beyond(true)), far_outside = pieces.of(pieces.beyond(false));
  std::vector<bool> is_dropped(64 * field.bricks.size(), false);
  for (std::size_t n = 0; n < is_dropped.size(); ++n) {
    const std::size_t piece = pieces.of(n);
    if (piece == far_inside || piece == far_outside || voices[piece] >= kFewest) continue;
    is_dropped[n] = true;
    float& distance = value(field.bricks, n);
    const bool inside = distance < 0.0F;
    if (piece == n) ++(inside ? dropped.pieces : dropped.cavities);
    distance = inside ? std::max(-distance, kClear) : std::min(-distance, -kClear);
  }
  const auto clear = [&](std::size_t n) {
    float& distance = value(field.bricks, n);
    if (!is_dropped[n] && std::abs(distance) < kBeside) distance = std::copysign(kBeside, distance);
  };
  const auto clear_beside = [&](std::size_t a, std::size_t b) {
    if (is_dropped[a]) clear(b);
    if (is_dropped[b]) clear(a);
  };
  if (dropped.pieces + dropped.cavities > 0) walk_faces(field.bricks, clear_beside, [](std::size_t) {});
  return dropped;
}

}  // namespace isotouch::field
