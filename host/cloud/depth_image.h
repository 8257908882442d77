/// A depth camera's image → points in front of the camera.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "host/cloud/model.h"

namespace isotouch::cloud {

/// A pinhole camera without distortion. Pixel (u, v) of depth d, counted from the middle of the top left one, is the point
/// (u - cx, v - cy, 1) ⊙ (1 / fx, 1 / fy, 1) · d / units_per_metre: x to the right, y down, z forward, as in TUM's RGB-D data and in Open3D.
struct DepthCamera {
  double fx = 0, fy = 0;          ///< focal lengths, pixels; above 0
  double cx = 0, cy = 0;          ///< principal point, pixels
  double units_per_metre = 1000;  ///< of the stored depth; above 0
};

/// returns   the points in metres, with their grid and the camera in the origin. A depth of 0 means that nothing returned;
///           there may be no points, if the camera looked into emptiness or at its own lid
/// fails     InputError: as `read_depth_png`
Model read_depth_image(const std::string& name, std::span<const std::uint8_t> bytes, const DepthCamera& camera);

}  // namespace isotouch::cloud
