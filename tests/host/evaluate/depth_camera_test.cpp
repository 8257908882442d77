#include "host/evaluate/depth_camera.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "host/cloud/scan_grid.h"
#include "host/evaluate/zero_surface.h"
#include "host/field/parallel.h"
#include "tests/support/field_image.h"

namespace isotouch::evaluate {
namespace {

using Eigen::Vector3d;

constexpr double kRadius = 18;

/// A ball, and where its middle is.
const cloud::TriangleMesh& ball() {
  static const cloud::TriangleMesh mesh = zero_surface(test::FieldImage({56, 56, 56}, [](const test::Point& p) {
                                                         return test::length(p - test::Point{27, 27, 27}) - kRadius;
                                                       }).view());
  return mesh;
}

struct Scene {
  field::TriangleTree tree{ball()};
  Vector3d middle = (tree.box(tree.root()).low + tree.box(tree.root()).high) / 2;
  double radius = (tree.box(tree.root()).high - tree.box(tree.root()).low).x() / 2;
};

constexpr double kNear = 40;  // mm

TEST(DepthCamera, ReturnsTheSideThatFacesIt) {
  const Scene scene;
  const SimulatedDepthCamera camera(scene.tree, {.distance = kNear});
  for (const std::uint64_t number : {0U, 151U, 407U}) {
    const DepthFrame frame = camera.frame(number);
    const Vector3d at = *frame.model.sensor.place;
    ASSERT_NEAR((at - scene.middle).norm(), kNear, 1e-9);
    ASSERT_EQ(frame.model.grid->cells.size(), 160U * 120U);
    // How many pixels a ball of this size covers, less the rim that is too flat.
    const double across = 180 * scene.radius / std::sqrt(kNear * kNear - scene.radius * scene.radius), all = 3.1416 * across * across;
    EXPECT_GT(all, 1500);
    EXPECT_NEAR(static_cast<double>(frame.model.positions.size()), 0.95 * all, 0.03 * all);
    for (const Vector3d& p : frame.model.positions) {
      ASSERT_NEAR((p - scene.middle).norm(), scene.radius, 0.02 * scene.radius);
      ASSERT_GT((at - p).normalized().dot((p - scene.middle).normalized()), 0.1) << "it sees the back";
    }
  }
}

TEST(DepthCamera, ItsGridGivesNormals) {
  const Scene scene;
  DepthFrame frame = SimulatedDepthCamera(scene.tree, {.columns = 320, .rows = 240, .focal_pixels = 700, .distance = 2 * kNear}).frame(40);
  cloud::Model model = frame.model;
  const auto left_out = cloud::orient_by_grid(model, *frame.model.grid);
  ASSERT_TRUE(left_out.has_value());
  EXPECT_LT(*left_out, frame.model.positions.size() / 10);
  for (std::size_t i = 0; i < model.positions.size(); ++i)
    ASSERT_GT(model.normals[i].dot((model.positions[i] - scene.middle).normalized()), 0.97);
}

TEST(DepthCamera, SeesAllSidesInOneTurn) {
  const Scene scene;
  const SimulatedDepthCamera camera(scene.tree, {.distance = kNear, .turn_seconds = 2});
  std::vector<int> octants(8);
  for (std::uint64_t number = 0; number < 60; number += 3) {
    for (const Vector3d& p : camera.frame(number).model.positions) {
      const Vector3d from = p - scene.middle;
      ++octants[static_cast<std::size_t>((from.x() > 0 ? 1 : 0) + (from.y() > 0 ? 2 : 0) + (from.z() > 0 ? 4 : 0))];
    }
  }
  EXPECT_GT(*std::min_element(octants.begin(), octants.end()), 500);
}

TEST(DepthCamera, NoiseAndDropoutsAreAsLargeAsAskedFor) {
  const Scene scene;
  DepthCameraOptions options;
  options.distance = kNear;
  const DepthFrame clean = SimulatedDepthCamera(scene.tree, options).frame(5);
  options.noise = 0.4;
  options.dropouts = 0.25;
  const DepthFrame dirty = SimulatedDepthCamera(scene.tree, options).frame(5);
  const double seen = static_cast<double>(clean.model.positions.size());
  EXPECT_NEAR(static_cast<double>(dirty.model.positions.size()), 0.75 * seen, 4 * std::sqrt(0.25 * 0.75 * seen));
  double squares = 0, shift = 0;
  std::size_t both = 0;
  const Vector3d at = *clean.model.sensor.place;
  for (std::size_t cell = 0; cell < clean.model.grid->cells.size(); ++cell) {
    const std::uint32_t a = clean.model.grid->cells[cell], b = dirty.model.grid->cells[cell];
    ASSERT_FALSE(a == cloud::ScanGrid::kNoReturn && b != cloud::ScanGrid::kNoReturn);
    if (b == cloud::ScanGrid::kNoReturn) continue;
    const double far = (clean.model.positions[a] - at).norm(), share = far / kNear;
    const double off = ((dirty.model.positions[b] - at).norm() - far) / (share * share);
    squares += off * off, shift += off, ++both;
  }
  ASSERT_GT(both, 500U);
  EXPECT_NEAR(std::sqrt(squares / static_cast<double>(both)), 0.4, 0.06);
  EXPECT_NEAR(shift / static_cast<double>(both), 0, 0.05);
}

TEST(DepthCamera, AFrameIsTheSameWithAnyNumberOfThreadsAndOthersDiffer) {
  const Scene scene;
  DepthCameraOptions options;
  options.noise = 0.2;
  const auto positions = [&](std::uint64_t seed, std::uint64_t number, unsigned threads) {
    const field::ThreadLimit limit(threads);
    options.seed = seed;
    return SimulatedDepthCamera(scene.tree, options).frame(number).model.positions;
  };
  EXPECT_EQ(positions(1, 7, 1), positions(1, 7, 7));
  EXPECT_NE(positions(1, 7, 1), positions(2, 7, 1));
  EXPECT_NE(positions(1, 7, 1), positions(1, 8, 1));
}

TEST(DepthCamera, ATimeIsThatOfItsFrame) {
  const Scene scene;
  EXPECT_EQ(SimulatedDepthCamera(scene.tree, {}).frame(45).time_ns, 1'500'000'000);
}

}  // namespace
}  // namespace isotouch::evaluate
