#include "host/field/unsupported_components.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <utility>

#include "host/field/brick_mask.h"
#include "host/field/brick_neighbours.h"
#include "host/field/dips.h"
#include "host/field/parallel.h"
#include "host/field/remaining_distance.h"
#include "host/field/sample_masks.h"
#include "host/field/sets.h"
#include "host/field/unlisted_regions.h"

namespace isotouch::field {

namespace {

constexpr std::uint32_t kFew = 64;  // with so few the others are asked too
constexpr float kTaken = 1.0F;      // until the distance to the rest is known

/// Samples of one sign that hang together within a brick.
struct Part {
  std::uint32_t brick;
  bool inside;
  BrickMask samples;
};

/// Parts joined face to face to pieces, also across regions without bricks; each of these counts as two parts more, one inside and one outside.
class Pieces {
 public:
  Pieces(const BandField& field, const Following& next) : regions_(field) {
    const std::vector<Brick>& bricks = field.bricks;
    std::vector<BrickMask> inside(bricks.size());
    in_parallel(bricks.size(), 1024, [&](std::size_t begin, std::size_t end) {
      for (std::size_t b = begin; b < end; ++b) inside[b] = inside_of(bricks[b].distance);
    });
    for (std::uint32_t b = 0; b < bricks.size(); ++b) {
      first_.push_back(static_cast<std::uint32_t>(parts_.size()));
      add_parts(b, true, inside[b]);
      add_parts(b, false, ~inside[b]);
    }
    first_.push_back(static_cast<std::uint32_t>(parts_.size()));
    pieces_ = Sets(parts_.size() + 2 * regions_.count());
    std::vector<std::array<bool, 3>> has_before(bricks.size(), {false, false, false});
    for (std::uint32_t b = 0; b < bricks.size(); ++b) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        if (next[b][axis] != kNoBrick) {
          has_before[next[b][axis]][axis] = true;
          join_across(b, next[b][axis], axis);
        } else {
          join_beyond(b, bricks[b].cell, axis, 1);
        }
      }
    }
    for (std::uint32_t b = 0; b < bricks.size(); ++b) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        if (!has_before[b][axis]) join_beyond(b, bricks[b].cell, axis, 0);
      }
    }
  }

  const std::vector<Part>& parts() const { return parts_; }
  /// The piece that a part belongs to, less than count().
  std::uint32_t of(std::uint32_t part) { return pieces_.of(part); }
  /// The same for a brick's sample.
  std::uint32_t at(std::size_t brick, std::size_t sample) {
    std::uint32_t part = first_[brick];
    while ((parts_[part].samples >> sample & 1U) == 0) ++part;
    return of(part);
  }
  /// The piece that a region without bricks belongs to, where its neighbours are of one sign or the other.
  std::uint32_t beyond(std::uint32_t region, bool inside) {
    return of(static_cast<std::uint32_t>(parts_.size()) + 2 * region + (inside ? 1U : 0U));
  }
  std::size_t count() const { return pieces_.size(); }

  /// Calls use(piece, other) for pieces that lie face to face; they have different signs. Some more than once.
  template <class Use>
  void for_each_contact(const Following& next, const Use& use) {
    for (std::uint32_t b = 0; b + 1 < first_.size(); ++b) {
      for (std::uint32_t part = first_[b]; part < first_[b + 1]; ++part) {
        const BrickMask beside = grown(parts_[part].samples);
        for (std::uint32_t other = part + 1; other < first_[b + 1]; ++other) {
          if ((beside & parts_[other].samples) != 0) use(of(part), of(other));
        }
        for (std::size_t axis = 0; axis < 3; ++axis) {
          const std::uint32_t ahead = next[b][axis];
          if (ahead == kNoBrick) continue;
          for (std::uint32_t other = first_[ahead]; other < first_[ahead + 1]; ++other) {
            if (parts_[part].inside != parts_[other].inside &&
                (face(parts_[part].samples, axis, 1) & face(parts_[other].samples, axis, 0)) != 0)
              use(of(part), of(other));
          }
        }
      }
    }
  }

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
  void join_beyond(std::uint32_t brick, const Eigen::Vector3i& cell, std::size_t axis, int end) {
    const std::uint32_t region = regions_.of(cell + (end == 0 ? -1 : 1) * Eigen::Vector3i::Unit(static_cast<Eigen::Index>(axis)));
    for (std::uint32_t a = first_[brick]; a < first_[brick + 1]; ++a) {
      if (face(parts_[a].samples, axis, end) != 0) join(a, beyond(region, parts_[a].inside));
    }
  }
  void join(std::uint32_t a, std::uint32_t b) {
    const std::uint32_t first = of(a), second = of(b);
    pieces_.join(std::min(first, second), std::max(first, second));  // the first part of a piece stands for it
  }

  UnlistedRegions regions_;
  std::vector<Part> parts_;
  std::vector<std::uint32_t> first_;  ///< of every brick, and their end
  Sets pieces_{0};                    ///< of parts, and of both sides of every region
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
                                 [](const Brick& b, const Eigen::Vector3i& c) { return sort_key(b.cell) < sort_key(c); });
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
    if (voices[piece] < kFewestVoices || voices[piece] >= kFew) continue;
    const Part& part = pieces.parts()[n];
    for (BrickMask rest = part.samples; rest != 0; rest &= rest - 1) {
      const int s = std::countr_zero(rest);
      const Eigen::Vector3d sample = (4 * bricks[part.brick].cell + Eigen::Vector3i(s & 3, s >> 2 & 3, s >> 4)).cast<double>();
      doubt[piece] += enclosed(sample) == part.inside ? -1 : 1;
    }
  }
  return doubt;
}

/// Which of the dropped pieces change their sign to that of what lies round them: those beside a piece that stays. What is enclosed by a dropped piece
/// alone, as a bubble in a shard, has the right sign once the other has changed, and so on inwards.
std::vector<std::uint8_t> turned_pieces(Pieces& pieces, const Following& next, const std::vector<std::uint8_t>& is_dropped) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> contacts;
  pieces.for_each_contact(next, [&](std::uint32_t a, std::uint32_t b) {
    if (is_dropped[a] != 0) contacts.emplace_back(b, a);
    if (is_dropped[b] != 0) contacts.emplace_back(a, b);
  });
  std::sort(contacts.begin(), contacts.end());
  contacts.erase(std::unique(contacts.begin(), contacts.end()), contacts.end());
  std::vector<std::uint8_t> known(pieces.count()), turned(pieces.count(), 0);
  for (std::size_t piece = 0; piece < known.size(); ++piece) known[piece] = is_dropped[piece] == 0 ? 1 : 0;
  for (bool found = true; found;) {
    std::vector<std::uint32_t> reached;
    for (const auto& [from, to] : contacts) {
      if (known[from] == 0 || known[to] != 0) continue;
      turned[to] = turned[from] == 0 ? 1 : 0;
      reached.push_back(to);
    }
    for (const std::uint32_t piece : reached) known[piece] = 1;
    found = !reached.empty();
  }
  return turned;
}

}  // namespace

UnsupportedComponents drop_unsupported(BandField& field, const std::vector<Eigen::Vector3d>& points,
                                       const std::function<bool(const Eigen::Vector3d&)>& enclosed) {
  UnsupportedComponents dropped;
  const Following next = following(field.bricks);
  Pieces pieces(field, next);
  std::vector<std::uint32_t> voices = support(field.bricks, pieces, points);
  for (const bool inside : {false, true}) voices[pieces.beyond(UnlistedRegions::kOuter, inside)] = kFew;
  const std::vector<std::int64_t> doubt = contradiction(field.bricks, pieces, voices, enclosed);
  std::vector<std::uint8_t> is_dropped(pieces.count(), 0);
  for (std::uint32_t n = 0; n < pieces.parts().size(); ++n) {
    const std::uint32_t piece = pieces.of(n);
    if (voices[piece] >= kFewestVoices && doubt[piece] <= 0) continue;
    is_dropped[piece] = 1;
    if (piece == n) ++(pieces.parts()[n].inside ? dropped.pieces : dropped.cavities);
  }
  std::vector<BrickMask> taken = unsupported_dips(field.bricks, next, points);
  const bool dipped = std::any_of(taken.begin(), taken.end(), [](BrickMask set) { return set != 0; });
  if (dropped.pieces + dropped.cavities == 0 && !dipped) return dropped;
  const std::vector<std::uint8_t> turned = turned_pieces(pieces, next, is_dropped);
  for (std::uint32_t n = 0; n < pieces.parts().size(); ++n) {
    const Part& part = pieces.parts()[n];
    if (is_dropped[pieces.of(n)] == 0) continue;
    taken[part.brick] |= part.samples;
    const bool inside = part.inside != (turned[pieces.of(n)] != 0);
    for (BrickMask rest = part.samples; rest != 0; rest &= rest - 1)
      field.bricks[part.brick].distance[static_cast<std::size_t>(std::countr_zero(rest))] = inside ? -kTaken : kTaken;
  }
  restore_distances(field, taken);
  return dropped;
}

}  // namespace isotouch::field
