/// Which side of a live field's points is outside, where a sensor's place tells it.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>

namespace isotouch::live {

/// Where the sensor stood, input coordinates.
struct SensorPlace {
  std::optional<Eigen::Vector3d> given = {};  ///< by a person: it counts for every normal
  std::optional<Eigen::Vector3d> stated =
      {};                 ///< by the file: it counts for normals that come from its image, which leaves their side open
  bool of_image = false;  ///< they do
};

/// Turns each normal to the sensor's side; none where its place does not count.
///
/// positions input coordinates
/// normals   of any length, one for each position, or none at all
void face_sensor(const SensorPlace& sensor, std::span<const Eigen::Vector3d> positions, std::span<Eigen::Vector3d> normals);

}  // namespace isotouch::live
