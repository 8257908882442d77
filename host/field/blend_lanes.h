/// The blend of one brick, as many samples at a time as the source that includes this is compiled for. Each has its own: nothing here is shared.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

#include "host/field/blend_brick.h"
#include "host/field/simd.h"
#include "host/field/winding_sign.h"

namespace isotouch::field {

namespace {

using Model = BrickBlend::Model;
using Patch = BrickBlend::Patch;
using Point = BrickBlend::Point;

constexpr std::size_t kLanes = sizeof(Lanes) / sizeof(float);

/// As many places.
struct Places {
  Lanes x, y, z;

  Places operator-(const Point& p) const { return {x - p.x, y - p.y, z - p.z}; }
  Lanes squared_length() const { return (x * x + y * y) + z * z; }
  Lanes dot(const Point& p) const { return (x * p.x + y * p.y) + z * p.z; }
};

/// `circle_distance`, with the circle's radius at hand.
Lanes circle(Lanes u, Lanes w, float k, float radius) {
  const Lanes towards_centre = 1.0F + k * w, ku = k * u;
  const Lanes round = (k * (u * u + w * w) + 2.0F * w) / (1.0F + root(ku * ku + towards_centre * towards_centre));
  const Lanes beyond = (magnitude(ku) - 1.0F) * radius;
  return towards_centre < 0.0F ? beyond : round;
}

Lanes patch_distance(const Patch& patch, const Places& at) {
  const Places d = at - patch.point;
  if (patch.gentle == 0.0F && patch.tight == 0.0F) return d.dot(patch.normal);
  return circle(d.dot(patch.along), circle(d.dot(patch.across), d.dot(patch.normal), patch.gentle, patch.gentle_radius), patch.tight,
                patch.tight_radius);
}

Lanes joined(const Model& model, const Places& at) {
  Lanes value = patch_distance(model.pieces[0], at);
  for (std::size_t k = 1; k < model.count; ++k) {
    const Lanes next = patch_distance(model.pieces[k], at);
    value = (model.concave >> k & 1U) != 0 ? lesser(next, value) : larger(next, value);
  }
  return value;
}

/// `LocalModel::distance` where it counts.
///
/// away      squared distances from the sample
template <class Truth>
Lanes model_distance(const Model& model, const Places& at, Lanes away, Truth counts) {
  const auto beyond = counts & (away > model.reach * model.reach);
  if (!any(beyond)) return joined(model, at);
  const Lanes share = beyond ? model.reach / root(away) : all<Lanes>(1.0F);
  return joined(model, {at.x * share, at.y * share, at.z * share}) / share;
}

/// Sorts `value` into a list that keeps the smallest, ascending, in every lane.
template <std::size_t N>
void keep_least(std::array<Lanes, N>& list, Lanes value) {
  for (Lanes& place : list) {
    const Lanes rest = larger(value, place);
    place = lesser(value, place);
    value = rest;
  }
}

// A block is 4x2x2 samples, in as few rows as lanes allow: small enough that its places share most of their nearest samples.
constexpr std::size_t kBlock = 16;
constexpr std::size_t kRows = kBlock / kLanes;
constexpr float kBlockReach = 1.6584F;  // half a block's diagonal, rounded up
constexpr float kFar = 1e30F;           // squared, of no sample at all
constexpr float kSuspect = 0.25F;       // a surface less than half as far away as the nearest sample
constexpr float kNoWeight = 1e-20F;     // where all samples are at one distance, all weigh nothing, and count alike

using Rows = std::array<Lanes, kRows>;

/// A sample near a block.
struct Near {
  const Model* model;
  Point own;  ///< relative to the block's middle, as all places are
  Rows away;  ///< how far from each place, squared
};

/// The places of a block relative to its middle, x fastest, then y.
struct Block {
  std::array<float, kBlock> x{}, y{}, z{};
};
constexpr Block kPlaces = [] {
  Block block;
  for (std::size_t n = 0; n < kBlock; ++n) {
    block.x[n] = static_cast<float>(n & 3U) - 1.5F;
    block.y[n] = (n & 4U) != 0 ? 0.5F : -0.5F;
    block.z[n] = (n & 8U) != 0 ? 0.5F : -0.5F;
  }
  return block;
}();

Places row_of_block(std::size_t r) {
  return {load<Lanes>(&kPlaces.x[r * kLanes]), load<Lanes>(&kPlaces.y[r * kLanes]), load<Lanes>(&kPlaces.z[r * kLanes])};
}

float squared_length(const Point& p) { return (p.x * p.x + p.y * p.y) + p.z * p.z; }
Point operator-(const Point& a, const Point& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }

/// The samples around one block, and between which squared distances they count.
struct Neighbourhood {
  std::vector<Near> near;  ///< the kBlended + 1 nearest of every place, and a few more
  Rows nearest, border;    ///< of the first and of the last of these

  /// candidates   relative to the block's middle after `shift`; the nearer ones first makes it quick
  /// farthest     squared distance from which on a sample does not count at a place
  void gather(std::span<const BlendCandidate> candidates, const Point& shift, float farthest) {
    near.clear();
    std::array<std::array<Lanes, kBlended + 1>, kRows> least;
    for (auto& row : least) row.fill(all<Lanes>(farthest));
    for (const BlendCandidate& c : candidates) {
      const Point own = c.own - shift;
      Rows away;
      bool nearer = false;  // at a place, than the last of those before it, or as near
      for (std::size_t r = 0; r < kRows; ++r) {
        away[r] = (row_of_block(r) - own).squared_length();
        nearer = nearer || any(away[r] <= least[r].back());
      }
      if (!nearer) continue;
      for (std::size_t r = 0; r < kRows; ++r) keep_least(least[r], away[r]);
      near.push_back({c.model, own, away});
    }
    for (std::size_t r = 0; r < kRows; ++r) nearest[r] = least[r].front(), border[r] = least[r].back();
  }
};

/// bodies    where given, is told the mean of the models' `body`
template <bool kBodies = false>
Rows blended(const Neighbourhood& around, Rows* bodies = nullptr) {
  Rows scale, light, sum{}, body{}, weights{};
  for (std::size_t r = 0; r < kRows; ++r) {
    scale[r] = 1.0F / larger(around.border[r], all<Lanes>(1e-12F));
    const Lanes share = 1.0F - around.nearest[r] * scale[r];
    light[r] = static_cast<float>(kLeastWeight) * ((share * share) * (share * share));
  }
  for (const Near& n : around.near) {
    for (std::size_t r = 0; r < kRows; ++r) {
      const Lanes share = larger(1.0F - n.away[r] * scale[r], Lanes{});
      const Lanes nearness = (share * share) * (share * share);
      const auto counts = (nearness >= light[r]) & (n.away[r] <= around.border[r]);
      if (!any(counts)) continue;
      const Lanes weight = counts ? n.model->trust * nearness + kNoWeight : Lanes{};
      sum[r] += weight * model_distance(*n.model, row_of_block(r) - n.own, n.away[r], counts);
      weights[r] += weight;
      if constexpr (kBodies) body[r] += weight * n.model->body;
    }
  }
  for (Lanes& row : weights) row = larger(row, all<Lanes>(kNoWeight));  // where no sample counts
  for (std::size_t r = 0; r < kRows; ++r) sum[r] /= weights[r];
  if constexpr (kBodies) {
    for (std::size_t r = 0; r < kRows; ++r) (*bodies)[r] = body[r] / weights[r];
  }
  return sum;
}

/// `held_by_balls`: three balls of the other side must agree.
void hold_by_balls(const Neighbourhood& around, Rows& value) {
  std::array<std::array<Lanes, 3>, kRows> outside;  // minus the depths in balls of the other side, the deepest first
  for (auto& row : outside) row.fill(all<Lanes>(kFar));
  int voices = 0;
  bool any_inside = false, any_outside = false;
  for (const Lanes& row : value) any_inside = any_inside || any(row < 0.0F), any_outside = any_outside || any(row >= 0.0F);
  for (const Near& n : around.near) {
    const Model& model = *n.model;
    const Point middle = {-n.own.x, -n.own.y, -n.own.z};
    const auto reaches = [&](const Point& ball, float radius) {
      const float reach = radius + kBlockReach;
      return reach > 0.0F && squared_length(ball - middle) < reach * reach;
    };
    if (!(any_outside && reaches(model.inner, model.inner_radius)) && !(any_inside && reaches(model.outer, model.outer_radius))) continue;
    ++voices;
    for (std::size_t r = 0; r < kRows; ++r) {
      const Places at = row_of_block(r) - n.own;
      const auto inside = value[r] < 0.0F;
      const Places from_ball = {at.x - (inside ? all<Lanes>(model.outer.x) : all<Lanes>(model.inner.x)),
                                at.y - (inside ? all<Lanes>(model.outer.y) : all<Lanes>(model.inner.y)),
                                at.z - (inside ? all<Lanes>(model.outer.z) : all<Lanes>(model.inner.z))};
      const Lanes away = root(from_ball.squared_length()) - (inside ? all<Lanes>(model.outer_radius) : all<Lanes>(model.inner_radius));
      keep_least(outside[r], n.away[r] < around.border[r] ? away : all<Lanes>(kFar));
    }
  }
  if (voices < 3) return;
  for (std::size_t r = 0; r < kRows; ++r) {
    const Lanes agreed = -outside[r].back();
    const Lanes held = value[r] < 0.0F ? larger(agreed, value[r]) : lesser(-agreed, value[r]);
    value[r] = agreed > 0.0F ? held : value[r];
  }
}

/// The bits of a block's samples that lie far from every sample of the scan, and of those among them that are suspect.
BrickBlend::Doubt doubt_of(const Neighbourhood& around, const Rows& value, double beyond) {
  BrickBlend::Doubt doubt{beyond};
  for (std::size_t r = 0; r < kRows; ++r) {
    const auto far = around.nearest[r] > static_cast<float>(beyond) * (around.border[r] - around.nearest[r]);
    if (!any(far)) continue;
    const auto suspect = far & (value[r] * value[r] < kSuspect * around.nearest[r]);
    doubt.far |= std::uint64_t{true_lanes(far)} << (r * kLanes);
    doubt.suspect |= std::uint64_t{true_lanes(suspect)} << (r * kLanes);
  }
  return doubt;
}

/// Puts a block's rows where they belong in a brick.
void store_block(const Rows& value, std::size_t y, std::size_t z, std::array<float, 64>& brick) {
  for (std::size_t n = 0; n < kBlock; n += 4) {
    const std::size_t place = ((z + (n >> 3)) * 4 + y + (n >> 2 & 1)) * 4;
    std::memcpy(&brick[place], reinterpret_cast<const float*>(&value) + n, 4 * sizeof(float));
  }
}

/// How far from the brick's middle a sample may lie and still be as near to one of a block's places as `border`; rounded up.
float farthest(const Rows& border, const Point& block) {
  constexpr float kRounding = 1e-3F;
  Lanes most{};
  for (std::size_t r = 0; r < kRows; ++r)
    most = larger(root(border[r]) + root((row_of_block(r) - Point{-block.x, -block.y, -block.z}).squared_length()), most);
  return largest(most) + kRounding;
}

/// What `blend_body` does.
__attribute__((flatten)) BrickReading body_blocks(std::span<const BlendCandidate> candidates, float reach, float depth) {
  thread_local Neighbourhood around;  // keeps its memory
  BrickReading result;
  float most = 0.0F;
  for (std::size_t z = 0; z < 4; z += 2) {
    for (std::size_t y = 0; y < 4; y += 2) {
      const Point block = {0.0F, static_cast<float>(y) - 1.0F, static_cast<float>(z) - 1.0F};
      around.gather(candidates, block, reach * reach);
      most = std::max(most, farthest(around.border, block));
      Rows value;
      if (around.near.empty()) {
        value.fill(all<Lanes>(reach));
      } else {
        Rows body;
        value = blended<true>(around, &body);
        for (std::size_t r = 0; r < kRows; ++r) {
          const Lanes nearest = root(larger(around.nearest[r], all<Lanes>(1e-12F)));
          const Lanes behind = lesser(larger(-value[r] / lesser(nearest, all<Lanes>(reach - depth)), Lanes{}), all<Lanes>(1.0F));
          value[r] = larger(nearest - body[r] - (depth - body[r]) * behind, value[r]);
        }
      }
      store_block(value, y, z, result.distance);
    }
  }
  result.influence = most * most;
  return result;
}

/// What `nearest_distances` does.
__attribute__((flatten)) BrickReading nearest_blocks(std::span<const BlendCandidate> candidates) {
  BrickReading result;
  float most = 0.0F;
  for (std::size_t z = 0; z < 4; z += 2) {
    for (std::size_t y = 0; y < 4; y += 2) {
      const Point block = {0.0F, static_cast<float>(y) - 1.0F, static_cast<float>(z) - 1.0F};
      Rows least;
      least.fill(all<Lanes>(kFar));
      for (const BlendCandidate& c : candidates) {
        const Point own = c.own - block;
        for (std::size_t r = 0; r < kRows; ++r) least[r] = lesser((row_of_block(r) - own).squared_length(), least[r]);
      }
      most = std::max(most, farthest(least, block));
      for (Lanes& row : least) row = root(row);
      store_block(least, y, z, result.distance);
    }
  }
  result.influence = most * most;
  return result;
}

/// What `BrickBlend` does, of the candidates found. Inline in each source that is compiled for a width of its own.
__attribute__((flatten)) std::array<float, 64> blend_blocks(std::span<const BlendCandidate> candidates, BrickBlend::Doubt& doubt) {
  thread_local Neighbourhood around;  // keeps its memory
  std::array<float, 64> result;
  for (std::size_t z = 0; z < 4; z += 2) {
    for (std::size_t y = 0; y < 4; y += 2) {
      around.gather(candidates, {0.0F, static_cast<float>(y) - 1.0F, static_cast<float>(z) - 1.0F}, kFar);
      Rows value = blended(around);
      hold_by_balls(around, value);
      store_block(value, y, z, result);
      const BrickBlend::Doubt doubts = doubt_of(around, value, doubt.beyond);
      for (std::size_t n = 0; n < kBlock; n += 4) {
        const std::size_t place = ((z + (n >> 3)) * 4 + y + (n >> 2 & 1)) * 4;
        doubt.far |= (doubts.far >> n & 15U) << place;
        doubt.suspect |= (doubts.suspect >> n & 15U) << place;
      }
    }
  }
  return result;
}

}  // namespace

}  // namespace isotouch::field
