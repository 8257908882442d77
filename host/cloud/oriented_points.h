/// A scan: points with outward unit normals, and with a stiffness where it was measured.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace isotouch::cloud {

struct OrientedPoints {
  std::vector<Eigen::Vector3d> positions;  ///< in the file's units, or mm in the workspace after `Placement`
  std::vector<Eigen::Vector3d> normals;    ///< unit length, outward
  std::vector<double> stiffness = {};      ///< of the surface, N/mm, above 0 and at most 100; one for each position, or none at all

  std::size_t size() const { return positions.size(); }
  /// more      has a stiffness where these have one
  void append(const OrientedPoints& more) {
    const auto add = [](auto& to, const auto& from) { to.insert(to.end(), from.begin(), from.end()); };
    add(positions, more.positions);
    add(normals, more.normals);
    add(stiffness, more.stiffness);
  }
};

/// From the cloud's frame to the workspace: `workspace = scale * cloud + offset`. No rotation.
struct Placement {
  double scale = 1.0;                                ///< mm a cloud unit
  Eigen::Vector3d offset = Eigen::Vector3d::Zero();  ///< mm

  Eigen::Vector3d to_workspace(const Eigen::Vector3d& p) const { return scale * p + offset; }
  Eigen::Vector3d to_cloud(const Eigen::Vector3d& p) const { return (p - offset) / scale; }
};

}  // namespace isotouch::cloud
