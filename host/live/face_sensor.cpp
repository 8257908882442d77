#include "host/live/face_sensor.h"

#include <cstddef>

namespace isotouch::live {

void face_sensor(const SensorPlace& sensor, std::span<const Eigen::Vector3d> positions, std::span<Eigen::Vector3d> normals) {
  const auto& place = sensor.given || !sensor.of_image ? sensor.given : sensor.stated;
  if (!place) return;
  for (std::size_t i = 0; i < normals.size(); ++i) {
    if (normals[i].dot(*place - positions[i]) < 0.0) normals[i] = -normals[i];
  }
}

}  // namespace isotouch::live
