#include "host/field/roughness.h"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>
#include <cstddef>
#include <functional>
#include <utility>

#include "host/cloud/check.h"
#include "host/cloud/random.h"
#include "host/cloud/shapes.h"
#include "host/field/scan.h"
#include "tests/host/field/random_places.h"

namespace isotouch::field {
namespace {

using cloud::OrientedPoints;
using Eigen::Vector3d;

/// Thin rings and bolts: detail is finer than the spacing, so positions are rough without any noise.
OrientedPoints detailed() { return cloud::sample_shape(cloud::shape("hydrant"), 3756); }

Roughness of(OrientedPoints points, double spacing) { return roughness(Scan(std::move(points)), spacing); }

TEST(RoughnessHeavy, DetailAloneIsNoNoise) {
  const OrientedPoints points = detailed();
  const double spacing = cloud::median_spacing(points.positions);
  const Roughness found = of(points, spacing);
  EXPECT_GT(found.of_positions, 0.25 * spacing);
  EXPECT_LT(found.of_no_step, 0.01 * spacing);
  EXPECT_FALSE(found.is_noise());
}

TEST(Roughness, FindsNoiseBetweenDetail) {
  for (const double noise : {0.05, 0.1, 0.25}) {
    OrientedPoints points = detailed();
    const double spacing = cloud::median_spacing(points.positions);
    cloud::Random random(2);
    for (Vector3d& p : points.positions) p += noise * spacing * scatter(random);
    const Roughness found = of(std::move(points), spacing);
    EXPECT_NEAR(found.of_no_step, noise * spacing, 0.15 * noise * spacing) << noise;
    EXPECT_TRUE(found.is_noise()) << noise;
  }
}

/// A ball, each point off by what `height` gives, in spacings.
Roughness of_ball(const std::function<double(std::size_t)>& height) {
  OrientedPoints points = cloud::sample_shape(cloud::shape("sphere"), 4000);
  const double spacing = cloud::median_spacing(points.positions);
  for (std::size_t i = 0; i < points.size(); ++i) points.positions[i] += height(i) * spacing * points.normals[i];
  return of(std::move(points), spacing);
}

TEST(RoughnessHeavy, TellsTwoLayersFromNoise) {
  cloud::Random random(5);
  for (const double size : {0.1, 0.25, 0.5}) {
    EXPECT_LT(of_ball([&](std::size_t) { return size * scatter(random).x(); }).layered, 0.83) << size;
    EXPECT_LT(of_ball([&](std::size_t) { return size * random.uniform(-1, 1); }).layered, 0.85) << size;
    EXPECT_GT(of_ball([&](std::size_t) { return random.uniform() < 0.5 ? size : -size; }).layered, 0.87) << size;
  }
}

OrientedPoints tilted(OrientedPoints points, double tilt) {
  cloud::Random random(2);
  for (Vector3d& n : points.normals) n = (n + tilt * scatter(random)).normalized();
  return points;
}

/// exact      at most so much is found in the points as they are, radians
/// tolerance  of each tilt
void expect_tilts_are_found(const OrientedPoints& clean, double exact, double tolerance) {
  const double spacing = cloud::median_spacing(clean.positions);
  EXPECT_LT(of(clean, spacing).of_normals, exact);
  for (const double tilt : {0.1, 0.25, 0.4})
    EXPECT_NEAR(of(tilted(clean, tilt), spacing).of_normals, std::sqrt(2.0) * tilt, tolerance * tilt) << tilt;
}

TEST(Roughness, TiltedNormalsAreNoNoise) {
  for (const double tilt : {0.1, 0.25, 0.5}) {
    const OrientedPoints points = tilted(detailed(), tilt);
    const double spacing = cloud::median_spacing(points.positions);
    const Roughness found = of(points, spacing);
    EXPECT_GT(found.of_pairs, 0.02 * spacing) << tilt;
    EXPECT_LT(found.of_no_step, 0.3 * found.of_pairs) << tilt;
    EXPECT_FALSE(found.is_noise()) << tilt;
  }
}

TEST(Roughness, MeasuresTheNoiseOfNormalsBetweenDetail) { expect_tilts_are_found(detailed(), 0.02, 0.15); }

/// A rod's side with points at random places, six of them round it and all with exact normals: the far normals turn by no more than the near ones.
OrientedPoints thin_rod() {
  const double pi = std::acos(-1.0), length = 60;
  const auto count = static_cast<std::size_t>(36 * length / (2 * pi));
  OrientedPoints points;
  cloud::Random random(7);
  while (points.size() < count) {
    const double angle = random.uniform(-pi, pi), along = random.uniform(0, length);
    points.normals.emplace_back(std::cos(angle), std::sin(angle), 0);
    points.positions.push_back(points.normals.back() + along * Vector3d::UnitZ());
  }
  return points;
}

TEST(Roughness, NormalsThatTurnRoundAThinRodAreNoNoise) { expect_tilts_are_found(thin_rod(), 0.001, 0.4); }

}  // namespace
}  // namespace isotouch::field
