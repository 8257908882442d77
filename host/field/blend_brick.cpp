#include "host/field/blend_brick.h"

#include <limits>
#include <utility>

#include "host/field/vector_lanes.h"

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
  Model result = BrickBlend::model_of(sample, model);
  result.inner = as_floats(balls.inner - sample);
  result.outer = as_floats(balls.outer - sample);
  result.inner_radius = static_cast<float>(balls.inner_radius - balls.slack);
  result.outer_radius = static_cast<float>(balls.outer_radius - balls.slack);
  return result;
}

}  // namespace

Model BrickBlend::model_of(const Eigen::Vector3d& sample, const LocalModel& model) {
  Model result{};
  for (std::size_t k = 0; k < model.count; ++k) result.pieces[k] = as_floats(model.pieces[k], sample);
  result.count = model.count;
  result.concave = model.concave;
  result.reach = model.reach > 0.0 ? static_cast<float>(model.reach) : std::numeric_limits<float>::max();
  result.trust = static_cast<float>(model.trust);
  return result;
}

BrickBlend::BrickBlend(std::vector<Eigen::Vector3d> positions, const std::vector<LocalModel>& models, const std::vector<EmptyBalls>& balls)
    : positions_(std::move(positions)) {
  models_.reserve(models.size());
  for (std::size_t i = 0; i < models.size(); ++i) models_.push_back(as_floats(positions_[i], models[i], balls[i]));
}

std::array<float, 64> BrickBlend::operator()(const Eigen::Vector3d& first, std::span<const Neighbour> candidates, Doubt& doubt) const {
  const Eigen::Vector3d middle = first + Eigen::Vector3d::Constant(1.5);
  thread_local std::vector<BlendCandidate> near;  // keeps its memory
  near.clear();
  for (const Neighbour& c : candidates) near.push_back({&models_[c.index], as_floats(positions_[c.index] - middle)});
  static const std::size_t lanes = vector_lanes();
  static const auto blend = lanes == 16 ? blend_by_sixteens : lanes == 8 ? blend_by_eights : blend_by_fours;
  return blend(near, doubt);
}

BrickReading blend_body(std::span<const BlendCandidate> candidates, float reach, float depth) {
  static const std::size_t lanes = vector_lanes();
  static const auto blend = lanes == 16 ? blend_body_by_sixteens : lanes == 8 ? blend_body_by_eights : blend_body_by_fours;
  return blend(candidates, reach, depth);
}

BrickReading nearest_distances(std::span<const BlendCandidate> candidates) {
  static const std::size_t lanes = vector_lanes();
  static const auto distances = lanes == 16  ? nearest_distances_by_sixteens
                                : lanes == 8 ? nearest_distances_by_eights
                                             : nearest_distances_by_fours;
  return distances(candidates);
}

}  // namespace isotouch::field
