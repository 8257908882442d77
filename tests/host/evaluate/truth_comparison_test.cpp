#include "host/evaluate/truth_comparison.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "host/error.h"
#include "tests/support/field_image.h"
#include "tests/support/sanitized.h"

namespace isotouch::evaluate {
namespace {

constexpr double kVoxel = 0.34;
constexpr double kRadius = 12;

double to_ball(const test::Point& p, const test::Point& centre, double radius) { return test::length(p - centre) - radius; }

const test::Point kMiddle = {22.2, 21.7, 22.4};

test::FieldImage image_of(const test::DistanceFunction& distance) { return {{45, 45, 45}, distance}; }

/// The mesh of a ball of kRadius, from a field of its own.
const cloud::TriangleMesh& ball() {
  static const cloud::TriangleMesh mesh = zero_surface(image_of([](const test::Point& p) { return to_ball(p, kMiddle, kRadius); }).view());
  return mesh;
}

TruthComparison compare(const test::DistanceFunction& distance) {
  const test::FieldImage image = image_of(distance);
  return compare_surfaces(image.view(), zero_surface(image.view()), true_surface(ball()));
}

Eigen::Vector3d workspace(const test::Point& p) { return kVoxel * Eigen::Vector3d(p[0], p[1], p[2]) - Eigen::Vector3d::Constant(20); }

TEST(TruthComparison, ASurfaceIsNowhereAwayFromItself) {
  const TruthComparison found = compare([](const test::Point& p) { return to_ball(p, kMiddle, kRadius); });
  EXPECT_LT(found.hausdorff_voxel(), 1e-9);
  EXPECT_LT(found.wrong_side_pct, 1e-9);
  EXPECT_NEAR(found.volume_ratio, 1, 1e-12);
  EXPECT_EQ(found.pieces.size(), 1U);
}

TEST(TruthComparison, AKnownSkinIsMeasuredOnBothSides) {
  for (const double skin : test::examples<double>({-1.5, 0.25})) {
    const TruthComparison found = compare([&](const test::Point& p) { return to_ball(p, kMiddle, kRadius + skin); });
    EXPECT_NEAR(found.from_mesh_voxel(), std::abs(skin), 0.01);
    EXPECT_NEAR(found.from_field_voxel(), std::abs(skin), 0.01);
    EXPECT_NEAR(found.mesh_to_field.rms_voxel, std::abs(skin), 0.01);
    EXPECT_NEAR(found.field_to_mesh.rms_voxel, std::abs(skin), 0.01);
    const double share = 100 * (std::pow(1 + skin / kRadius, 3) - 1);
    EXPECT_NEAR(found.wrong_side_pct, std::abs(share), 0.01 * std::abs(share));
    EXPECT_NEAR(found.too_much_pct, std::max(0.0, share), 0.01 * std::abs(share));
    EXPECT_NEAR(found.volume_ratio, 1 + share / 100, 1e-3);
  }
}

TEST(TruthComparison, DebrisIsFoundFromTheFieldAndAMissingPartFromTheMesh) {
  const test::Point far = {7, 8, 9};
  const TruthComparison debris =
      compare([&](const test::Point& p) { return std::min(to_ball(p, kMiddle, kRadius), to_ball(p, far, 1.5)); });
  const double reach = test::length(far - kMiddle) + 1.5 - kRadius;
  EXPECT_NEAR(debris.from_field_voxel(), reach, 0.1);
  EXPECT_GE(debris.hausdorff_at_most_voxel(), reach);
  EXPECT_LT(debris.hausdorff_at_most_voxel(), reach + kFineness);
  EXPECT_LT((debris.from_field.place - workspace(far)).norm(), 2 * kVoxel);
  EXPECT_LT(debris.from_mesh_voxel(), 0.01);
  EXPECT_EQ(debris.pieces.size(), 2U);
  EXPECT_NEAR(static_cast<double>(debris.field_to_mesh.far), kSpreadPoints * 1.5 * 1.5 / (kRadius * kRadius + 1.5 * 1.5), 60);
  EXPECT_EQ(debris.mesh_to_field.far, 0U);

  const TruthComparison cut = compare([&](const test::Point& p) { return std::max(to_ball(p, kMiddle, kRadius), p[0] - kMiddle[0] - 4); });
  EXPECT_NEAR(cut.from_mesh_voxel(), 8, 0.1);
  EXPECT_LT((cut.from_mesh.place - workspace(kMiddle + test::Point{kRadius, 0, 0})).norm(), 0.5 * kVoxel);
  const double cap = 8.0 * 8 * (3 * kRadius - 8) / (4 * std::pow(kRadius, 3));
  EXPECT_NEAR(cut.wrong_side_pct, 100 * cap, 1);
  EXPECT_LT(cut.too_much_pct, 0.05);  // the edge of the cut rings a little
}

TEST(TruthComparison, AFlippedInteriorCannotHide) {
  const TruthComparison found = compare([](const test::Point& p) {
    const double ball = to_ball(p, kMiddle, kRadius);
    return ball < -6 ? 100.0 : ball;
  });
  EXPECT_NEAR(found.wrong_side_pct, 100 * std::pow(6 / kRadius, 3), 2);
  EXPECT_NEAR(found.from_field_voxel(), 6, 0.9);
  EXPECT_EQ(found.pieces.size(), 2U);
  EXPECT_LT(found.pieces[1].volume, 0);
  EXPECT_NEAR(found.volume_ratio, 1 - std::pow(6 / kRadius, 3), 0.02);
}

TEST(TruthComparison, FacesInsideTheUnionAreNoTruth) {
  // A smaller ball within, and the same one again: the union is the ball.
  cloud::TriangleMesh mesh = ball();
  for (const double share : {0.5, 1.0}) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    const Eigen::Vector3d middle = workspace(kMiddle);
    for (const Eigen::Vector3d& vertex : ball().vertices) mesh.vertices.emplace_back(middle + share * (vertex - middle));
    for (const auto& [a, b, c] : ball().faces) mesh.faces.push_back({a + first, b + first, c + first});
  }
  const test::FieldImage image = image_of([](const test::Point& p) { return to_ball(p, kMiddle, kRadius); });
  const TruthComparison found = compare_surfaces(image.view(), zero_surface(image.view()), true_surface(mesh));
  EXPECT_LT(found.hausdorff_voxel(), 1e-9);
  EXPECT_EQ(found.mesh_to_field.far, 0U);
  EXPECT_LT(found.wrong_side_pct, 1e-9);
  EXPECT_NEAR(found.volume_ratio, 1, 1e-3);
}

TEST(TruthComparison, AFieldWithoutASurfaceIsRefused) {
  EXPECT_THROW(compare([](const test::Point&) { return 4.0; }), InputError);
}

}  // namespace
}  // namespace isotouch::evaluate
