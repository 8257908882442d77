/// The touch, drawn into a scene of rays: a blue ball at the proxy, an orange cube at the HIP, a bar between them, and a dark arrow for the force.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "host/view/camera.h"
#include "host/view/canvas.h"
#include "host/view/image.h"

namespace isotouch::view {

/// One tick as it is shown.
struct Touch {
  Eigen::Vector3d proxy = Eigen::Vector3d::Zero();  ///< workspace, mm
  Eigen::Vector3d hip = Eigen::Vector3d::Zero();
  Eigen::Vector3d force = Eigen::Vector3d::Zero();  ///< on the hand, N
  std::size_t tick = 0;
  double time_s = 0;

  double depth_mm() const { return (proxy - hip).norm(); }
  /// Unit, from the HIP to the proxy.
  Eigen::Vector3d out() const { return (proxy - hip).normalized(); }
};

class Markers {
 public:
  /// radius    of the ball, mm; half of the cube's side
  /// arrow     its length, mm; it begins at the proxy. A force of zero has none
  Markers(const Touch& touch, double radius, double arrow);

  struct Hit {
    double t;  ///< mm along the ray
    Eigen::Vector3d normal;
    Colour colour;
  };
  /// The marker that a ray meets first.
  std::optional<Hit> hit(const Ray& ray) const;

 private:
  /// A cylinder, a cone, or what lies between; its ends are open.
  struct Bar {
    Eigen::Vector3d from, axis;  ///< unit
    double length, from_radius, to_radius;
    Colour colour;

    std::optional<Hit> hit(const Ray& ray) const;
  };

  Touch touch_;
  double radius_;
  std::vector<Bar> bars_;
};

/// The same signs flat, for slices and legends.
void draw_proxy(Canvas& canvas, Point at, float radius);
void draw_hip(Canvas& canvas, Point at, float radius);
void draw_force(Canvas& canvas, Point from, Point to, float width);

}  // namespace isotouch::view
