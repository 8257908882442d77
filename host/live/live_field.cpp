#include "host/live/live_field.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "host/encoding/lay_out_image.h"
#include "host/error.h"
#include "host/field/parallel.h"
#include "host/field/simd.h"
#include "host/live/brick_surroundings.h"
#include "host/live/brick_value.h"
#include "host/live/near_samples.h"
#include "host/live/sample_fit.h"

namespace isotouch::live {

namespace {

using encoding::BrickKind;

/// From the box of a brick's samples.
double squared_distance_to(const Node& node, std::size_t brick, const Eigen::Vector3d& place) {
  const Eigen::Array3d at = place.array() - first_place(node, brick).cast<double>().array();
  return (at - 4.0).max(-at).max(0.0).matrix().squaredNorm();
}

std::size_t brick_in_node(const Eigen::Vector3i& cell) {
  return static_cast<std::size_t>((cell.x() & 3) | (cell.y() & 3) << 2 | (cell.z() & 3) << 4);
}

}  // namespace

/// The changed samples of a batch, and what is dirty because of them.
struct LiveField::Dirt {
  struct Touched {
    Node* node;
    std::size_t brick;
    std::uint64_t key;
    bool existed;
  };
  std::vector<Touched> touched;
  /// Where a sample that changed was and where it is; where it came or went, one place.
  struct Change {
    Eigen::Vector3d before, after;
    bool two = false;
  };
  std::vector<Change> changes;
  struct Model {
    Node* node;
    std::size_t brick;
    Entry* entry;
    bool was_felt = false;  ///< where it is
  };
  std::vector<Model> models;          ///< to be fitted
  std::vector<Eigen::Vector3d> felt;  ///< places of samples that bricks depended on, or do now
};

LiveField::LiveField(const field::Grid& grid, double band, const encoding::FieldInfo& info)
    : grid_(grid), reach_(band), info_(info), nodes_(grid.size, static_cast<float>(reach_.influence() * reach_.influence())) {
  info_.method = Method::kDefault;
  info_.interpolation = Interpolation::kTrilinear;
  encoding::image_header(grid_, band, info_);  // it refuses what does not fit
}

void LiveField::take_point(const Point& point, bool removed, Dirt& dirt) {
  const std::uint64_t key = bucket_key(point);
  Eigen::Vector3i cell;
  for (std::size_t axis = 0; axis < 3; ++axis) cell[static_cast<Eigen::Index>(axis)] = point.position[axis] >> (kPositionBits + 2);
  Node& node = nodes_.make(cell.x() >> 2, cell.y() >> 2, cell.z() >> 2);
  const std::size_t brick = brick_in_node(cell);
  auto& entries = node.samples[brick];
  auto entry = std::find_if(entries.begin(), entries.end(), [key](const Entry& e) { return e.key == key; });
  if (entry == entries.end()) {
    if (removed) throw InputError("a point is to be removed that the live field does not hold");
    Entry added;
    added.key = key;
    if (free_.empty()) {
      added.slot = static_cast<std::uint32_t>(samples_.size());
      samples_.emplace_back();
    } else {
      added.slot = free_.back();
      free_.pop_back();
      Sample& old = samples_[added.slot];
      old.bucket = {};
      old.touched = old.unexplained = false;
    }
    added.live = &samples_[added.slot].live;
    entry = entries.insert(std::upper_bound(entries.begin(), entries.end(), key, [](std::uint64_t k, const Entry& e) { return k < e.key; }),
                           added);
    node.occupied |= NodeMask{1} << brick;
  }
  Sample& sample = samples_[entry->slot];
  if (!sample.touched) {
    sample.touched = true;
    dirt.touched.push_back({&node, brick, key, sample.bucket.count() > 0});
  }
  if (removed) {
    if (sample.bucket.count() == 0) throw InputError("a point is to be removed that the live field does not hold");
    sample.bucket.remove(point);
    source_hash_ -= hash_of(point);
    --verdict_.points;
  } else {
    sample.bucket.add(point);
    source_hash_ += hash_of(point);
    ++verdict_.points;
  }
}

/// Adds what a sample counts in the verdict, or takes it back.
void LiveField::count(const Entry& entry, bool present) {
  const auto change = [present](std::size_t& number) { number += present ? std::size_t{1} : ~std::size_t{0}; };
  change(verdict_.samples);
  verdict_.facing.add(entry.mean.position, entry.mean.normal, present);
  if (!entry.felt) change(verdict_.lonely);
  if (samples_[entry.slot].unexplained) change(verdict_.unexplained);
}

void LiveField::take_means(Dirt& dirt) {
  std::vector<const Dirt::Touched*> changed;
  for (const Dirt::Touched& touched : dirt.touched) {
    auto& entries = touched.node->samples[touched.brick];
    const auto entry = std::find_if(entries.begin(), entries.end(), [&](const Entry& e) { return e.key == touched.key; });
    Sample& sample = samples_[entry->slot];
    sample.touched = false;
    const bool stays = sample.bucket.count() > 0;
    const Mean mean = stays ? sample.bucket.mean() : Mean{};
    if (touched.existed && stays && mean == entry->mean) continue;
    const Eigen::Vector3d& before = touched.existed ? entry->mean.position : mean.position;
    dirt.changes.push_back({before, stays ? mean.position : before, touched.existed && stays});
    if (touched.existed) {
      if (entry->felt) dirt.felt.push_back(entry->mean.position);
      count(*entry, false);
    }
    if (stays) {
      entry->mean = mean;
      changed.push_back(&touched);
      continue;
    }
    free_.push_back(entry->slot);
    entries.erase(entry);
    if (entries.empty()) touched.node->occupied &= ~(NodeMask{1} << touched.brick);
  }
  // Entries do not move any more.
  for (const Dirt::Touched* touched : changed) {
    for (Entry& entry : touched->node->samples[touched->brick]) {
      if (entry.key != touched->key) continue;
      entry.dirty = true;
      entry.felt = false;
      dirt.models.push_back({touched->node, touched->brick, &entry});
    }
  }
}

/// The samples whose neighbours changed.
void LiveField::find_models(Dirt& dirt) {
  for (const auto& [before, after, two] : dirt.changes) {
    const Eigen::Array3d low = before.cwiseMin(after).array() - kModelReach, high = before.cwiseMax(after).array() + kModelReach;
    nodes_.occupied_in_box(low, high, [&, &was = before, &is = after, both = two](Node& node, std::size_t brick) {
      const double reached = node.model_influence[brick];
      if (squared_distance_to(node, brick, is) > reached && !(both && squared_distance_to(node, brick, was) <= reached)) return;
      for (Entry& entry : node.samples[brick]) {
        if (entry.dirty) continue;
        const auto is_near = [&entry](const Eigen::Vector3d& place) {
          return field::squared_distance(entry.mean.position, place) <= entry.influence;
        };
        if (!is_near(is) && !(both && is_near(was))) continue;
        entry.dirty = true;
        count(entry, false);
        if (entry.felt) dirt.felt.push_back(entry.mean.position);
        dirt.models.push_back({&node, brick, &entry, entry.felt});
        entry.felt = false;
      }
    });
  }
}

void LiveField::fit_models(Dirt& dirt) {
  field::in_parallel(dirt.models.size(), 16, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n) {
      Entry& entry = *dirt.models[n].entry;
      Sample& sample = samples_[entry.slot];
      const SampleFit fit = fit_sample(entry, nodes_, reach_, sample.live);
      entry.felt = fit.felt;
      entry.influence = fit.influence;
      sample.unexplained = fit.unexplained;
    }
  });
  for (const auto& [node, brick, entry, was_felt] : dirt.models) {
    double& largest = node->model_influence[brick];
    largest = std::max(largest, entry->influence);  // it may stay larger than it is: that costs time alone
    entry->dirty = false;
    count(*entry, true);
    if (entry->felt && !was_felt) dirt.felt.push_back(entry->mean.position);
  }
}

/// The bricks of a node that are not beyond their influence from a place.
static NodeMask reached(const Node& node, const Eigen::Vector3d& place) {
  using field::Four;
  const Eigen::Vector3f at = (place - middle_of(node, 0)).cast<float>();  // exact
  const Eigen::Vector3f outside = (at.array() - 12.0F).max(-at.array()).max(0.0F);
  if (squared(outside.x(), outside.y(), outside.z()) > node.largest_influence) return 0;
  const Four x = at.x() - Four{0.0F, 4.0F, 8.0F, 12.0F}, along_x = x * x;
  NodeMask mask = 0;
  for (std::size_t row = 0; row < 16; ++row) {
    const float y = at.y() - 4.0F * static_cast<float>(row & 3), z = at.z() - 4.0F * static_cast<float>(row >> 2);
    const Four square = (along_x + y * y) + z * z;
    mask |= NodeMask{field::true_lanes(square <= field::load(&node.influence[4 * row]))} << (4 * row);
  }
  return mask;
}

/// Marks the bricks whose values may depend on one of these places.
void LiveField::find_bricks(const Dirt& dirt) {
  for (const Eigen::Vector3d& place : dirt.felt) {
    const Eigen::Vector3i low = ((place.array() - reach_.influence()) / 16.0).floor().cast<int>().cwiseMax(0);
    const Eigen::Vector3i high = ((place.array() + reach_.influence()) / 16.0).floor().cast<int>().min(nodes_.size().array() - 1);
    for (int z = low.z(); z <= high.z(); ++z) {
      for (int y = low.y(); y <= high.y(); ++y) {
        for (int x = low.x(); x <= high.x(); ++x) {
          Node& node = nodes_.make(x, y, z);
          if (node.dirty != ~NodeMask{0}) node.dirty |= reached(node, place);
        }
      }
    }
  }
}

Work LiveField::compute_bricks() {
  std::vector<Node*> dirty;
  for (Node* node : nodes_.all()) {
    if (node->dirty != 0) dirty.push_back(node);
  }
  std::vector<NodeMask> changed(dirty.size());
  std::vector<std::size_t> computed(dirty.size());
  field::in_parallel(dirty.size(), 1, [&](std::size_t begin, std::size_t end) {
    thread_local NearSamples near;  // keeps its memory
    std::vector<encoding::Coefficients> bricks;
    for (std::size_t n = begin; n < end; ++n) {
      Node& node = *dirty[n];
      near.gather(node, node.dirty, nodes_, reach_);
      bricks.clear();
      NodeMask stored = 0, inside = 0;
      for (std::size_t brick = 0; brick < 64; ++brick) {
        const NodeMask bit = NodeMask{1} << brick;
        const bool was_stored = (node.stored & bit) != 0, was_inside = (node.inside & bit) != 0;
        if ((node.dirty & bit) == 0) {
          if (was_stored) bricks.push_back(node.values(brick));
          stored |= node.stored & bit;
          inside |= node.inside & bit;
          continue;
        }
        ++computed[n];
        near.choose(brick, 1.2F * node.influence[brick]);
        const BrickValue value = brick_value(first_place(node, brick), grid_.size, reach_, near);
        node.influence[brick] = value.influence;
        const bool is_stored = value.kind == BrickKind::kStored, is_inside = value.kind == BrickKind::kInside;
        if (is_stored != was_stored || is_inside != was_inside || (is_stored && value.values != node.values(brick))) changed[n] |= bit;
        if (is_stored) bricks.push_back(value.values), stored |= bit;
        if (is_inside) inside |= bit;
      }
      node.dirty = 0;
      node.largest_influence = *std::max_element(node.influence.begin(), node.influence.end());
      if (changed[n] == 0) continue;
      node.bricks.assign(bricks.begin(), bricks.end());
      node.stored = stored;
      node.inside = inside;
    }
  });
  Work work;
  for (std::size_t n = 0; n < dirty.size(); ++n) {
    work.bricks += computed[n];
    work.changed += static_cast<std::size_t>(std::popcount(changed[n]));
    if (changed[n] != 0) mark_around(*dirty[n], changed[n], nodes_);
  }
  return work;
}

Work LiveField::apply(const Batch& batch) {
  Dirt dirt;
  for (const Point& point : batch.added) take_point(point, false, dirt);
  for (const Point& point : batch.removed) take_point(point, true, dirt);
  take_means(dirt);
  find_models(dirt);
  fit_models(dirt);
  find_bricks(dirt);
  Work work = compute_bricks();
  certify();
  work.samples = dirt.touched.size();
  work.models = dirt.models.size();
  return work;
}

}  // namespace isotouch::live
