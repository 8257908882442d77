#include "host/encoding/small_components.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstdlib>

#include "host/field/brick_mask.h"

namespace isotouch::encoding {

namespace {

using field::BrickMask;

constexpr std::int16_t kClear = 1 << 9;  // an eighth of a voxel: what is turned is no surface

/// Some samples of one brick.
struct Share {
  std::uint32_t brick;
  BrickMask samples;
};

/// Which coefficients of each brick are inside.
class Signs {
 public:
  Signs(const std::vector<Coefficients>& coefficients, const std::vector<Neighbours>& around) : around_(around) {
    inside_.reserve(coefficients.size());
    for (const Coefficients& brick : coefficients) {
      BrickMask inside = 0;
      for (std::size_t n = 0; n < brick.size(); ++n) inside |= BrickMask{brick[n] < 0 ? 1U : 0U} << n;
      inside_.push_back(inside);
    }
  }

  BrickMask of(std::uint32_t brick, bool inside) const { return inside ? inside_[brick] : ~inside_[brick]; }
  void turn(const Share& share) { inside_[share.brick] ^= share.samples; }

  /// All that hangs together with `start` and has its sign; nothing when that is more than kSmallComponent samples, or goes on beyond the listed bricks.
  std::vector<Share> speck(const Share& start, bool inside) const {
    std::vector<Share> all = {start};
    for (std::size_t next = 0; next < all.size(); ++next) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        for (const int end : {0, 1}) {
          const Share from = all[next];
          const BrickMask leaving = field::face(from.samples, axis, end);
          if (leaving == 0) continue;
          const std::uint32_t beside = around_[from.brick][end == 0 ? 13 - kStep[axis] : 13 + kStep[axis]];
          if (beside == kAbsent) return {};
          const BrickMask met = (end == 0 ? leaving << field::kAcross[axis] : leaving) & of(beside, inside);
          if (met != 0) add({beside, met}, inside, all);
          if (samples_of(all) > kSmallComponent) return {};
        }
      }
    }
    return all;
  }

 private:
  static constexpr std::size_t kStep[3] = {1, 3, 9};  // from one neighbour to the next

  static int samples_of(const std::vector<Share>& shares) {
    int count = 0;
    for (const Share& share : shares) count += std::popcount(share.samples);
    return count;
  }

  /// Appends the part of a brick that is met, unless it is there.
  void add(Share met, bool inside, std::vector<Share>& all) const {
    const BrickMask whole = of(met.brick, inside);
    for (BrickMask more = field::grown(met.samples) & whole; more != met.samples; more = field::grown(more) & whole) met.samples = more;
    for (const Share& known : all) {
      if (known.brick == met.brick) met.samples &= ~known.samples;
    }
    if (met.samples != 0) all.push_back(met);
  }

  const std::vector<Neighbours>& around_;
  std::vector<BrickMask> inside_;
};

/// Does a clear coefficient of the same sign touch the set at a corner or an edge? Then it is the tip of what lies there.
bool is_tip(const std::vector<Coefficients>& coefficients, const std::vector<Neighbours>& around, const std::vector<Share>& speck,
            bool inside) {
  const auto in_speck = [&](std::uint32_t brick, std::size_t n) {
    return std::any_of(speck.begin(), speck.end(), [&](const Share& s) { return s.brick == brick && (s.samples >> n & 1U) != 0; });
  };
  for (const Share& share : speck) {
    for (BrickMask rest = share.samples; rest != 0; rest &= rest - 1) {
      const int n = std::countr_zero(rest);
      for (int step = 0; step < 27; ++step) {
        const int x = (n & 3) + step % 3 - 1, y = (n >> 2 & 3) + step / 3 % 3 - 1, z = (n >> 4) + step / 9 - 1;
        const std::uint32_t brick =
            around[share.brick][static_cast<std::size_t>((((z + 4) >> 2) * 3 + ((y + 4) >> 2)) * 3 + ((x + 4) >> 2))];
        if (brick == kAbsent) continue;
        const std::size_t place = sample_number(x & 3, y & 3, z & 3);
        const int value = coefficients[brick][place];
        if ((inside ? -value : value) >= kClear && !in_speck(brick, place)) return true;
      }
    }
  }
  return false;
}

void turn(Coefficients& brick, BrickMask samples) {
  for (; samples != 0; samples &= samples - 1) {
    std::int16_t& value = brick[static_cast<std::size_t>(std::countr_zero(samples))];
    const int size = std::max<int>(std::abs(int{value}), kClear);
    value = static_cast<std::int16_t>(value < 0 ? size : -size);
  }
}

}  // namespace

std::vector<std::string> SmallComponents::warnings() const {
  std::vector<std::string> list;
  const auto warn = [&](std::size_t count, const char* one, const char* many, const char* done) {
    if (count > 0)
      list.push_back(std::to_string(count) + ' ' + (count == 1 ? one : many) + " too small for the grid " + done +
                     "; a smaller --voxel keeps more");
  };
  warn(pieces, "piece of surface", "pieces of surface", "left out");
  warn(cavities, "cavity", "cavities", "filled");
  return list;
}

SmallComponents drop_small_components(std::vector<Coefficients>& coefficients, const std::vector<Neighbours>& around) {
  Signs signs(coefficients, around);
  SmallComponents dropped;
  for (std::uint32_t b = 0; b < coefficients.size(); ++b) {
    for (const bool inside : {true, false}) {
      BrickMask rest = signs.of(b, inside);
      if (~rest == 0) continue;
      while (rest != 0) {
        const BrickMask part = field::first_piece(rest);
        rest &= ~part;
        if (std::popcount(part) > kSmallComponent) continue;
        const std::vector<Share> speck = signs.speck({b, part}, inside);
        if (speck.empty() || is_tip(coefficients, around, speck, inside)) continue;
        for (const Share& share : speck) {
          turn(coefficients[share.brick], share.samples);
          signs.turn(share);
        }
        ++(inside ? dropped.pieces : dropped.cavities);
      }
    }
  }
  return dropped;
}

}  // namespace isotouch::encoding
