#include "host/evaluate/zero_surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "host/error.h"
#include "host/evaluate/node_distances.h"
#include "host/motion/felt_surface.h"
#include "tests/support/accuracy.h"
#include "tests/support/field_image.h"

namespace isotouch::evaluate {
namespace {

constexpr double kVoxel = 0.34;

double to_ball(const test::Point& p, const test::Point& centre, double radius) { return test::length(p - centre) - radius; }

const test::Point kMiddle = {30.2, 29.7, 30.4};

/// chord     how far the volume of the triangles, and their area, may be off the ball's
void expect_a_ball(const test::FieldOptions& options, double chord) {
  const test::FieldImage image(
      {61, 61, 61}, [](const test::Point& p) { return to_ball(p, kMiddle, 20); }, options);
  const cloud::TriangleMesh surface = zero_surface(image.view());
  ASSERT_NO_THROW(cloud::require_closed(surface, "ball"));
  const double area = 4 * std::numbers::pi * 20 * 20;
  EXPECT_GT(static_cast<double>(surface.vertices.size()) / area, 14);
  EXPECT_LT(static_cast<double>(surface.vertices.size()) / area, 22);
  const motion::FeltSurface felt(image.view());
  double worst = 0;
  for (const Eigen::Vector3d& vertex : surface.vertices) worst = std::max(worst, std::abs(felt.sample(vertex).distance) / kVoxel);
  EXPECT_THAT(worst, test::IsAccuracyOf(4e-5));

  const std::vector<Piece> found = pieces(surface);
  ASSERT_EQ(found.size(), 1U);
  const double exact = 4.0 / 3 * std::numbers::pi * std::pow(20 * kVoxel, 3);
  EXPECT_NEAR(volume(found) / exact, 1, chord);
  EXPECT_GT(std::abs(volume(found) / exact - 1), 1e-6) << "chords cannot be this good: what was measured?";
  EXPECT_NEAR(found[0].area / (area * kVoxel * kVoxel), 1, 2 * chord);
}

TEST(ZeroSurface, ABallIsOneClosedPieceOfItsVolumeWithEveryCornerOnTheSamplersZero) { expect_a_ball({}, 1e-3); }

TEST(ZeroSurface, SoIsATrilinearOne) { expect_a_ball({.prefilter = false, .interpolation = Interpolation::kTrilinear}, 2.5e-3); }

TEST(ZeroSurface, WhatIsHiddenInsideOrFarOutsideIsFound) {
  const test::FieldImage image({61, 61, 61}, [](const test::Point& p) {
    const double body = std::max(to_ball(p, kMiddle, 20), -to_ball(p, {33, 31, 28}, 3));
    return std::min(body, to_ball(p, {7, 8, 9}, 1.5));
  });
  const std::vector<Piece> found = pieces(zero_surface(image.view()));
  ASSERT_EQ(found.size(), 3U);
  EXPECT_GT(found[0].volume, 0);
  EXPECT_NEAR(found[1].volume / (-4.0 / 3 * std::numbers::pi * std::pow(3 * kVoxel, 3)), 1, 0.05);
  EXPECT_NEAR(found[2].volume / (4.0 / 3 * std::numbers::pi * std::pow(1.5 * kVoxel, 3)), 1, 0.2);
  const Eigen::Vector3d debris = kVoxel * Eigen::Vector3d(7, 8, 9) - Eigen::Vector3d::Constant(20);
  EXPECT_LT((found[2].place - debris).norm(), 2 * kVoxel);
}

TEST(ZeroSurface, AJumpBetweenFarInsideAndFarOutsideIsASurfaceToo) {
  const test::FieldImage image({48, 48, 48}, [](const test::Point& p) {
    const bool inside = p[0] > 15.5 && p[0] < 31.5 && p[1] > 15.5 && p[1] < 31.5 && p[2] > 15.5 && p[2] < 31.5;
    return inside ? -100.0 : 100.0;
  });
  const cloud::TriangleMesh surface = zero_surface(image.view());
  ASSERT_NO_THROW(cloud::require_closed(surface, "block"));
  EXPECT_NEAR(volume(pieces(surface)) / std::pow(16 * kVoxel, 3), 1, 0.02);
}

/// Faces with two corners at nearly one place, and faces without area.
std::size_t degenerate(const cloud::TriangleMesh& surface) {
  std::size_t found = 0;
  for (std::size_t face = 0; face < surface.faces.size(); ++face) {
    const auto& [a, b, c] = surface.faces[face];
    const Eigen::Vector3d &p = surface.vertices[a], &q = surface.vertices[b], &r = surface.vertices[c];
    const double shortest = std::min({(p - q).norm(), (q - r).norm(), (r - p).norm()});
    found += shortest < 5e-4 * kVoxel || cloud::face_normal(surface, face).norm() < 0.5 ? 1U : 0U;
  }
  return found;
}

TEST(ZeroSurface, CornersThatAreKeptApartShareNoPlaceAndAreHardlyMoved) {
  // Its walls lie exactly on lattice points.
  const test::FieldImage box({48, 48, 48}, [](const test::Point& p) {
    return std::max({std::abs(p[0] - 23) - 10, std::abs(p[1] - 23.5) - 10, std::abs(p[2] - 24) - 10});
  });
  EXPECT_GT(degenerate(zero_surface(box.view())), 100U) << "a test of nothing";
  const cloud::TriangleMesh apart = zero_surface(box.view(), Corners::kApart);
  EXPECT_EQ(degenerate(apart), 0U);
  ASSERT_NO_THROW(cloud::require_closed(apart, "box"));
  const motion::FeltSurface felt(box.view());
  double worst = 0;
  for (const Eigen::Vector3d& vertex : apart.vertices) worst = std::max(worst, std::abs(felt.sample(vertex).distance) / kVoxel);
  EXPECT_THAT(worst, test::IsAccuracyOf(0.0034));
}

TEST(ZeroSurface, NothingInsideIsNoSurface) {
  const test::FieldImage image({16, 16, 16}, [](const test::Point&) { return 4.0; });
  EXPECT_TRUE(zero_surface(image.view()).faces.empty());
  EXPECT_TRUE(pieces(zero_surface(image.view())).empty());
}

TEST(ZeroSurface, AFieldOfConstantBricksThatChangeSidesIsRefused) {
  const auto image = [](std::uint32_t size, int period) {
    return test::FieldImage(
        {size, size, size},
        [=](const test::Point& p) {
          int cells = 0;
          for (std::size_t axis = 0; axis < 3; ++axis) cells += static_cast<int>(p[axis]) / period;
          return cells % 2 == 0 ? 9 : -9;
        },
        test::trilinear_options());
  };
  const test::FieldImage few = image(48, 16), many = image(128, 4);
  EXPECT_GT(zero_surface(few.view()).faces.size(), 1000U);
  EXPECT_GT(node_distances(few.view()).bricks.size(), 100U);
  EXPECT_THROW((void)zero_surface(many.view()), InputError);
  EXPECT_THROW((void)node_distances(many.view()), InputError);
}

}  // namespace
}  // namespace isotouch::evaluate
