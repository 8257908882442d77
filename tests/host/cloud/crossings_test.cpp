#include "host/cloud/crossings.h"

#include <gtest/gtest.h>

#include <cmath>

#include "host/error.h"

namespace isotouch::cloud {
namespace {

using Eigen::Vector3d;

TEST(Crossings, EstimateTheArea) {
  constexpr double kPi = 3.14159265358979323846;
  EXPECT_NEAR(crossings(shape("sphere"), 20000, 1).area / (4 * kPi * 80 * 80), 1.0, 0.02);
  EXPECT_NEAR(crossings(shape("torus"), 20000, 1).area / (4 * kPi * kPi * 70 * 25), 1.0, 0.02);
  EXPECT_NEAR(crossings(shape("plate"), 20000, 1).area / 40640.0, 1.0, 0.03);
}

TEST(Crossings, HitEveryFaceInProportionToItsArea) {
  const Crossings found = crossings(shape("box"), 30000, 2);
  Vector3d share = Vector3d::Zero();
  for (const Vector3d& n : found.points.normals) share += n.cwiseAbs() / 30000.0;
  const double area = 120.0 * 80 + 160.0 * 80 + 160.0 * 120;
  EXPECT_NEAR(share.x(), 120.0 * 80 / area, 0.012);
  EXPECT_NEAR(share.y(), 160.0 * 80 / area, 0.012);
  EXPECT_NEAR(share.z(), 160.0 * 120 / area, 0.012);
}

TEST(Crossings, OfATorusAreDenserNowhere) {
  const Crossings found = crossings(shape("torus"), 30000, 3);
  double outer = 0.0;
  for (const Vector3d& p : found.points.positions) outer += p.head<2>().norm() > 70.0 ? 1.0 / 30000 : 0.0;
  EXPECT_NEAR(outer, 0.5 + 25.0 / (70.0 * 3.14159265358979), 0.012);  // Pappus
}

TEST(Crossings, OfNothingAreRefused) {
  Shape nothing = shape("sphere");
  nothing.distance = [](const Vector3d&) { return 5.0; };
  EXPECT_THROW(crossings(nothing, 2, 1), InputError);
}

}  // namespace
}  // namespace isotouch::cloud
