#include "host/field/surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "host/cloud/shapes.h"
#include "tests/support/accuracy.h"
#include "tests/support/sanitized.h"

namespace isotouch::field {
namespace {

using Eigen::Vector3d;

struct Offsets {
  double rms = 0.0;
  std::size_t lost = 0, measured = 0;
};

/// How far the zero lies from fresh surface points along their normals, within 2 units.
Offsets offsets(const std::string& name, std::size_t samples) {
  const auto shape = cloud::shape(name);
  const Scan scan(cloud::sample_shape(shape, samples));
  const Surface surface(scan);
  const auto fresh = cloud::scatter_on_shape(shape, 400, 99);
  Offsets result;
  double squares = 0.0;
  for (std::size_t i = 0; i < fresh.size(); ++i) {
    const auto at = [&](double t) { return surface.distance(fresh.positions[i] + t * fresh.normals[i]); };
    double low = -2.0, high = 2.0;
    if (at(low) > 0 || at(high) < 0) {
      ++result.lost;
      continue;
    }
    for (int step = 0; step < 30; ++step) (at((low + high) / 2) < 0 ? low : high) = (low + high) / 2;
    squares += low * low;
    ++result.measured;
  }
  result.rms = std::sqrt(squares / static_cast<double>(std::max<std::size_t>(result.measured, 1)));
  return result;
}

// Screened Poisson and SSD: at best 0.019, 0.017, 0.140, 0.414, 0.045.
TEST(Surface, IsCloserThanItsPeersOnEveryShape) {
  for (const auto& [name, bound] : test::examples<std::pair<const char*, double>>(
           {{"box", 2e-8}, {"sphere", 1.5e-6}, {"torus", 6.5e-4}, {"plate", 2e-3}, {"capsules", 1.8e-3}})) {
    const auto found = offsets(name, 3756);
    EXPECT_THAT(found.rms, test::IsAccuracyOf(bound)) << name;
    EXPECT_EQ(found.lost, 0U) << name;
    EXPECT_EQ(found.measured, 400U) << name;
  }
}

TEST(Surface, GivesABrickTheDistancesOfItsPoints) {
  const Scan scan(cloud::sample_shape(cloud::shape("capsules"), 1500));
  const Surface surface(scan);
  for (const Vector3d& first : {Vector3d(50, 10, 14), Vector3d(-3, 30, 8), Vector3d(0.3, 11.7, 18.1)}) {
    const auto brick = surface.brick(first, 1e9).samples.value();
    for (int s = 0; s < 64; ++s) {
      EXPECT_NEAR(brick[static_cast<std::size_t>(s)], surface.distance(first + Vector3d(s & 3, s >> 2 & 3, s >> 4)), 1e-4) << s;
    }
  }
}

TEST(Surface, SlopeStaysNearOneAndTheSignIsRightFarAway) {
  for (const char* name : test::examples<const char*>({"box", "torus", "plate", "capsules"})) {
    const auto shape = cloud::shape(name);
    const Scan scan(cloud::sample_shape(shape, 3756));
    const Surface surface(scan);
    const auto fresh = cloud::scatter_on_shape(shape, 150, 5);
    std::size_t steep = 0, checked = 0;
    for (std::size_t i = 0; i < fresh.size(); ++i) {
      for (const double t : {-6.0, -3.0, -1.0, 1.0, 3.0, 6.0}) {
        const Vector3d x = fresh.positions[i] + t * fresh.normals[i];
        const double truth = shape.distance(x), d = surface.distance(x);
        if (std::abs(truth) > 0.5) {
          EXPECT_EQ(d < 0, truth < 0) << name << ' ' << truth << ' ' << d;
        }
        EXPECT_LT(std::abs(d), std::abs(truth) + 0.1) << name << " at " << t;
        steep += std::abs(surface.distance(x + Vector3d(0.01, 0, 0)) - d) > 0.0115;
        ++checked;
      }
    }
    EXPECT_LT(steep, checked / 50) << name;
  }
}

}  // namespace
}  // namespace isotouch::field
