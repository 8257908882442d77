#include "host/view/field_ray.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "firmware/core/field_sampler.h"

namespace isotouch::view {
namespace {

constexpr double kCrossing = 0.002;  // voxels: how well a crossing is found

template <class Q>
double to_double(Q quantity) {
  return std::ldexp(static_cast<double>(quantity.raw()), -Q::kFractionBits);
}

Vec3<Voxel> to_core(const Eigen::Vector3d& index) {
  const auto coordinate = [](double v) {
    return Voxel::from_raw(static_cast<std::int32_t>(std::lround(std::clamp(v, -8191.0, 8191.0) * 65536.0)));
  };
  return {coordinate(index.x()), coordinate(index.y()), coordinate(index.z())};
}

/// The part of a ray within a box; empty when enter > leave.
struct Span {
  double enter, leave;
};

Span clip(const Eigen::Vector3d& from, const Eigen::Vector3d& inverse, const Box& box, Span span) {
  for (int a = 0; a < 3; ++a) {
    const double t0 = (box.min()[a] - from[a]) * inverse[a], t1 = (box.max()[a] - from[a]) * inverse[a];
    span = {std::max(span.enter, std::min(t0, t1)), std::min(span.leave, std::max(t0, t1))};
  }
  return span;
}

/// One over each component; one that is zero counts as tiny, so that nothing becomes infinite.
Eigen::Vector3d inverse_of(const Eigen::Vector3d& direction) {
  return direction.unaryExpr([](double d) { return 1.0 / (std::fabs(d) > 1e-12 ? d : 1e-12); });
}

/// Index coordinates of the middle of every brick that is not wholly outside. A sum of positive coefficients is positive, so the surface lies
/// within 1 1/2 voxels of such a brick's samples.
std::vector<Eigen::Vector3d> object_bricks(const FieldView& field) {
  std::vector<Eigen::Vector3d> middles;
  constexpr int kBrickSide = 1 << image_layout::kBrickShift;
  for (int k = 0; k < field.size[2]; k += kBrickSide) {
    for (int j = 0; j < field.size[1]; j += kBrickSide) {
      for (int i = 0; i < field.size[0]; i += kBrickSide) {
        const std::span<const std::int16_t> brick(field.brick(i, j, k), image_layout::kSamplesPerBrick);
        if (*std::min_element(brick.begin(), brick.end()) <= 0) middles.emplace_back(i + 1.5, j + 1.5, k + 1.5);
      }
    }
  }
  return middles;
}

}  // namespace

FieldRays::FieldRays(const FieldView& field)
    : field_(field),
      origin_(to_double(field.origin.x), to_double(field.origin.y), to_double(field.origin.z)),
      edge_(to_double(field.edge)),
      band_(to_double(field.band)) {
  for (const Eigen::Vector3d& index : object_bricks(field)) {
    outline_.emplace_back(origin_ + edge_ * index);
    object_.extend(index);
  }
  const Eigen::Vector3d last(field.size[0] - 2, field.size[1] - 2, field.size[2] - 2);
  if (outline_.empty()) {  // nothing to see: then all of it
    outline_ = {origin_, origin_ + edge_ * last};
    object_ = {Eigen::Vector3d::Ones(), last};
  }
  constexpr double kReach = 1.5 + 1.5 + 0.01;  // from a brick's middle to its samples, from there to the surface
  object_ = {(object_.min().array() - kReach).max(1).matrix(), (object_.max().array() + kReach).min(last.array()).matrix()};
}

FieldRays::Value FieldRays::value(const Eigen::Vector3d& point) const {
  const core::FieldSample sample = core::sample_field(field_, to_core(to_index(point)));
  return {to_double(sample.distance),
          {to_double(sample.gradient.x), to_double(sample.gradient.y), to_double(sample.gradient.z)},
          sample.outside_grid};
}

double FieldRays::distance_at(const Eigen::Vector3d& index) const { return to_double(core::sample_field(field_, to_core(index)).distance); }

double FieldRays::empty_way(const Eigen::Vector3d& index, const Eigen::Vector3d& inverse) const {
  const Eigen::Array3i sample =
      (index.array() + 0.5).floor().cast<int>().max(0).min(Eigen::Array3i(field_.size[0] - 1, field_.size[1] - 1, field_.size[2] - 1));
  if (field_.brick(sample[0], sample[1], sample[2]) != field_.bricks) return 0;  // brick 0 is the one that is far outside
  const Eigen::Array3i node = sample / (1 << image_layout::kNodeShift);
  const bool whole_node = field_.root[(node[2] * field_.root_size[1] + node[1]) * field_.root_size[0] + node[0]] == image_layout::kOutside;
  const int side = 1 << (whole_node ? image_layout::kNodeShift : image_layout::kBrickShift);
  double way = std::numeric_limits<double>::max();
  for (int a = 0; a < 3; ++a) {
    const double low = (sample[a] & -side) - 0.5;
    way = std::min(way, ((inverse[a] > 0 ? low + side : low) - index[a]) * inverse[a]);
  }
  return std::max(way, 0.0) + 1e-3;
}

double FieldRays::crossing(const Ray& ray, Place outside, Place inside) const {
  // False position, with the Illinois trick: an end that stays twice counts half, so that both ends move.
  int stayed = 0;
  for (int step = 0; step < 12 && inside.t - outside.t > kCrossing; ++step) {
    const double t = outside.t + (inside.t - outside.t) * outside.distance / (outside.distance - inside.distance);
    const double distance = distance_at(ray.at(t));
    if (std::fabs(distance) < kCrossing) return t;
    if (distance > 0) {
      outside = {t, distance};
      if (stayed == 1) inside.distance /= 2;
      stayed = 1;
    } else {
      inside = {t, distance};
      if (stayed == -1) outside.distance /= 2;
      stayed = -1;
    }
  }
  return inside.t;
}

std::optional<double> FieldRays::hit(const Ray& ray, double from, double to) const {
  const Ray in_samples{to_index(ray.from), ray.direction};
  const Eigen::Vector3d inverse = inverse_of(ray.direction);
  const Span span = clip(in_samples.from, inverse, object_, {from / edge_, to / edge_});
  Place outside{span.enter, 0};  // the last place known to be outside
  for (double t = span.enter; t < span.leave;) {
    const Eigen::Vector3d here = in_samples.at(t);
    if (const double way = empty_way(here, inverse); way > 0) {
      outside = {t, band_};
      t += way;
      continue;
    }
    const double distance = distance_at(here);
    if (distance <= 0) return (t > span.enter ? crossing(in_samples, outside, {t, distance}) : t) * edge_;
    outside = {t, distance};
    t += std::max(0.8 * distance, 0.02);
  }
  return std::nullopt;
}

}  // namespace isotouch::view
