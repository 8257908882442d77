#include "host/evaluate/depth_camera.h"

#include <Eigen/Geometry>
#include <cmath>
#include <optional>
#include <vector>

#include "host/cloud/random.h"
#include "host/field/first_hit.h"
#include "host/field/parallel.h"
#include "host/motion/hand.h"

namespace isotouch::evaluate {

using Eigen::Vector3d;

namespace {

constexpr double kRises = 2.7;  // times a turn that the camera rises and sinks: no two turns see the same

/// Of the camera's axes in the mesh's frame: to the right, down, forward.
Eigen::Matrix3d looking_along(const Vector3d& forward) {
  Eigen::Matrix3d axes;
  axes.col(2) = forward;
  axes.col(0) = forward.cross(Vector3d::UnitZ()).normalized();
  axes.col(1) = forward.cross(axes.col(0));
  return axes;
}

/// Where in the picture a box may be seen, in pixels from its middle, and one more on each side; all of the picture where a corner is not in front.
///
/// camera    the box's frame
Eigen::AlignedBox2d seen_of(const field::TriangleTree::Box& box, const Vector3d& camera, const Eigen::Matrix3d& axes, double focal_pixels) {
  Eigen::AlignedBox2d seen;
  for (int n = 0; n < 8; ++n) {
    const Vector3d corner = Eigen::AlignedBox3d(box.low, box.high).corner(static_cast<Eigen::AlignedBox3d::CornerType>(n));
    const Vector3d at = axes.transpose() * (corner - camera);
    if (!(at.z() > 0)) return Eigen::AlignedBox2d(Eigen::Vector2d::Constant(-1e9), Eigen::Vector2d::Constant(1e9));
    seen.extend(Eigen::Vector2d(focal_pixels * at.head<2>() / at.z()));
  }
  return {seen.min() - Eigen::Vector2d::Ones(), seen.max() + Eigen::Vector2d::Ones()};
}

/// From the middle of the object to the camera, unit.
Vector3d place(double turns, double tilt) {
  const Vector3d round = Vector3d(motion::wave(turns), motion::wave(turns - 0.25), 0).normalized();
  return (round + tilt * motion::wave(kRises * turns) * Vector3d::UnitZ()).normalized();
}

}  // namespace

SimulatedDepthCamera::SimulatedDepthCamera(const field::TriangleTree& tree, const DepthCameraOptions& options)
    : tree_(tree), options_(options) {
  const auto& box = tree.box(field::TriangleTree::root());
  middle_ = (box.low + box.high) / 2;
}

DepthFrame SimulatedDepthCamera::frame(std::uint64_t number) const {
  const double seconds = static_cast<double>(number) / options_.frames_per_second;
  const Vector3d away = place(seconds / options_.turn_seconds, options_.tilt);
  const Vector3d camera = middle_ + options_.distance * away;
  const Eigen::Matrix3d axes = looking_along(-away);
  const Vector3d corner(static_cast<double>(options_.columns - 1) / 2, static_cast<double>(options_.rows - 1) / 2, 0);

  const Eigen::AlignedBox2d seen_at = seen_of(tree_.box(field::TriangleTree::root()), camera, axes, options_.focal_pixels);

  const std::size_t pixels = options_.columns * options_.rows;
  std::vector<Vector3d> rays(pixels);  // of depth 1
  std::vector<double> depths(pixels);  // mm; 0 = nothing returned
  field::in_parallel(pixels, options_.columns, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Vector3d pixel(static_cast<double>(i % options_.columns), static_cast<double>(i / options_.columns), 0);
      const Vector3d through = (pixel - corner) / options_.focal_pixels + Vector3d::UnitZ();
      rays[i] = axes * through;
      if (!seen_at.contains(Eigen::Vector2d((pixel - corner).head<2>()))) continue;
      const double length = rays[i].norm();
      const std::optional<field::FaceHit> hit = field::first_hit(tree_, camera, rays[i] / length);
      if (hit && !hit->from_inside && -hit->normal.dot(rays[i]) >= options_.least_cosine * length) depths[i] = hit->t / length;
    }
  });

  DepthFrame seen;
  seen.time_ns = static_cast<std::int64_t>(seconds * 1e9);
  seen.model.format = "simulated depth camera";
  seen.model.sensor.place = camera;
  seen.model.grid = cloud::ScanGrid{.columns = options_.columns, .cells = {}, .sensor = camera};
  cloud::Random random(options_.seed * 0x9E3779B97F4A7C15ULL + number);
  for (std::size_t i = 0; i < pixels; ++i) {
    const bool lost = random.uniform() < options_.dropouts;
    const double off = options_.noise > 0 ? options_.noise * random.gaussian() : 0.0;
    if (lost || depths[i] == 0) {
      seen.model.grid->cells.push_back(cloud::ScanGrid::kNoReturn);
      continue;
    }
    const double far = depths[i] / options_.distance;
    seen.model.grid->cells.push_back(static_cast<std::uint32_t>(seen.model.positions.size()));
    seen.model.positions.push_back(camera + (depths[i] + off * far * far) * rays[i]);
  }
  return seen;
}

}  // namespace isotouch::evaluate
