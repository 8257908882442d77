/// The touch, drawn into a scene of rays: a green ball at the proxy, a red ball at the HIP, a red line for the penetration.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "host/view/camera.h"
#include "host/view/image.h"

namespace isotouch::view {

/// One tick as it is shown.
struct Touch {
  Eigen::Vector3d proxy = Eigen::Vector3d::Zero();  ///< workspace, mm
  Eigen::Vector3d hip = Eigen::Vector3d::Zero();
  double force_n = 0;
  std::size_t tick = 0;
  double time_s = 0;

  double depth_mm() const { return (proxy - hip).norm(); }
};

inline constexpr std::uint32_t kProxyColour = 0x1F9D3A;
inline constexpr std::uint32_t kHipColour = 0xD3202A;

class Markers {
 public:
  /// radius    of the balls, mm; the line is a third as thick
  Markers(const Touch& touch, double radius) : touch_(touch), radius_(radius) {}

  struct Hit {
    double t;  ///< mm along the ray
    Eigen::Vector3d normal;
    Colour colour;
  };
  /// The marker that a ray meets first.
  std::optional<Hit> hit(const Ray& ray) const;

 private:
  Touch touch_;
  double radius_;
};

}  // namespace isotouch::view
