#include "host/cloud/depth_image.h"

#include <algorithm>
#include <cstddef>

#include "host/cloud/depth_png.h"

namespace isotouch::cloud {

Model read_depth_image(const std::string& name, std::span<const std::uint8_t> bytes, const DepthCamera& camera) {
  const DepthPixels pixels = read_depth_png(name, bytes);
  Model model;
  model.format = "PNG, 16-bit depth";
  model.sensor.place = Eigen::Vector3d::Zero();
  const std::size_t height = pixels.depth.size() / std::max<std::size_t>(pixels.width, 1);
  const auto is_within = [](double at, std::size_t count) { return at >= -0.5 && at <= static_cast<double>(count) - 0.5; };
  model.sensor.looks_past = !is_within(camera.cx, pixels.width) || !is_within(camera.cy, height);
  model.grid = ScanGrid{.columns = pixels.width};
  model.grid->cells.reserve(pixels.depth.size());
  for (std::size_t i = 0; i < pixels.depth.size(); ++i) {
    if (pixels.depth[i] == 0) {
      model.grid->cells.push_back(ScanGrid::kNoReturn);
      continue;
    }
    model.grid->cells.push_back(static_cast<std::uint32_t>(model.positions.size()));
    const double z = static_cast<double>(pixels.depth[i]) / camera.units_per_metre;
    const double u = static_cast<double>(i % pixels.width), v = static_cast<double>(i / pixels.width);
    model.positions.emplace_back((u - camera.cx) / camera.fx * z, (v - camera.cy) / camera.fy * z, z);
  }
  return model;
}

}  // namespace isotouch::cloud
