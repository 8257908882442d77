#include "firmware/guard/arm_geometry.h"

#include <gtest/gtest.h>

#include <utility>

#include "tests/support/falcon_twin.h"
#include "tests/support/random.h"

namespace isotouch::guard {
namespace {

using test::Random;

TEST(ArmGeometry, FindsEveryPlaceOfTheWorkspaceFromItsMiddle) {
  Random random(1);
  for (const test::FalconSet& set : test::falcon_sets()) {
    const ArmGeometry arms(set.model);
    int found = 0;
    for (int i = 0; i < 2000; ++i) {
      const test::Point place = {random.uniform(-50, 50), random.uniform(-50, 50), random.uniform(-50, 50)};
      const auto counts = test::nearest_counts(set.twin, place + test::Point{0, 0, 125}, 3000);
      if (!counts) continue;
      const auto exact = set.twin.forward(set.twin.angles_of(*counts));
      ASSERT_TRUE(exact);
      Grip grip;
      ASSERT_TRUE(arms.find(*counts, {}, grip)) << set.name;
      EXPECT_LT(length(grip.at - Point{exact->x, exact->y, exact->z - 125}), 1e-3);
      ++found;
    }
    EXPECT_GT(found, 1500);
  }
}

TEST(ArmGeometry, ComputesTheForceOfCommands) {
  Random random(2);
  for (const test::FalconSet& set : test::falcon_sets()) {
    const ArmGeometry arms(set.model);
    for (int i = 0; i < 200; ++i) {
      const test::Point place = {random.uniform(-40, 40), random.uniform(-40, 40), random.uniform(-30, 30)};
      const auto counts = test::nearest_counts(set.twin, place + test::Point{0, 0, 125}, 3000);
      ASSERT_TRUE(counts);
      const test::Point wanted = {random.uniform(-5, 5), random.uniform(-5, 5), random.uniform(-5, 5)};
      const test::Angles angles = set.twin.angles_of(*counts);
      const test::Angles torques = set.twin.torques(*set.twin.forward(angles), angles, wanted);
      std::array<std::int16_t, 3> commands{};
      for (std::size_t leg = 0; leg < 3; ++leg) commands[leg] = static_cast<std::int16_t>(-torques[leg] / set.twin.newton_mm_per_word);
      Grip grip;
      ASSERT_TRUE(arms.find(*counts, {}, grip));
      const Point force = arms.force(commands, grip);
      EXPECT_LT(length(force - Point{wanted.x, wanted.y, wanted.z}), 1e-3 + arms.rounding(grip)) << set.name;
      EXPECT_LT(arms.rounding(grip), 0.02);
    }
  }
}

TEST(ArmGeometry, TheOtherPlaceWhereTheArmsMeetIsNotThatOfTheGrip) {
  const ArmGeometry arms(libnifalcon_model());
  Grip grip;
  const Point beyond = {27.6, -90.0, 14.0};  // a solution of the closures, and there is a singularity between it and the middle
  ASSERT_TRUE(arms.find({2340, 830, 816}, beyond, grip));
  EXPECT_LT(length(grip.at - Point{20.5, -66.9, 33.3}), 0.5) << "by the inverse kinematics of that place";
}

TEST(ArmGeometry, LegsMayBeNumberedTheOtherWayRound) {
  DeviceModel device = libnifalcon_model();
  Grip expected, found;
  ASSERT_TRUE(ArmGeometry(device).find({373, -798, 613}, {}, expected));
  std::swap(device.legs[1], device.legs[2]);
  ASSERT_TRUE(ArmGeometry(device).find({373, 613, -798}, {}, found));
  EXPECT_LT(length(found.at - expected.at), 2e-3);
}

TEST(ArmGeometry, FindsNoPlaceWhereTheArmsDoNotMeet) {
  const ArmGeometry arms(libnifalcon_model());
  Grip grip;
  grip.at = {1, 2, 3};
  EXPECT_FALSE(arms.find({32767, -32768, 32767}, {}, grip));
  EXPECT_EQ(grip.at, (Point{1, 2, 3}));
}

}  // namespace
}  // namespace isotouch::guard
