#include "host/field/invented_surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>

#include "host/cloud/shapes.h"
#include "host/field/scan_field.h"
#include "tests/support/sanitized.h"

namespace isotouch::field {
namespace {

using Eigen::Vector3d;

constexpr double kEdge = 1.6;

ScanField built(const char* shape, const std::function<bool(const Vector3d&)>& scanned, std::size_t points = 3000) {
  const cloud::OrientedPoints all = cloud::sample_shape(cloud::shape(shape), points);
  cloud::OrientedPoints part;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (!scanned(all.positions[i])) continue;
    part.positions.push_back(all.positions[i]);
    part.normals.push_back(all.normals[i]);
  }
  Progress progress;
  return scan_field(sound_scan(part), kEdge, kBand, progress);
}

Vector3d middle_of(const ScanField& field, const Eigen::Vector3i& cell) {
  return field.field.grid.position(4 * cell) + 1.5 * kEdge * Vector3d::Ones();
}

TEST(InventedSurface, AWholeScanHasNone) {
  for (const char* shape : test::examples<const char*>({"sphere", "torus", "box", "plate", "owl"})) {
    const ScanField field = built(shape, [](const Vector3d&) { return true; });
    EXPECT_EQ(field.invented.cells.size(), 0U) << shape;
    EXPECT_EQ(field.invented.share, 0) << shape;
  }
}

TEST(InventedSurface, IsTheBackOfAHalfSphere) {
  const ScanField field = built("sphere", [](const Vector3d& p) { return p.z() < 0; });
  ASSERT_GT(field.invented.cells.size(), 100U);
  for (const Eigen::Vector3i& cell : field.invented.cells) EXPECT_GT(middle_of(field, cell).z(), -17) << "two spacings and a brick";
  // A disc, and a wall of a tenth of the diameter, beside half a sphere: r² and 0.4 r² beside 2 r².
  EXPECT_NEAR(field.invented.share, 1.4 / 3.4, 0.04);
  EXPECT_EQ(field.verdict.invented_share, field.invented.share);
}

TEST(InventedSurface, IsTheCapOverAHole) {
  constexpr double kRadius = 80, kHole = 30;
  const Vector3d top(0, 0, kRadius);
  const ScanField field = built("sphere", [&](const Vector3d& p) { return (p - top).norm() > kHole; });
  ASSERT_GT(field.invented.cells.size(), 10U);
  std::size_t near = 0;
  for (const Eigen::Vector3i& cell : field.invented.cells) near += (middle_of(field, cell) - top).norm() < kHole ? 1U : 0U;
  EXPECT_GT(near + 2, field.invented.cells.size()) << "nothing beside the hole";
  const double cap = kHole * kHole / (4 * kRadius * kRadius);  // of the sphere: its area is that of a disc of the hole's radius
  EXPECT_LT(field.invented.share, cap);
  EXPECT_GT(field.invented.share, 0.15 * cap) << "a border as wide as the points are apart counts as scanned";
}

TEST(InventedSurface, CellsHoldTheSurface) {
  const ScanField field = built(
      "sphere", [](const Vector3d& p) { return p.z() < 0; }, 1500);
  for (const Eigen::Vector3i& cell : field.invented.cells) {
    const auto brick = std::find_if(field.field.bricks.begin(), field.field.bricks.end(), [&](const Brick& b) { return b.cell == cell; });
    ASSERT_NE(brick, field.field.bricks.end());
    EXPECT_TRUE(std::any_of(brick->distance.begin(), brick->distance.end(), [](float d) { return std::fabs(d) < 1.0F; }));
  }
}

}  // namespace
}  // namespace isotouch::field
