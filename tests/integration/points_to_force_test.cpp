/// The whole walk: exact objects → oriented points → host → field → core → force, against the exact answer.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "host/evaluate/force_error.h"
#include "host/evaluate/shape_trial.h"
#include "host/evaluate/surface_error.h"
#include "tests/support/accuracy.h"
#include "tests/support/sanitized.h"

namespace isotouch {
namespace {

using evaluate::ForceError;
using evaluate::SurfaceError;

const field_file::OpenField& sphere() {
  static const field_file::OpenField field = evaluate::trial_field(evaluate::shape_trial("sphere"), Method::kDefault);
  return field;
}

ForceError slide(double speed) {
  return evaluate::force_error(evaluate::slide_on_sphere(evaluate::trial_slide(sphere().view, speed), evaluate::core_force(sphere().view)));
}

TEST(PointsToForce, TheSphereIsFeltAsItIsAtHandSpeeds) {
  struct Bound {
    double speed, magnitude_pct, direction_deg;
  };
  for (const Bound& bound : {Bound{100, 0.0028, 0.022}, Bound{300, 0.0028, 0.022}}) {
    const ForceError error = slide(bound.speed);
    EXPECT_GT(error.ticks, 1000U);
    EXPECT_THAT(error.magnitude_rms_pct, test::IsAccuracyOf(bound.magnitude_pct)) << bound.speed << " mm/s";
    EXPECT_THAT(error.direction_max_deg, test::IsAccuracyOf(bound.direction_deg)) << bound.speed << " mm/s";
  }
}

TEST(PointsToForce, TheSphereIsFeltAsItIsAtOneMetreASecond) {
  const ForceError error = slide(1000);
  EXPECT_GT(error.ticks, 300U);
  EXPECT_THAT(error.magnitude_rms_pct, test::IsAccuracyOf(0.0028));
  EXPECT_THAT(error.direction_max_deg, test::IsAccuracyOf(0.042));
}

/// To beat: the better of screened Poisson and SSD reconstruction on the same points (DESIGN.md), and never below the grid's own floor by more than
/// chance.
TEST(PointsToForce, EverySurfaceIsNearerTheTruthThanTheBetterPeer) {
  struct Shape {
    const char* name;
    double ours, peer;  ///< offset, rms, voxel
  };
  for (const auto& [name, ours, peer] : test::examples<Shape>({{"capsules", 0.045, 0.045},
                                                               {"sphere", 0.00012, 0.019},
                                                               {"torus", 0.0007, 0.017},
                                                               {"box", 0.027, 0.140},
                                                               {"plate", 0.04, 0.414}})) {
    const evaluate::ShapeTrial trial = evaluate::shape_trial(name);
    const SurfaceError error = evaluate::surface_error(evaluate::trial_field(trial, Method::kDefault).view, trial.truth);
    const SurfaceError floor = evaluate::surface_error(evaluate::floor_field(trial).view, trial.truth);
    EXPECT_THAT(error.rms_voxel, test::IsAccuracyOf(ours)) << name;
    EXPECT_LT(error.rms_voxel, peer) << name;
    EXPECT_GT(error.rms_voxel, 0.8 * floor.rms_voxel) << name;
    EXPECT_EQ(error.lost, 0U) << name;
  }
}

}  // namespace
}  // namespace isotouch
