#include "host/field/slope_limit.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <tuple>
#include <vector>

#include "host/field/brick_mask.h"
#include "host/field/following.h"
#include "host/field/parallel.h"

namespace isotouch::field {

namespace {

constexpr float kRounding = 1.0F + 1e-5F;

bool by_place(const Brick& a, const Brick& b) {
  return std::tuple(a.cell.z(), a.cell.y(), a.cell.x()) < std::tuple(b.cell.z(), b.cell.y(), b.cell.x());
}

/// Bricks with their neighbours, and what two samples face to face may differ by.
class Slopes {
 public:
  Slopes(BandField& field, double slope)
      : bricks_(field.bricks),
        band_(static_cast<float>(field.band)),
        slope_(static_cast<float>(slope)),
        cells_((field.grid.size + Eigen::Vector3i::Constant(3)) / 4),
        next_(following(field.bricks)),
        before_(field.bricks.size(), {kNoBrick, kNoBrick, kNoBrick}) {
    for (std::uint32_t b = 0; b < next_.size(); ++b) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        if (next_[b][axis] != kNoBrick) before_[next_[b][axis]][axis] = b;
      }
    }
  }

  /// The bricks that a step too large leads into or out of, ascending.
  std::vector<std::uint32_t> steep() {
    std::vector<std::uint8_t> found(bricks_.size(), 0);
    in_parallel(bricks_.size(), 64, [&](std::size_t begin, std::size_t end) {
      for (std::size_t b = begin; b < end; ++b) {
        for_each_step(static_cast<std::uint32_t>(b), false, [&](float& a, float& c) {
          if (too_large(a, c)) found[b] = 1;
        });
      }
    });
    std::vector<std::uint32_t> list;
    for (std::uint32_t b = 0; b < found.size(); ++b) {
      if (found[b] != 0) list.push_back(b);
    }
    return list;
  }

  /// Shortens distances, from these bricks on to all that they lead to; tells which were changed.
  std::vector<std::uint32_t> limit(std::vector<std::uint32_t> bricks) {
    std::vector<std::uint32_t> all;
    while (!bricks.empty()) {
      std::vector<std::uint32_t> changed;
      for (const std::uint32_t b : bricks) {
        bool any = false;
        for_each_step(b, true, [&](float& a, float& c) { any = shorten(a, c) || any; });
        if (!any) continue;
        changed.push_back(b);
        for (std::size_t axis = 0; axis < 3; ++axis) {
          for (const std::uint32_t beside : {before_[b][axis], next_[b][axis]}) {
            if (beside != kNoBrick) changed.push_back(beside);
          }
        }
      }
      std::sort(changed.begin(), changed.end());
      changed.erase(std::unique(changed.begin(), changed.end()), changed.end());
      all.insert(all.end(), changed.begin(), changed.end());
      bricks = std::move(changed);
    }
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
  }

  /// The unlisted bricks beside the given ones where the band's distance is too far.
  std::vector<Brick> missing(const std::vector<std::uint32_t>& bricks) const {
    std::vector<Brick> list;
    for (const std::uint32_t b : bricks) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        for (const int end : {0, 1}) {
          const Eigen::Vector3i cell = bricks_[b].cell + (2 * end - 1) * Eigen::Vector3i::Unit(static_cast<Eigen::Index>(axis));
          if ((end == 0 ? before_ : next_)[b][axis] != kNoBrick || (cell.array() < 0).any() || (cell.array() >= cells_.array()).any())
            continue;
          float least = band_;
          for (BrickMask low = kLowFace[axis]; low != 0; low &= low - 1) {
            const int sample = std::countr_zero(low) + end * kAcross[axis];
            least = std::min(least, std::abs(bricks_[b].distance[static_cast<std::size_t>(sample)]));
          }
          if (band_ - least > slope_ * kRounding) list.push_back(unlisted(cell));
        }
      }
    }
    return list;
  }

 private:
  float held(float distance) const { return std::min(std::abs(distance), band_); }
  static bool one_side(float a, float b) { return (a < 0.0F) == (b < 0.0F); }

  bool too_large(float a, float b) const {
    const float step = one_side(a, b) ? std::abs(held(a) - held(b)) : held(a) + held(b);
    return step > slope_ * kRounding;
  }
  bool shorten(float& a, float& b) const {
    if (!too_large(a, b)) return false;
    if (one_side(a, b)) {
      float& larger = std::abs(a) > std::abs(b) ? a : b;
      larger = std::copysign(std::min(std::abs(a), std::abs(b)) + slope_, larger);
    } else {
      const float share = slope_ / (held(a) + held(b));
      a = std::copysign(held(a) * share, a);
      b = std::copysign(held(b) * share, b);
    }
    return true;
  }

  /// What stands for a brick that is not listed: the far side that the brick before it in its row ends with.
  Brick unlisted(const Eigen::Vector3i& cell) const {
    Brick brick{cell, {}};
    const float beyond = 2.0F * band_;  // it is no distance within the band
    const auto after = std::lower_bound(bricks_.begin(), bricks_.end(), brick, by_place);
    const bool same_row = after != bricks_.begin() && (after - 1)->cell.tail<2>() == cell.tail<2>();
    brick.distance.fill(same_row && (after - 1)->distance[static_cast<std::size_t>(kAcross[0])] < 0.0F ? -beyond : beyond);
    return brick;
  }

  /// Calls visit(sample, next one) for the steps within a brick, those to the bricks that follow it, and where wanted those from the ones before.
  template <class Visit>
  void for_each_step(std::uint32_t b, bool back, const Visit& visit) {
    auto& own = bricks_[b].distance;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto step = static_cast<std::size_t>(kNext[axis]), across = static_cast<std::size_t>(kAcross[axis]);
      float* const after = next_[b][axis] != kNoBrick ? bricks_[next_[b][axis]].distance.data() : nullptr;
      float* const before = back && before_[b][axis] != kNoBrick ? bricks_[before_[b][axis]].distance.data() : nullptr;
      for (BrickMask low = kLowFace[axis]; low != 0; low &= low - 1) {
        const auto first = static_cast<std::size_t>(std::countr_zero(low));
        if (before != nullptr) visit(before[first + across], own[first]);
        for (std::size_t s = first; s < first + across; s += step) visit(own[s], own[s + step]);
        if (after != nullptr) visit(own[first + across], after[first]);
      }
    }
  }

  std::vector<Brick>& bricks_;
  float band_, slope_;
  Eigen::Vector3i cells_;
  Following next_, before_;
};

}  // namespace

void limit_slopes(BandField& field, double slope) {
  for (double reach = -4.0; reach < field.band;
       reach += 4.0) {  // a ramp is shorter than the band is wide, and each round goes a brick further
    Slopes slopes(field, slope);
    const std::vector<std::uint32_t> steep = slopes.steep();
    if (steep.empty()) return;
    std::vector<Brick> missing = slopes.missing(slopes.limit(steep));
    if (missing.empty()) return;
    std::sort(missing.begin(), missing.end(), by_place);
    missing.erase(std::unique(missing.begin(), missing.end(), [](const Brick& a, const Brick& b) { return a.cell == b.cell; }),
                  missing.end());
    const auto middle = static_cast<std::ptrdiff_t>(field.bricks.size());
    field.bricks.insert(field.bricks.end(), missing.begin(), missing.end());
    std::inplace_merge(field.bricks.begin(), field.bricks.begin() + middle, field.bricks.end(), by_place);
  }
}

}  // namespace isotouch::field
