/// The whole walk: exact objects → oriented points → host → field → core → force, against the exact answer.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "host/evaluate/force_error.h"
#include "host/evaluate/shape_trial.h"
#include "host/evaluate/surface_error.h"
#include "tests/support/sanitized.h"

namespace isotouch {
namespace {

using evaluate::ForceError;
using evaluate::SurfaceError;

const field_file::OpenField& sphere() {
  static const field_file::OpenField field = evaluate::trial_field(evaluate::shape_trial("sphere"), encoding::Method::kDefault);
  return field;
}

ForceError slide(double speed) {
  return evaluate::force_error(evaluate::slide_on_sphere(evaluate::trial_slide(sphere().view, speed), evaluate::core_force(sphere().view)));
}

TEST(PointsToForce, TheSphereIsFeltAsItIsAtHandSpeeds) {
  for (const double speed : {100.0, 300.0}) {
    const ForceError error = slide(speed);
    EXPECT_GT(error.ticks, 1000U);
    EXPECT_LE(error.magnitude_rms_pct, 0.1);
    EXPECT_LE(error.direction_max_deg, 0.1);
    EXPECT_GT(error.magnitude_rms_pct, 0.0001) << "better than the field can hold: what was measured?";
    EXPECT_GT(error.direction_max_deg, 0.001);
  }
}

TEST(PointsToForce, TheSphereIsFeltAsItIsAtOneMetreASecond) {
  const ForceError error = slide(1000);
  EXPECT_GT(error.ticks, 300U);
  EXPECT_LE(error.magnitude_rms_pct, 0.1);
  EXPECT_LE(error.direction_max_deg, 0.5);
}

/// To beat: the better of screened Poisson and SSD reconstruction on the same points (DESIGN.md), and never below the grid's own floor by more than
/// chance.
TEST(PointsToForce, EverySurfaceIsNearerTheTruthThanTheBetterPeer) {
  using Peer = std::pair<const char*, double>;
  for (const auto& [name, peer_rms] :
       test::examples<Peer>({{"capsules", 0.045}, {"sphere", 0.019}, {"torus", 0.017}, {"box", 0.140}, {"plate", 0.414}})) {
    const evaluate::ShapeTrial trial = evaluate::shape_trial(name);
    const SurfaceError error = evaluate::surface_error(evaluate::trial_field(trial, encoding::Method::kDefault).view, trial.truth);
    const SurfaceError floor = evaluate::surface_error(evaluate::floor_field(trial).view, trial.truth);
    EXPECT_LT(error.rms_voxel, peer_rms) << name;
    EXPECT_GT(error.rms_voxel, 0.8 * floor.rms_voxel) << name;
    EXPECT_EQ(error.lost, 0U) << name;
  }
}

}  // namespace
}  // namespace isotouch
