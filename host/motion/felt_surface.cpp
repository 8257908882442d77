#include "host/motion/felt_surface.h"

#include <algorithm>
#include <cmath>

#include "firmware/core/field_sampler.h"
#include "host/to_double.h"

namespace isotouch::motion {

namespace {

constexpr double kMarchStep = 0.25;  // voxels: thinner things than this are not met, and no field holds them
constexpr int kHalvings = 20;
constexpr int kNewtonSteps = 12;
constexpr double kSamplerReach = 8191.0;  // voxels, see sample_field

}  // namespace

FeltSurface::FeltSurface(const FieldView& field) : field_(field), origin_(to_double(field.origin)), edge_(to_double(field.edge)) {
  const Eigen::Vector3d extent = edge_ * Eigen::Vector3d(field.size[0] - 1, field.size[1] - 1, field.size[2] - 1);
  centre_ = origin_ + extent / 2;
  radius_ = extent.norm() / 2;
}

FeltSample FeltSurface::sample(const Eigen::Vector3d& point) const {
  const Eigen::Vector3d index = (point - origin_) / edge_;
  const core::FieldSample s = core::sample_field(field_, to_fixed<Voxel>(index.cwiseMax(-kSamplerReach).cwiseMin(kSamplerReach)));
  const Eigen::Vector3d second = to_double(s.second);
  const Eigen::Vector3d mixed = to_double(s.mixed);
  return {to_double(s.distance) * edge_, to_double(s.gradient), std::sqrt(second.dot(second) + 2 * mixed.dot(mixed))};
}

std::optional<SurfacePoint> FeltSurface::first_hit(const Eigen::Vector3d& from, const Eigen::Vector3d& direction, double reach) const {
  double before = 0;
  double distance = sample(from).distance;
  for (double at = 0; at < reach;) {
    at += distance > edge_ ? distance / 2 : kMarchStep * edge_;  // half: the field is not everywhere a true distance
    const double next = sample(from + at * direction).distance;
    if (distance > 0 && next <= 0) {
      double outside = before;
      double inside = at;
      for (int i = 0; i < kHalvings; ++i) {
        const double middle = (outside + inside) / 2;
        (sample(from + middle * direction).distance > 0 ? outside : inside) = middle;
      }
      const Eigen::Vector3d position = from + inside * direction;
      const Eigen::Vector3d gradient = sample(position).gradient;
      if (gradient.norm() < 0.1) return std::nullopt;
      return SurfacePoint{position, gradient / gradient.norm()};
    }
    before = at;
    distance = next;
  }
  return std::nullopt;
}

double FeltSurface::way_out(const Eigen::Vector3d& from, const Eigen::Vector3d& direction, double reach) const {
  for (double at = kMarchStep * edge_; at < reach;) {
    const double distance = sample(from + at * direction).distance;
    if (distance > 0) return at;
    at += std::max(-distance / 2, kMarchStep * edge_);
  }
  return reach;
}

std::optional<SurfacePoint> FeltSurface::project(const Eigen::Vector3d& point) const {
  Eigen::Vector3d at = point;
  for (int i = 0; i < kNewtonSteps; ++i) {
    const FeltSample here = sample(at);
    const double square = here.gradient.squaredNorm();
    if (square < 0.01) return std::nullopt;
    if (std::abs(here.distance) < 0.001 * edge_) return SurfacePoint{at, here.gradient / std::sqrt(square)};
    at -= here.distance / std::max(square, 0.25) * here.gradient;
  }
  const FeltSample here = sample(at);
  const double norm = here.gradient.norm();
  if (norm < 0.1 || std::abs(here.distance) > 0.01 * edge_) return std::nullopt;
  return SurfacePoint{at, here.gradient / norm};
}

}  // namespace isotouch::motion
