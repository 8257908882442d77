#include "host/field/scan_field.h"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>
#include <cstddef>

#include "host/cloud/check.h"
#include "host/cloud/random.h"
#include "host/cloud/shapes.h"

namespace isotouch::field {
namespace {

using Eigen::Vector3d;

/// Grid points more than two voxels from the true surface whose sign is wrong.
std::size_t wrong_signs(const BandField& field, const cloud::Shape& truth) {
  std::size_t wrong = 0;
  for (const auto& brick : field.bricks) {
    for (int s = 0; s < 64; ++s) {
      const Vector3d index = 4.0 * brick.cell.cast<double>() + Vector3d(s & 3, s >> 2 & 3, s >> 4);
      const double distance = truth.distance(field.grid.origin + field.grid.edge * index);
      wrong += std::abs(distance) > 2.0 && (distance < 0.0) != (brick.distance[static_cast<std::size_t>(s)] < 0.0F) ? 1U : 0U;
    }
  }
  return wrong;
}

TEST(ScanField, FewerBumpsStandOutOfNoise) {
  const cloud::Shape truth = cloud::shape("hydrant");
  cloud::OrientedPoints points = cloud::sample_shape(truth, 3756);
  const double deviation = 0.25 * cloud::median_spacing(points.positions);
  cloud::Random random(2);
  for (Vector3d& p : points.positions) {
    for (double& x : p) {
      double sum = -6;
      for (int k = 0; k < 12; ++k) sum += random.uniform();
      x += deviation * sum;
    }
  }
  SoundScan sound = sound_scan(points);
  ASSERT_TRUE(sound.smoothed);
  Progress progress;
  const std::size_t in_noise = wrong_signs(scan_field(sound, 1.0, 3.0, progress).field, truth);
  sound.smoothed = false;
  const std::size_t usual = wrong_signs(scan_field(sound, 1.0, 3.0, progress).field, truth);
  EXPECT_GT(usual, 0U);
  EXPECT_LT(in_noise, 0.8 * static_cast<double>(usual));
}

}  // namespace
}  // namespace isotouch::field
