#include "host/evaluate/damage.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>

#include "host/cloud/shapes.h"
#include "host/evaluate/shape_trial.h"

namespace isotouch::evaluate {
namespace {

const cloud::OrientedPoints& sphere() {
  static const cloud::OrientedPoints points = cloud::sample_shape(cloud::shape("sphere"), 2000);
  return points;
}

TEST(Damage, NoDamageIsTheSameCloud) {
  const cloud::OrientedPoints same = damaged(sphere(), {"none"}, 1);
  EXPECT_EQ(same.positions, sphere().positions);
  EXPECT_EQ(same.normals, sphere().normals);
}

TEST(Damage, NoiseHasTheDeviationThatItNames) {
  const cloud::OrientedPoints noisy = damaged(sphere(), {"noise", 0.02}, 1);
  ASSERT_EQ(noisy.size(), sphere().size());
  double squares = 0;
  for (std::size_t i = 0; i < noisy.size(); ++i) squares += (noisy.positions[i] - sphere().positions[i]).squaredNorm();
  const double deviation = std::sqrt(squares / (3.0 * static_cast<double>(noisy.size())));
  const double spacing = std::sqrt(4 * M_PI * 80 * 80 / 2000);  // a little above the nearest neighbour's distance
  EXPECT_LT(deviation, 0.025 * spacing);
  EXPECT_GT(deviation, 0.015 * spacing);
  EXPECT_EQ(noisy.normals, sphere().normals);
}

TEST(Damage, AsManyNormalsAreTurnedAsAskedFor) {
  const cloud::OrientedPoints turned = damaged(sphere(), {"flipped", 0, 0, 0.06}, 1);
  std::size_t count = 0;
  for (std::size_t i = 0; i < turned.size(); ++i) count += turned.normals[i] == -sphere().normals[i] ? 1U : 0U;
  EXPECT_EQ(count, 120U);
  EXPECT_EQ(turned.positions, sphere().positions);
}

TEST(Damage, StraysComeBehindThePointsAndStayNearTheBox) {
  const cloud::OrientedPoints more = damaged(sphere(), {"outliers", 0, 0.01, 0}, 1);
  ASSERT_EQ(more.size(), 2020U);
  std::size_t far = 0;
  for (std::size_t i = 2000; i < more.size(); ++i) {
    EXPECT_LE(more.positions[i].cwiseAbs().maxCoeff(), 80 + 0.1 * 160 + 1e-9);
    EXPECT_NEAR(more.normals[i].norm(), 1, 1e-12);
    far += std::abs(more.positions[i].norm() - 80) > 10 ? 1U : 0U;
  }
  EXPECT_GT(far, 5U);
}

TEST(Damage, IsTheSameForASeedAndBesideOthers) {
  const cloud::OrientedPoints all = damaged(sphere(), {"all", 0.02, 0.01, 0.06}, 7);
  EXPECT_EQ(all.positions, damaged(sphere(), {"all", 0.02, 0.01, 0.06}, 7).positions);
  EXPECT_NE(all.positions, damaged(sphere(), {"all", 0.02, 0.01, 0.06}, 8).positions);
  const cloud::OrientedPoints turned = damaged(sphere(), {"flipped", 0, 0, 0.06}, 7);
  for (std::size_t i = 0; i < turned.size(); ++i) ASSERT_EQ(all.normals[i], turned.normals[i]);
}

TEST(Damage, ADamagedTrialIsStillMeasuredOnItsOwnTruth) {
  const ShapeTrial trial = shape_trial("sphere");
  const ShapeTrial worse = damaged_trial(trial, kDamages[3]);
  EXPECT_EQ(worse.truth.positions, trial.truth.positions);
  EXPECT_GT(worse.points.size(), trial.points.size());
  for (const auto& p : worse.points.positions) {  // room for the band round every stray
    EXPECT_GE(worse.grid.to_index(p).minCoeff(), kTrialBand + 3);
    EXPECT_LE((worse.grid.to_index(p) - worse.grid.size.cast<double>()).maxCoeff(), -kTrialBand - 4);
  }
}

}  // namespace
}  // namespace isotouch::evaluate
