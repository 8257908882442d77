/// Random histories of a live field: points of an object come in clusters and scattered, expire, move and turn, and the box may cut the object.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <utility>
#include <vector>

#include "host/cloud/random.h"
#include "host/cloud/shapes.h"
#include "host/field/make_grid.h"
#include "host/live/live_field.h"

namespace isotouch::test {

class RandomBatches {
 public:
  /// shape     an object; its points are scaled to `voxels` along its longest side
  RandomBatches(const cloud::Shape& shape, int voxels, std::uint64_t seed) : random_(seed), source_(points_of(shape, seed)) {
    const double side = (shape.high - shape.low).maxCoeff();
    const bool cut = random_.uniform() < 0.2;  // by the box
    const Eigen::Vector3d middle = (shape.low + shape.high) / 2, half = (cut ? 0.35 : 0.55) * (shape.high - shape.low);
    grid_ = field::make_grid(middle - half, middle + half, side / voxels, 8);
    noise_ = random_.uniform() < 0.5 ? 0.0 : 0.5 * grid_.edge;
  }

  const field::Grid& grid() const { return grid_; }
  const std::deque<live::Point>& present() const { return present_; }

  /// The next batch; `present` is then what it leads to.
  live::Batch next() {
    live::Batch batch;
    const std::size_t parts = 1 + below(3);
    for (std::size_t part = 0; part < parts; ++part) {
      switch (random_.bits() % 6) {
        case 0: add(below(200), false, batch); break;
        case 1:
        case 2: add(below(400), true, batch); break;
        case 3: expire(below(300), batch); break;
        case 4: move(below(60), batch); break;
        default: random_.uniform() < 0.1 ? expire(present_.size(), batch) : add(below(20), true, batch); break;
      }
    }
    return batch;
  }

  /// All that are present, in a random order.
  live::Batch whole() {
    live::Batch batch;
    batch.added.assign(present_.begin(), present_.end());
    for (std::size_t n = batch.added.size(); n > 1; --n) std::swap(batch.added[n - 1], batch.added[below(n)]);
    return batch;
  }

 private:
  static cloud::OrientedPoints points_of(const cloud::Shape& shape, std::uint64_t seed) {
    return cloud::scatter_on_shape(shape, static_cast<std::size_t>(200 + 300 * (seed % 8)), seed);
  }

  std::size_t below(std::size_t limit) { return static_cast<std::size_t>(random_.bits() % limit); }

  Eigen::Vector3d off(double most) {
    Eigen::Vector3d step;
    for (double& x : step) x = random_.uniform(-most, most);
    return step;
  }

  void put(const Eigen::Vector3d& position, const Eigen::Vector3d& normal, live::Batch& batch) {
    const auto point = live::point_in(grid_, position, normal);
    if (!point) return;
    batch.added.push_back(*point);
    present_.push_back(*point);
  }

  void add(std::size_t count, bool clustered, live::Batch& batch) {
    const Eigen::Vector3d middle = source_.positions[below(source_.size())];
    const double radius = (2.0 + 8.0 * random_.uniform()) * grid_.edge;
    const double turned = random_.uniform() < 0.1 ? 0.5 : 0.0;
    for (std::size_t tries = 0; count > 0 && tries < 20 * source_.size(); ++tries) {
      const std::size_t i = below(source_.size());
      if (clustered && (source_.positions[i] - middle).norm() > radius) continue;
      --count;
      // One after the other: arguments of one call would come in the compiler's order.
      Eigen::Vector3d normal = source_.normals[i] + off(0.2);
      if (random_.uniform() < turned) normal = -normal;
      const Eigen::Vector3d position = source_.positions[i] + off(noise_ + 1e-9);
      put(position, normal, batch);
    }
  }

  /// The oldest go.
  void expire(std::size_t count, live::Batch& batch) {
    for (; count > 0 && !present_.empty(); --count) {
      batch.removed.push_back(present_.front());
      present_.pop_front();
    }
  }

  /// Some go elsewhere, and become the newest.
  void move(std::size_t count, live::Batch& batch) {
    const Eigen::Vector3d way = off(2.0 * grid_.edge);
    for (; count > 0 && !present_.empty(); --count) {
      const auto at = present_.begin() + static_cast<std::ptrdiff_t>(below(present_.size()));
      const live::Point old = *at;
      present_.erase(at);
      batch.removed.push_back(old);
      Eigen::Vector3d position, normal;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        position[static_cast<Eigen::Index>(axis)] = std::ldexp(old.position[axis], -live::kPositionBits);
        normal[static_cast<Eigen::Index>(axis)] = old.normal[axis];
      }
      put(grid_.origin + grid_.edge * position + way, normal, batch);
    }
  }

  cloud::Random random_;
  cloud::OrientedPoints source_;
  field::Grid grid_;
  double noise_ = 0.0;
  std::deque<live::Point> present_;
};

}  // namespace isotouch::test
