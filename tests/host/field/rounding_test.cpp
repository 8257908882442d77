#include "host/field/rounding.h"

#include <gtest/gtest.h>

#include <cmath>

#include "host/cloud/shapes.h"

namespace isotouch::field {
namespace {

using Eigen::Vector3d;

std::vector<Vector3d> owl(double step) {
  std::vector<Vector3d> positions = cloud::sample_shape(cloud::shape("owl"), 4000).positions;
  for (Vector3d& p : positions) p = step * (p / step).array().round().matrix();
  return positions;
}

TEST(Rounding, StepsAreFound) {
  EXPECT_NEAR(rounding_step(owl(2.0)), 2.0, 1e-9);
  EXPECT_NEAR(rounding_step(owl(0.7)), 0.7, 1e-9) << "sums of decimals are not exact";
  std::vector<Vector3d> far_away = owl(1.0);
  for (Vector3d& p : far_away) p += Vector3d(4.5e6, 5.2e5, 300.5);
  EXPECT_NEAR(rounding_step(far_away), 1.0, 1e-6);
}

TEST(Rounding, TheMiddlesOfALatticesEdgesOrFacesHaveItsStep) {
  std::vector<Vector3d> edges = owl(2.0);
  std::vector<Vector3d> faces = edges;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const Vector3d along = Vector3d::Unit(static_cast<Eigen::Index>(i % 3));
    edges[i] += along;
    faces[i] += Vector3d::Ones() - along;
  }
  EXPECT_NEAR(rounding_step(edges), 2.0, 1e-9);
  EXPECT_NEAR(rounding_step(faces), 2.0, 1e-9);
}

TEST(Rounding, AFewUnevenPointsHideNoStep) {
  std::vector<Vector3d> positions = owl(2.0);
  for (std::size_t i = 0; i < positions.size(); i += 100)
    positions[i] += Vector3d(0.31, 0.57, 0.83) * (1.0 + 1e-3 * static_cast<double>(i));
  EXPECT_NEAR(rounding_step(positions), 2.0, 1e-9);
}

TEST(Rounding, TheCoarsestAxisIsFoundAmongUnroundedOnes) {
  std::vector<Vector3d> positions = cloud::sample_shape(cloud::shape("owl"), 4000).positions;
  EXPECT_EQ(coarsest_axis(positions).step, 0.0);
  for (Vector3d& p : positions) p.x() = 0.7 * std::round(p.x() / 0.7);
  for (Vector3d& p : positions) p.y() = 2.0 * std::round(p.y() / 2.0);
  EXPECT_EQ(coarsest_axis(positions).axis, 1);
  EXPECT_NEAR(coarsest_axis(positions).step, 2.0, 1e-9);
  EXPECT_EQ(rounding_step(positions), 0.0) << "of all axes";
}

/// As scan lines give them that are 1.7 steps apart.
TEST(Rounding, StepsThatPointsLeaveOutAreFound) {
  std::vector<Vector3d> positions;
  for (int i = 0; i < 35; ++i) {
    for (int k = 0; k < 50; ++k)
      positions.emplace_back(0.1 * std::round(1.7 * i), 0.1 * std::round(1.7 * k), 0.1 * std::round(8 * std::sin(0.1 * (i + k))));
  }
  EXPECT_NEAR(rounding_step(positions), 0.1, 1e-9);
}

/// Coordinates of a map in 32-bit floats: 0.03 m along x, 0.5 m along y and 0.00003 m along z.
TEST(Rounding, FloatsFarFromTheOriginHaveLongSteps) {
  std::vector<Vector3d> positions = cloud::sample_shape(cloud::shape("owl"), 4000).positions;
  EXPECT_EQ(float_step(positions), 0.0) << "they are doubles";
  for (Vector3d& p : positions) p = (p + Vector3d(448262, 5411932, 312)).cast<float>().cast<double>();
  EXPECT_EQ(float_step(positions), 0.5);
  positions[7].x() += 1e-9;
  EXPECT_EQ(float_step(positions), 0.0) << "one of them is a double";
  EXPECT_EQ(float_step({Vector3d(0, 0, 0), Vector3d(0.001, 0, 0).cast<float>().cast<double>()}), std::ldexp(1.0, -33));
}

TEST(Rounding, OneFreeAxisIsEnough) {
  std::vector<Vector3d> positions = owl(2.0);
  for (std::size_t i = 0; i < positions.size(); ++i) positions[i].y() += 0.01 * static_cast<double>(i % 1000);
  EXPECT_EQ(rounding_step(positions), 0.0) << "a depth image has its columns and rows on a lattice";
}

TEST(Rounding, WhatIsNotRoundedHasNoStep) {
  EXPECT_EQ(rounding_step(cloud::sample_shape(cloud::shape("owl"), 4000).positions), 0.0);
  EXPECT_EQ(rounding_step({Vector3d(1, 2, 3), Vector3d(4, 5, 6)}), 0.0);
  EXPECT_EQ(rounding_step({}), 0.0);
}

}  // namespace
}  // namespace isotouch::field
