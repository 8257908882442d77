#include "host/evaluate/calibrate.h"

#include <gtest/gtest.h>

#include <cmath>

#include "host/motion/device_in_hand.h"
#include "tests/support/falcon_twin.h"

namespace isotouch::evaluate {
namespace {

constexpr double kTurn = 4294967296.0;

/// The model with its arms so many degrees further at count 0: what the device really is.
DeviceModel turned(DeviceModel model, const std::array<double, 3>& degrees) {
  for (std::size_t i = 0; i < 3; ++i) {
    model.legs[i].at_zero = model.legs[i].at_zero + Angle::from_raw(static_cast<std::uint32_t>(std::llround(degrees[i] / 360 * kTurn)));
  }
  return model;
}

Posture posture(const DeviceModel& real, const Eigen::Vector3d& place) { return {place, *motion::counts_at(place, real)}; }

double degrees_between(Angle a, Angle b) { return static_cast<std::int32_t>(a.raw() - b.raw()) / kTurn * 360; }

TEST(Calibrate, FindsTheAnglesOfAnyDeviceFromAnyPosture) {
  const std::array<double, 3> offsets = {4, -3.5, 0.25};
  for (const test::FalconSet& set : test::falcon_sets()) {
    const DeviceModel real = turned(set.model, offsets);
    for (const Eigen::Vector3d& place : {Eigen::Vector3d(0, 0, 125), Eigen::Vector3d(20, -30, 110), Eigen::Vector3d(-10, 15, 140)}) {
      const auto found = calibrate(set.model, {posture(real, place)});
      ASSERT_TRUE(found);
      for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_NEAR(degrees_between(found->at_zero[i], real.legs[i].at_zero), 0, 1e-6);
        EXPECT_NEAR(found->turned_deg[i], offsets[i], 1e-6);
      }
      EXPECT_EQ(found->apart_deg, 0);
    }
  }
}

TEST(Calibrate, TakesTheMeanOfPosturesAndTellsHowFarTheyAreApart) {
  const DeviceModel model = libnifalcon_model(), one = turned(model, {1, 1, 1}), other = turned(model, {2, 1, 1});
  const auto found = calibrate(model, {posture(one, {0, 0, 125}), posture(other, {0, 10, 115})});
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->turned_deg[0], 1.5, 1e-6);
  EXPECT_NEAR(found->turned_deg[1], 1, 1e-6);
  EXPECT_NEAR(found->apart_deg, 1, 1e-6);
}

TEST(Calibrate, RefusesAPlaceThatTheArmsDoNotReach) { EXPECT_FALSE(calibrate(libnifalcon_model(), {{{0, 0, 300}, {0, 0, 0}}})); }

}  // namespace
}  // namespace isotouch::evaluate
