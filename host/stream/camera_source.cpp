/// A simulated depth camera as a source.
#include <algorithm>
#include <cstdint>
#include <memory>

#include "host/cloud/scan_grid.h"
#include "host/stream/sources.h"

namespace isotouch::stream {

namespace {

/// What the camera saw, in the mesh's frame and with the normals of its image.
cloud::Model oriented(cloud::Model seen, const cloud::Placement& placement) {
  for (Eigen::Vector3d& position : seen.positions) position = placement.to_cloud(position);
  seen.sensor.place = placement.to_cloud(*seen.sensor.place);
  seen.grid->sensor = *seen.sensor.place;
  seen.edges = cloud::orient_by_grid(seen, *seen.grid);
  seen.grid.reset();
  return seen;
}

}  // namespace

Source depth_camera(const field::TriangleTree& tree, const cloud::Placement& placement, const evaluate::DepthCameraOptions& options) {
  return [&tree, placement, options](Inbox& inbox) {
    const evaluate::SimulatedDepthCamera camera(tree, options);
    const Clock::time_point begin = Clock::now();
    const auto due = [&](std::uint64_t number) {
      const std::chrono::duration<double> after(static_cast<double>(number) / options.frames_per_second);
      return begin + std::chrono::duration_cast<Clock::duration>(after);
    };
    for (std::uint64_t number = 0;;) {
      auto seen = std::make_shared<cloud::Model>(camera.frame(number).model);
      if (!inbox.wait_until(due(number))) return;
      if (!inbox.offer({number + 1, [seen, placement] { return oriented(std::move(*seen), placement); }, {}})) return;
      const std::uint64_t last = number++;
      while (due(number + 1) < Clock::now()) ++number;
      inbox.miss(number - last - 1);
    }
  };
}

}  // namespace isotouch::stream
