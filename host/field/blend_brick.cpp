#include "host/field/blend_brick.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "host/field/enclosure.h"
#include "host/field/four.h"

namespace isotouch::field {

namespace {

using Model = BrickBlend::Model;
using Patch = BrickBlend::Patch;
using Point = BrickBlend::Point;

Point as_floats(const Eigen::Vector3d& v) { return {static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z())}; }

Patch as_floats(const ToroidalPatch& patch, const Eigen::Vector3d& sample) {
  const auto gentle = static_cast<float>(patch.gentle), tight = static_cast<float>(patch.tight);
  const auto radius = [](float curvature) { return curvature != 0.0F ? 1.0F / curvature : 0.0F; };
  return {as_floats(patch.point - sample),
          as_floats(patch.normal),
          as_floats(patch.across),
          as_floats(patch.along),
          gentle,
          tight,
          radius(gentle),
          radius(tight)};
}

Model as_floats(const Eigen::Vector3d& sample, const LocalModel& model, const EmptyBalls& balls) {
  Model result{};
  for (std::size_t k = 0; k < model.count; ++k) result.pieces[k] = as_floats(model.pieces[k], sample);
  result.count = model.count;
  result.concave = model.concave;
  result.reach = model.reach > 0.0 ? static_cast<float>(model.reach) : std::numeric_limits<float>::max();
  result.trust = static_cast<float>(model.trust);
  result.inner = as_floats(balls.inner - sample);
  result.outer = as_floats(balls.outer - sample);
  result.inner_radius = static_cast<float>(balls.inner_radius - balls.slack);
  result.outer_radius = static_cast<float>(balls.outer_radius - balls.slack);
  return result;
}

/// Four places.
struct Places {
  Four x, y, z;

  Places operator-(const Point& p) const { return {x - p.x, y - p.y, z - p.z}; }
  Four squared_length() const { return (x * x + y * y) + z * z; }
  Four dot(const Point& p) const { return (x * p.x + y * p.y) + z * p.z; }
};

/// `circle_distance`, with the circle's radius at hand.
Four circle(Four u, Four w, float k, float radius) {
  const Four towards_centre = 1.0F + k * w, ku = k * u;
  const Four round = (k * (u * u + w * w) + 2.0F * w) / (1.0F + root(ku * ku + towards_centre * towards_centre));
  const Four beyond = (magnitude(ku) - 1.0F) * radius;
  return towards_centre < 0.0F ? beyond : round;
}

Four patch_distance(const Patch& patch, const Places& at) {
  const Places d = at - patch.point;
  if (patch.gentle == 0.0F && patch.tight == 0.0F) return d.dot(patch.normal);
  return circle(d.dot(patch.along), circle(d.dot(patch.across), d.dot(patch.normal), patch.gentle, patch.gentle_radius), patch.tight,
                patch.tight_radius);
}

Four joined(const Model& model, const Places& at) {
  Four value = patch_distance(model.pieces[0], at);
  for (std::size_t k = 1; k < model.count; ++k) {
    const Four next = patch_distance(model.pieces[k], at);
    value = (model.concave >> k & 1U) != 0 ? lesser(next, value) : larger(next, value);
  }
  return value;
}

/// `LocalModel::distance`; away: squared distances from the sample.
Four model_distance(const Model& model, const Places& at, Four away) {
  if (!any(away > model.reach * model.reach)) return joined(model, at);
  const Four share = away > model.reach * model.reach ? model.reach / root(away) : all(1.0F);
  return joined(model, {at.x * share, at.y * share, at.z * share}) / share;
}

/// Sorts `value` into a list that keeps the smallest, ascending, in every lane.
template <std::size_t N>
void keep_least(std::array<Four, N>& list, Four value) {
  if (!any(value < list.back())) return;
  for (Four& place : list) {
    const Four rest = larger(value, place);
    place = lesser(value, place);
    value = rest;
  }
}

// A block is 4x2x2 samples, four rows: small enough that its places share most of their nearest samples.
constexpr std::size_t kRows = 4;
constexpr float kBlockReach = 1.6584F;  // half a block's diagonal, rounded up
constexpr float kFar = 1e30F;           // squared, of no sample at all
constexpr float kSuspect = 0.25F;       // a surface less than half as far away as the nearest sample
constexpr float kNoWeight = 1e-20F;     // where all samples are at one distance, all weigh nothing, and count alike

using Rows = std::array<Four, kRows>;

/// A sample near a brick, relative to the brick's middle.
struct Candidate {
  const Model* model;
  Point own;
};

/// A sample near a block.
struct Near {
  const Model* model;
  Point own;     ///< relative to the block's middle, as all places are
  float middle;  ///< how far from the middle, squared
  Rows away;     ///< how far from each place, squared
};

Places row_of_block(std::size_t r) {
  return {Four{-1.5F, -0.5F, 0.5F, 1.5F}, all((r & 1U) != 0 ? 0.5F : -0.5F), all((r >> 1U) != 0 ? 0.5F : -0.5F)};
}

float squared_length(const Point& p) { return (p.x * p.x + p.y * p.y) + p.z * p.z; }
Point operator-(const Point& a, const Point& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }

/// The samples around one block, and between which squared distances they count.
struct Neighbourhood {
  std::vector<Near> near;  ///< the kBlended + 1 nearest of every place, and a few more
  Rows nearest, border;    ///< of the first and of the last of these

  /// candidates   relative to the block's middle after `shift`; the nearer ones first makes it quick
  void gather(const std::vector<Candidate>& candidates, const Point& shift) {
    near.clear();
    std::array<std::array<Four, kBlended + 1>, kRows> least;
    for (auto& row : least) row.fill(all(kFar));
    float reach = kFar;  // squared; what is farther from the middle is nobody's neighbour
    for (const Candidate& c : candidates) {
      const Point own = c.own - shift;
      const float middle = squared_length(own);
      if (middle > reach) continue;
      Near& n = near.emplace_back(Near{c.model, own, middle, {}});
      for (std::size_t r = 0; r < kRows; ++r) {
        n.away[r] = (row_of_block(r) - own).squared_length();
        keep_least(least[r], n.away[r]);
      }
      if (near.size() <= kBlended) continue;
      const float farthest = largest(larger(larger(least[0].back(), least[1].back()), larger(least[2].back(), least[3].back())));
      const float bound = std::sqrt(farthest) + kBlockReach;
      reach = bound * bound;
    }
    std::erase_if(near, [=](const Near& n) { return n.middle > reach; });
    for (std::size_t r = 0; r < kRows; ++r) nearest[r] = least[r].front(), border[r] = least[r].back();
  }
};

Rows blended(const Neighbourhood& around) {
  Rows scale, light, sum{}, weights{};
  for (std::size_t r = 0; r < kRows; ++r) {
    scale[r] = 1.0F / larger(around.border[r], all(1e-12F));
    const Four share = 1.0F - around.nearest[r] * scale[r];
    light[r] = static_cast<float>(kLeastWeight) * ((share * share) * (share * share));
  }
  for (const Near& n : around.near) {
    for (std::size_t r = 0; r < kRows; ++r) {
      const Four share = larger(1.0F - n.away[r] * scale[r], Four{});
      const Four nearness = (share * share) * (share * share);
      const auto counts = nearness >= light[r];
      if (!any(counts)) continue;
      const Four weight = counts ? n.model->trust * nearness + kNoWeight : Four{};
      sum[r] += weight * model_distance(*n.model, row_of_block(r) - n.own, n.away[r]);
      weights[r] += weight;
    }
  }
  for (std::size_t r = 0; r < kRows; ++r) sum[r] /= weights[r];
  return sum;
}

/// `held_by_balls`: three balls of the other side must agree.
void hold_by_balls(const Neighbourhood& around, Rows& value) {
  std::array<std::array<Four, 3>, kRows> outside;  // minus the depths in balls of the other side, the deepest first
  for (auto& row : outside) row.fill(all(kFar));
  int voices = 0;
  bool any_inside = false, any_outside = false;
  for (const Four& row : value) any_inside = any_inside || any(row < 0.0F), any_outside = any_outside || any(row >= 0.0F);
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
      const Places from_ball = {at.x - (inside ? all(model.outer.x) : all(model.inner.x)),
                                at.y - (inside ? all(model.outer.y) : all(model.inner.y)),
                                at.z - (inside ? all(model.outer.z) : all(model.inner.z))};
      const Four away = root(from_ball.squared_length()) - (inside ? all(model.outer_radius) : all(model.inner_radius));
      keep_least(outside[r], n.away[r] < around.border[r] ? away : all(kFar));
    }
  }
  if (voices < 3) return;
  for (std::size_t r = 0; r < kRows; ++r) {
    const Four agreed = -outside[r].back();
    const Four held = value[r] < 0.0F ? larger(agreed, value[r]) : lesser(-agreed, value[r]);
    value[r] = agreed > 0.0F ? held : value[r];
  }
}

/// Row r of a block, which begins at `place` of the brick.
void tell_doubt(const Neighbourhood& around, const Rows& value, std::size_t r, std::size_t place, BrickBlend::Doubt& doubt) {
  const Four nearest = around.nearest[r], limit = static_cast<float>(kDoubt) * (around.border[r] - nearest);
  if (!any(nearest > limit)) return;
  for (std::size_t x = 0; x < 4; ++x) {
    if (!(nearest[x] > limit[x])) continue;
    doubt.far |= std::uint64_t{1} << (place + x);
    if (value[r][x] * value[r][x] < kSuspect * nearest[x]) doubt.suspect |= std::uint64_t{1} << (place + x);
  }
}

}  // namespace

BrickBlend::BrickBlend(std::vector<Eigen::Vector3d> positions, const std::vector<LocalModel>& models, const std::vector<EmptyBalls>& balls)
    : positions_(std::move(positions)) {
  models_.reserve(models.size());
  for (std::size_t i = 0; i < models.size(); ++i) models_.push_back(as_floats(positions_[i], models[i], balls[i]));
}

ISOTOUCH_WIDEST std::array<float, 64> BrickBlend::operator()(const Eigen::Vector3d& first, std::span<const Neighbour> candidates,
                                                             Doubt& doubt) const {
  const Eigen::Vector3d middle = first + Eigen::Vector3d::Constant(1.5);
  thread_local std::vector<Candidate> near;  // they keep their memory
  thread_local Neighbourhood around;
  near.clear();
  for (const Neighbour& c : candidates) near.push_back({&models_[c.index], as_floats(positions_[c.index] - middle)});
  std::array<float, 64> result;
  for (int z = 0; z < 4; z += 2) {
    for (int y = 0; y < 4; y += 2) {
      around.gather(near, {0.0F, static_cast<float>(y) - 1.0F, static_cast<float>(z) - 1.0F});
      Rows value = blended(around);
      hold_by_balls(around, value);
      for (int r = 0; r < static_cast<int>(kRows); ++r) {
        for (int x = 0; x < 4; ++x) {
          result[static_cast<std::size_t>(((z + (r >> 1)) * 4 + y + (r & 1)) * 4 + x)] = value[static_cast<std::size_t>(r)][x];
        }
        tell_doubt(around, value, static_cast<std::size_t>(r), static_cast<std::size_t>(((z + (r >> 1)) * 4 + y + (r & 1)) * 4), doubt);
      }
    }
  }
  return result;
}

}  // namespace isotouch::field
