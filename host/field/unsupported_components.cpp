#include "host/field/unsupported_components.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <tuple>

#include "host/field/brick_mask.h"
#include "host/field/parallel.h"

namespace isotouch::field {

namespace {

constexpr std::uint32_t kFewest = 4;  // points that a piece stands on
constexpr std::uint32_t kFew = 64;    // with so few the others are asked too
constexpr float kClear = 1.0F;        // voxels: what is left of a dropped piece, and
constexpr float kBeside = 0.5F;       // of what lay beside it, is no surface, and none for a spline that swings below its samples
constexpr std::uint32_t kNone = 0xFFFFFFFF;

auto place(const Eigen::Vector3i& cell) { return std::tuple(cell.z(), cell.y(), cell.x()); }

using Following = std::vector<std::array<std::uint32_t, 3>>;

/// Of every brick the one that follows it along each axis, kNone where there is none.
Following following(const std::vector<Brick>& bricks) {
  Following next(bricks.size(), {kNone, kNone, kNone});
  for (std::size_t axis = 0; axis < 3; ++axis) {
    std::size_t ahead = 0;
    for (std::size_t b = 0; b < bricks.size(); ++b) {
      const Eigen::Vector3i wanted = bricks[b].cell + Eigen::Vector3i::Unit(static_cast<Eigen::Index>(axis));
      while (ahead < bricks.size() && place(bricks[ahead].cell) < place(wanted)) ++ahead;
      if (ahead < bricks.size() && bricks[ahead].cell == wanted) next[b][axis] = static_cast<std::uint32_t>(ahead);
    }
  }
  return next;
}

/// Samples of one sign that hang together within a brick.
struct Part {
  std::uint32_t brick;
  bool inside;
  BrickMask samples;
};

/// Parts joined face to face to pieces; two more pieces for what lies beyond the listed bricks, inside and outside.
class Pieces {
 public:
  Pieces(const std::vector<Brick>& bricks, const Following& next) {
    std::vector<BrickMask> inside(bricks.size(), 0);
    in_parallel(bricks.size(), 1024, [&](std::size_t begin, std::size_t end) {
      for (std::size_t b = begin; b < end; ++b) {
        for (std::size_t s = 0; s < 64; ++s) inside[b] |= BrickMask{bricks[b].distance[s] < 0.0F} << s;
      }
    });
    for (std::uint32_t b = 0; b < bricks.size(); ++b) {
      first_.push_back(static_cast<std::uint32_t>(parts_.size()));
      add_parts(b, true, inside[b]);
      add_parts(b, false, ~inside[b]);
    }
    first_.push_back(static_cast<std::uint32_t>(parts_.size()));
    parent_.resize(parts_.size() + 2);
    std::iota(parent_.begin(), parent_.end(), 0U);
    std::vector<std::array<bool, 3>> has_before(bricks.size(), {false, false, false});
    for (std::uint32_t b = 0; b < bricks.size(); ++b) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        if (next[b][axis] != kNone) {
          has_before[next[b][axis]][axis] = true;
          join_across(b, next[b][axis], axis);
        } else {
          join_beyond(b, axis, 1);
        }
      }
    }
    for (std::uint32_t b = 0; b < bricks.size(); ++b) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        if (!has_before[b][axis]) join_beyond(b, axis, 0);
      }
    }
  }

  const std::vector<Part>& parts() const { return parts_; }
  /// The piece that a part belongs to, less than count().
  std::uint32_t of(std::uint32_t part) {
    while (parent_[part] != part) part = parent_[part] = parent_[parent_[part]];
    return part;
  }
  /// The same for a brick's sample.
  std::uint32_t at(std::size_t brick, std::size_t sample) {
    std::uint32_t part = first_[brick];
    while ((parts_[part].samples >> sample & 1U) == 0) ++part;
    return of(part);
  }
  std::uint32_t beyond(bool inside) { return of(static_cast<std::uint32_t>(parent_.size() - (inside ? 1 : 2))); }
  std::size_t count() const { return parent_.size(); }

 private:
  void add_parts(std::uint32_t brick, bool inside, BrickMask samples) {
    while (samples != 0) {
      const BrickMask part = ~samples == 0 ? samples : first_piece(samples);
      parts_.push_back({brick, inside, part});
      samples &= ~part;
    }
  }
  void join_across(std::uint32_t low, std::uint32_t high, std::size_t axis) {
    for (std::uint32_t a = first_[low]; a < first_[low + 1]; ++a) {
      for (std::uint32_t b = first_[high]; b < first_[high + 1]; ++b) {
        if (parts_[a].inside == parts_[b].inside && (face(parts_[a].samples, axis, 1) & face(parts_[b].samples, axis, 0)) != 0) join(a, b);
      }
    }
  }
  void join_beyond(std::uint32_t brick, std::size_t axis, int end) {
    for (std::uint32_t a = first_[brick]; a < first_[brick + 1]; ++a) {
      if (face(parts_[a].samples, axis, end) != 0) join(a, beyond(parts_[a].inside));
    }
  }
  void join(std::uint32_t a, std::uint32_t b) {
    const std::uint32_t first = of(a), second = of(b);
    parent_[std::min(first, second)] = std::max(first, second);  // the last ones, beyond, stay roots
  }

  std::vector<Part> parts_;
  std::vector<std::uint32_t> first_;  ///< of every brick, and their end
  std::vector<std::uint32_t> parent_;
};

/// How many points lie in a cell of eight samples that belongs to each piece.
std::vector<std::uint32_t> support(const std::vector<Brick>& bricks, Pieces& pieces, const std::vector<Eigen::Vector3d>& points) {
  std::vector<std::uint32_t> voices(pieces.count(), 0);
  for (const Eigen::Vector3d& point : points) {
    const Eigen::Vector3i low = point.array().floor().cast<int>();
    std::array<std::uint32_t, 8> heard{};
    std::size_t count = 0;
    auto brick = bricks.end();
    for (int corner = 0; corner < 8; ++corner) {
      const Eigen::Vector3i sample = low + Eigen::Vector3i(corner & 1, corner >> 1 & 1, corner >> 2);
      const Eigen::Vector3i cell(sample.x() >> 2, sample.y() >> 2, sample.z() >> 2);
      if (brick == bricks.end() || brick->cell != cell) {  // most corners lie in one brick
        brick = std::lower_bound(bricks.begin(), bricks.end(), cell,
                                 [](const Brick& b, const Eigen::Vector3i& c) { return place(b.cell) < place(c); });
      }
      if (brick == bricks.end() || brick->cell != cell) continue;
      const auto in_brick = static_cast<std::size_t>(((sample.z() & 3) * 4 + (sample.y() & 3)) * 4 + (sample.x() & 3));
      const std::uint32_t piece = pieces.at(static_cast<std::size_t>(brick - bricks.begin()), in_brick);
      if (std::find(heard.begin(), heard.begin() + count, piece) == heard.begin() + count) heard[count++] = piece;
    }
    for (std::size_t n = 0; n < count; ++n) ++voices[heard[n]];
  }
  return voices;
}

/// Of the pieces that few points stand for: how many more of their samples lie on the wrong side than on the right one.
std::vector<std::int64_t> contradiction(const std::vector<Brick>& bricks, Pieces& pieces, const std::vector<std::uint32_t>& voices,
                                        const std::function<bool(const Eigen::Vector3d&)>& enclosed) {
  std::vector<std::int64_t> doubt(pieces.count(), 0);
  for (std::uint32_t n = 0; n < pieces.parts().size(); ++n) {
    const std::uint32_t piece = pieces.of(n);
    if (voices[piece] < kFewest || voices[piece] >= kFew) continue;
    const Part& part = pieces.parts()[n];
    for (BrickMask rest = part.samples; rest != 0; rest &= rest - 1) {
      const int s = std::countr_zero(rest);
      const Eigen::Vector3d sample = (4 * bricks[part.brick].cell + Eigen::Vector3i(s & 3, s >> 2 & 3, s >> 4)).cast<double>();
      doubt[piece] += enclosed(sample) == part.inside ? -1 : 1;
    }
  }
  return doubt;
}

/// What lies face to face with a set of samples, given brick by brick, and the set itself.
std::vector<BrickMask> with_neighbours(const std::vector<BrickMask>& sets, const Following& next) {
  std::vector<BrickMask> all(sets.size());
  std::transform(sets.begin(), sets.end(), all.begin(), grown);
  for (std::size_t b = 0; b < sets.size(); ++b) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::uint32_t ahead = next[b][axis];
      if (ahead == kNone) continue;
      all[ahead] |= face(sets[b], axis, 1);
      all[b] |= face(sets[ahead], axis, 0) << kAcross[axis];
    }
  }
  return all;
}

template <class Action>
void for_each_sample(BrickMask samples, std::array<float, 64>& distances, const Action& action) {
  for (; samples != 0; samples &= samples - 1) action(distances[static_cast<std::size_t>(std::countr_zero(samples))]);
}

}  // namespace

UnsupportedComponents drop_unsupported(BandField& field, const std::vector<Eigen::Vector3d>& points,
                                       const std::function<bool(const Eigen::Vector3d&)>& enclosed) {
  UnsupportedComponents dropped;
  const Following next = following(field.bricks);
  Pieces pieces(field.bricks, next);
  std::vector<std::uint32_t> voices = support(field.bricks, pieces, points);
  voices[pieces.beyond(true)] = voices[pieces.beyond(false)] = kFew;
  const std::vector<std::int64_t> doubt = contradiction(field.bricks, pieces, voices, enclosed);
  std::vector<BrickMask> is_dropped(field.bricks.size(), 0);
  for (std::uint32_t n = 0; n < pieces.parts().size(); ++n) {
    const Part& part = pieces.parts()[n];
    const std::uint32_t piece = pieces.of(n);
    if (voices[piece] >= kFewest && doubt[piece] <= 0) continue;
    if (piece == n) ++(part.inside ? dropped.pieces : dropped.cavities);
    is_dropped[part.brick] |= part.samples;
    for_each_sample(part.samples, field.bricks[part.brick].distance,
                    [&](float& distance) { distance = part.inside ? std::max(-distance, kClear) : std::min(-distance, -kClear); });
  }
  if (dropped.pieces + dropped.cavities == 0) return dropped;
  const std::vector<BrickMask> beside = with_neighbours(is_dropped, next);
  for (std::size_t b = 0; b < beside.size(); ++b) {
    for_each_sample(beside[b] & ~is_dropped[b], field.bricks[b].distance, [](float& distance) {
      if (std::abs(distance) < kBeside) distance = std::copysign(kBeside, distance);
    });
  }
  return dropped;
}

}  // namespace isotouch::field
