#include "firmware/core/joint_angles.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/accuracy.h"
#include "tests/support/falcon_twin.h"

namespace isotouch::core {
namespace {

constexpr double kRadiansPerUnit = 6.283185307179586 / 4294967296.0;

TEST(JointAngles, FollowTheTwinOverEveryCount) {
  double worst = 0;  // radians
  for (const test::FalconSet& set : test::falcon_sets()) {
    for (int count = -32768; count <= 32767; ++count) {
      const auto c = static_cast<std::int16_t>(count);
      const JointAngles found = joint_angles({c, c, static_cast<std::int16_t>(-1 - c)}, set.model);
      const test::Angles exact = set.twin.angles_of({c, c, static_cast<std::int16_t>(-1 - c)});
      for (std::size_t i = 0; i < 3; ++i) {
        worst = std::max(worst, std::abs(std::remainder(found[i].raw() * kRadiansPerUnit - exact[i], 6.283185307179586)));
      }
    }
  }
  EXPECT_THAT(worst, test::IsAccuracyOf(1e-7));  // a hundredth of a micrometre at the arm's end
}

TEST(JointAngles, EachLegHasItsOwnOffsetAndRatio) {
  DeviceModel model = libnifalcon_model();
  model.legs[1].at_zero = Angle::degrees(50);
  model.legs[2].per_count = AnglePerCount::degrees(-0.05);
  const JointAngles angles = joint_angles({0, 0, 100}, model);
  EXPECT_EQ(angles[0], Angle::degrees(35));
  EXPECT_EQ(angles[1], Angle::degrees(50));
  EXPECT_NEAR(angles[2].raw(), Angle::degrees(30).raw(), 100);
}

}  // namespace
}  // namespace isotouch::core
