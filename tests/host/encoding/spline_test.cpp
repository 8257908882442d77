#include "host/encoding/spline.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "host/cloud/random.h"
#include "host/encoding/brick_rows.h"
#include "tests/host/encoding/field_bodies.h"
#include "tests/support/accuracy.h"

namespace isotouch::encoding {
namespace {

/// The double twin of the core's sampler, straight from SPEC.md 2.1.
class Spline {
 public:
  Spline(const field::BandField& field, int steps)
      : field_(field), rows_(field), coefficients_(spline_coefficients(field, neighbours(field), steps)) {}

  double operator()(const Eigen::Vector3d& point) const {
    const Eigen::Vector3d at = field_.grid.to_index(point);
    const Eigen::Vector3i nearest = (at.array() + 0.5).floor().cast<int>();
    double sum = 0;
    for (int n = 0; n < 27; ++n) {
      const Eigen::Vector3i sample = nearest + Eigen::Vector3i(n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1);
      const Eigen::Vector3d t = at - sample.cast<double>();
      sum += coefficient(sample) * beta(t.x()) * beta(t.y()) * beta(t.z());
    }
    return sum;
  }

 private:
  static double beta(double t) {
    const double a = std::abs(t);
    return a <= 0.5 ? 0.75 - a * a : a <= 1.5 ? (1.5 - a) * (1.5 - a) / 2 : 0.0;
  }
  double coefficient(const Eigen::Vector3i& sample) const {
    const std::size_t brick = rows_.find(sample / 4);
    EXPECT_NE(brick, BrickRows::kAbsent) << "the twin was asked outside the band";
    if (brick == BrickRows::kAbsent) return 0.0;
    return coefficients_[brick][static_cast<std::size_t>(((sample.z() % 4) * 4 + sample.y() % 4) * 4 + sample.x() % 4)] / 4096.0;
  }

  const field::BandField& field_;
  BrickRows rows_;
  std::vector<Coefficients> coefficients_;
};

/// rms distance between the spline's zero and the surface, along the normal, at surface points.
struct Surface {
  Eigen::Vector3d point;
  Eigen::Vector3d normal;
};

double rms_offset(const Spline& spline, const std::function<Surface(cloud::Random&)>& draw) {
  constexpr int kPoints = 3000;
  cloud::Random random(3);
  double sum = 0;
  int found = 0;
  for (int n = 0; n < kPoints; ++n) {
    const Surface surface = draw(random);
    double low = -1.0;
    double high = 1.0;
    if (spline(surface.point + low * surface.normal) > 0 || spline(surface.point + high * surface.normal) < 0) continue;
    for (int halving = 0; halving < 30; ++halving) {
      const double middle = (low + high) / 2;
      (spline(surface.point + middle * surface.normal) < 0 ? low : high) = middle;
    }
    sum += low * low;
    ++found;
  }
  EXPECT_GT(found, kPoints * 99 / 100);
  return std::sqrt(sum / found);
}

const Eigen::Vector3d kShift(0.31, -0.17, 0.44);

Surface on_ball(cloud::Random& random, double radius) {
  Eigen::Vector3d direction;
  do {
    for (double& component : direction) component = random.uniform(-1, 1);
  } while (direction.norm() > 1 || direction.norm() < 0.1);
  return {kShift + radius * direction.normalized(), direction.normalized()};
}

Surface on_box(cloud::Random& random, const Eigen::Vector3d& half) {
  const Eigen::Vector3d areas(half.y() * half.z(), half.z() * half.x(), half.x() * half.y());
  const double pick = random.uniform(0, areas.sum());
  const int axis = pick < areas.x() ? 0 : pick < areas.x() + areas.y() ? 1 : 2;
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  normal[axis] = random.uniform() < 0.5 ? -1 : 1;
  Eigen::Vector3d point;
  for (int a = 0; a < 3; ++a) point[a] = a == axis ? normal[a] * half[a] : random.uniform(-half[a], half[a]);
  return {kShift + point, normal};
}

TEST(Spline, TakesTheDistancesAtTheSamplesWhereTheyAreSmooth) {
  const auto field = test::field_of(test::ball(20), Eigen::Vector3d::Constant(20));
  const Spline spline(field, kSplineSteps);
  double worst = 0;
  int compared = 0;
  for (const field::Brick& brick : field.bricks) {
    for (int n = 0; n < 64; ++n) {
      const double distance = static_cast<double>(brick.distance[static_cast<std::size_t>(n)]);
      if (std::abs(distance) > 1.0) continue;
      const Eigen::Vector3i sample = 4 * brick.cell + Eigen::Vector3i(n & 3, (n >> 2) & 3, n >> 4);
      worst = std::max(worst, std::abs(spline(field.grid.position(sample)) - distance));
      ++compared;
    }
  }
  EXPECT_GT(compared, 5000);
  EXPECT_THAT(worst, test::IsAccuracyOf(3e-4));  // one unit of the last place is 2.4e-4
}

TEST(Spline, CorrectionBringsTheZeroOfABallToItsSurface) {
  const auto field = test::field_of(test::ball(20), Eigen::Vector3d::Constant(20));
  const auto draw = [](cloud::Random& random) { return on_ball(random, 20); };
  const double plain = rms_offset(Spline(field, 0), draw);
  const double corrected = rms_offset(Spline(field, kSplineSteps), draw);
  EXPECT_NEAR(plain, 0.0125, 0.002);  // 2/R · 1/8
  EXPECT_LT(corrected, 2e-4);
  EXPECT_GT(corrected, 2e-6);
}

TEST(Spline, CorrectionHalvesTheErrorOfSharpEdges) {
  const Eigen::Vector3d half(20, 15, 10);
  const auto field = test::field_of(test::box(half), half);
  const auto draw = [&](cloud::Random& random) { return on_box(random, half); };
  const double plain = rms_offset(Spline(field, 0), draw);
  const double corrected = rms_offset(Spline(field, kSplineSteps), draw);
  EXPECT_LT(corrected, 0.5 * plain);
  EXPECT_GT(corrected, 0.2 * plain);
}

TEST(Spline, WhatLiesBeyondTheBandCountsOnlyByItsSign) {
  auto field = test::field_of(test::box({12, 9, 7}), {12, 9, 7});
  const auto expected = spline_coefficients(field, neighbours(field));
  int changed = 0;
  for (field::Brick& brick : field.bricks) {
    for (float& distance : brick.distance) {
      if (std::abs(distance) <= 4.0F) continue;
      distance = distance > 0 ? std::numeric_limits<float>::max() : -4.0001F;
      ++changed;
    }
  }
  EXPECT_GT(changed, 1000);
  EXPECT_EQ(spline_coefficients(field, neighbours(field)), expected);
}

TEST(Spline, WithoutAStepTheCoefficientsAreTheClampedSamples) {
  const auto field = test::field_of(test::ball(9), Eigen::Vector3d::Constant(9), 1.3);
  const auto coefficients = spline_coefficients(field, neighbours(field), 0);
  ASSERT_EQ(coefficients.size(), field.bricks.size());
  ASSERT_FALSE(coefficients.empty());
  for (std::size_t b = 0; b < coefficients.size(); ++b) {
    for (std::size_t n = 0; n < 64; ++n) {
      const double expected = std::clamp(4096.0 * static_cast<double>(field.bricks[b].distance[n]), -5325.0, 5325.0);  // 1.3 · 4096
      ASSERT_NEAR(coefficients[b][n], expected, 0.501);
    }
  }
}

}  // namespace
}  // namespace isotouch::encoding
