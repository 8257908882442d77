/// A depth camera that goes round an object, simulated: what a scan program hands on while a person scans.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>

#include "host/cloud/model.h"
#include "host/field/triangle_tree.h"

namespace isotouch::evaluate {

struct DepthCameraOptions {
  std::size_t columns = 160, rows = 120;  ///< pixels; at least 2 each
  double focal_pixels = 180;              ///< focal length, the same along both axes; the principal point is the picture's middle
  double distance = 200;                  ///< mm, of the camera from the middle of the object's box
  double frames_per_second = 30;
  double turn_seconds = 20;     ///< once round the object
  double tilt = 0.6;            ///< how far it rises and sinks: the largest height over the distance from the axis
  double noise = 0;             ///< mm, standard deviation of a depth at `distance`; it grows with the square of the depth
  double dropouts = 0;          ///< share of the pixels that return nothing, at random
  double least_cosine = 0.174;  ///< of the angle between view and normal: flatter surfaces return nothing. 80 degrees
  std::uint64_t seed = 1;
};

struct DepthFrame {
  std::int64_t time_ns = 0;  ///< since the first frame
  cloud::Model model;        ///< in the mesh's frame, mm, without normals, with its grid and the camera's place; may hold no point
};

class SimulatedDepthCamera {
 public:
  /// tree      closed, mm; stays alive and unchanged
  SimulatedDepthCamera(const field::TriangleTree& tree, const DepthCameraOptions& options);

  /// What the camera sees in a frame.
  ///
  /// number    from 0
  /// returns   the same for a seed and a number on every machine: + − × ÷ and square roots only
  DepthFrame frame(std::uint64_t number) const;

 private:
  const field::TriangleTree& tree_;
  DepthCameraOptions options_;
  Eigen::Vector3d middle_;
};

}  // namespace isotouch::evaluate
