/// The known light under which everything is shown: a warm lamp above the viewer's left shoulder, a bright sky, a weak glow from the right.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "host/view/camera.h"
#include "host/view/image.h"

namespace isotouch::view {

class Light {
 public:
  explicit Light(const Camera& camera) : camera_(camera), lamp_(towards(-0.55, 0.75, 0.62)), glow_(towards(0.9, -0.1, 0.35)) {}

  /// Unit, from the object; `part` 0 to 3 names one of four places on the lamp's face, so that shadows have soft edges.
  Eigen::Vector3d lamp(int part) const {
    constexpr double kSize = 0.02;  // half the lamp's width seen from the object, radians
    const Eigen::Vector3d side = lamp_.unitOrthogonal(), other = lamp_.cross(side);
    return (lamp_ + kSize * ((part & 1) != 0 ? side : -side) + kSize * ((part & 2) != 0 ? other : -other)).normalized();
  }

  /// The light that leaves a matt, slightly glossy surface.
  ///
  /// normal, to_eye   unit
  /// lit              share of the lamp that is seen, 0 to 1
  /// open             share of the sky that is seen, 0 to 1
  Colour shade(Colour albedo, const Eigen::Vector3d& normal, const Eigen::Vector3d& to_eye, float lit = 1, float open = 1) const {
    const auto dot = [&](const Eigen::Vector3d& direction) { return static_cast<float>(std::max(0.0, normal.dot(direction))); };
    const auto upward = static_cast<float>(0.5 + 0.5 * normal.dot(camera_.up()));
    const Colour sky = mix(kGround, kSky, upward) * open;
    const Colour matt = albedo * (kLamp * (dot(lamp_) * lit) + kGlow * (dot(glow_) * open) + sky);
    const float gloss = std::pow(dot((lamp_ + to_eye).normalized()), 40.0F) * lit;
    const float rim = std::pow(1 - std::min(1.0F, dot(to_eye)), 4.0F) * upward * open;
    return matt + kLamp * (0.09F * gloss) + kSky * (0.10F * rim);
  }

 private:
  static constexpr Colour kLamp{0.78F, 0.74F, 0.68F};
  static constexpr Colour kSky{0.40F, 0.43F, 0.48F};
  static constexpr Colour kGround{0.15F, 0.14F, 0.13F};
  static constexpr Colour kGlow{0.10F, 0.12F, 0.16F};

  Eigen::Vector3d towards(double right, double up, double back) const {
    return (right * camera_.right() + up * camera_.up() + back * camera_.back()).normalized();
  }

  const Camera& camera_;
  Eigen::Vector3d lamp_, glow_;
};

/// What stands behind everything: nearly white, a little darker towards the bottom.
inline Colour backdrop(float height_share) { return mix(srgb(0xFBFCFD), srgb(0xDDE3EA), height_share * height_share); }

}  // namespace isotouch::view
