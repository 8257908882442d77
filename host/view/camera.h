/// From the workspace to the picture and back: a perspective camera with a long lens, as one photographs an object on a table.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <span>

#include "host/view/canvas.h"

namespace isotouch::view {

/// Where the eye is. Azimuth 0 looks at the object's front, positive ones walk to the right; elevation lifts the eye.
/// With y up (the device's axes) the front is seen from +z, with z up from -y, with x up from +z; x (or -y) then points to the right.
struct Direction {
  double azimuth_deg = 35;
  double elevation_deg = 20;
  char up = 'y';

  /// Unit vector from the object to the eye.
  Eigen::Vector3d towards_eye() const;
  Eigen::Vector3d up_axis() const;
};

using Box = Eigen::AlignedBox3d;

struct Ray {
  Eigen::Vector3d from;       ///< mm
  Eigen::Vector3d direction;  ///< unit

  Eigen::Vector3d at(double t) const { return from + t * direction; }
};

class Camera {
 public:
  /// The camera that sees all points, as large as they fit the area (pixels) and in its middle.
  ///
  /// towards_eye   unit, from the object to the eye
  /// up            points upwards on the picture; any direction when the eye looks along it
  /// points        workspace, mm; at least one
  Camera(const Eigen::Vector3d& towards_eye, const Eigen::Vector3d& up, std::span<const Eigen::Vector3d> points, const Rect& area);

  /// Through the point (x, y) of the picture.
  Ray ray(double x, double y) const;
  struct Projected {
    double x, y;          ///< pixels
    double distance;      ///< from the eye along its axis, mm; positive in front of it
    double pixel_per_mm;  ///< there
  };
  Projected project(const Eigen::Vector3d& point) const;

  /// Axes of the picture in the workspace, and from the object to the eye.
  const Eigen::Vector3d& right() const { return right_; }
  const Eigen::Vector3d& up() const { return up_; }
  const Eigen::Vector3d& back() const { return back_; }
  const Eigen::Vector3d& eye() const { return eye_; }

 private:
  Eigen::Vector3d right_, up_, back_, eye_;
  double centre_x_, centre_y_;
  double focus_;  ///< pixels: size on the picture of what is as far away as it is large
};

}  // namespace isotouch::view
