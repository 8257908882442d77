#include "host/field/doubtful_samples.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <numeric>

#include "host/cloud/shapes.h"

namespace isotouch::field {
namespace {

using Eigen::Vector3d;

std::vector<std::uint8_t> doubtful(const cloud::OrientedPoints& points) {
  const Scan scan(points);
  return doubtful_samples(scan, local_models(scan));
}

TEST(DoubtfulSamples, AreNoneOnCleanBodies) {
  for (const char* name : {"sphere", "torus", "box", "plate"}) {
    const auto found = doubtful(cloud::sample_shape(cloud::shape(name), 3756));
    EXPECT_EQ(std::accumulate(found.begin(), found.end(), 0), 0) << name;
  }
}

TEST(DoubtfulSamples, AreThoseRoundAStray) {
  auto points = cloud::sample_shape(cloud::shape("sphere"), 2500);
  const Vector3d foot = points.positions[7];
  points.positions[7] *= 85.0 / 80.0;
  const auto found = doubtful(points);
  EXPECT_EQ(found[7], 1);
  std::size_t beside = 0;
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (found[i] == 0) continue;
    ++beside;
    EXPECT_LT((points.positions[i] - foot).norm(), 30.0);
  }
  EXPECT_GE(beside, 9U);
  EXPECT_LT(beside, 60U);
}

TEST(DoubtfulSamples, HearSignsThatCancel) {
  // Two sheets 4 apart with one normal: models of either sheet expect a sample of the other, above or below.
  auto points = cloud::sample_shape(cloud::shape("sphere"), 2500);
  for (std::size_t i = 0; i < points.size(); i += 2) points.positions[i] *= 84.0 / 80.0;
  const auto found = doubtful(points);
  EXPECT_GT(std::accumulate(found.begin(), found.end(), 0), 2000);
}

}  // namespace
}  // namespace isotouch::field
