#include "firmware/core/joint_torques.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/support/accuracy.h"
#include "tests/support/falcon_twin.h"

namespace isotouch::core {
namespace {

using test::Point;

Newton newton(double value) { return Newton::from_raw(static_cast<std::int32_t>(std::lround(value * 65536))); }

/// The pose after it has settled.
Pose pose_at(const Counts& counts, const DeviceModel& model) {
  PoseState state;
  Pose pose;
  for (int tick = 0; tick < 12; ++tick) pose = follow_pose(joint_angles(counts, model), make_mechanism(model), state);
  return pose;
}

TEST(JointTorques, AreThePublishedOnesAtThePublishedPlaces) {
  struct Row {
    Point grip, force;
    test::Angles torques;  // mN·m = N·mm
  };
  const std::vector<Row> rows = {
      {{0, 0, 110}, {1, 0, 0}, {15.488, -52.725, 37.237}},        {{0, 0, 110}, {0, 1, 0}, {-51.940, 12.557, 39.383}},
      {{0, 0, 110}, {0, 0, 1}, {24.180, 24.180, 24.180}},         {{0, 0, 110}, {0, 0, -5}, {-120.901, -120.901, -120.901}},
      {{0, 0, 110}, {2, -1, 3}, {155.456, -45.466, 107.632}},     {{0, 0, 125}, {1, 0, 0}, {17.890, -60.600, 42.710}},
      {{0, 0, 125}, {0, 1, 0}, {-59.646, 14.330, 45.316}},        {{0, 0, 125}, {0, 0, 1}, {25.243, 25.243, 25.243}},
      {{0, 0, 125}, {2, -1, 3}, {171.153, -59.801, 115.832}},     {{30, 0, 110}, {1, 0, 0}, {17.150, -40.548, 43.621}},
      {{30, 0, 110}, {0, 1, 0}, {-56.569, 10.302, 47.678}},       {{30, 0, 110}, {0, 0, 1}, {19.090, 38.103, 11.469}},
      {{30, 0, 110}, {2, -1, 3}, {148.139, 22.911, 73.969}},      {{10, 20, 120}, {1, 0, 0}, {15.999, -56.800, 47.838}},
      {{10, 20, 120}, {0, 1, 0}, {-50.305, 13.684, 49.544}},      {{10, 20, 120}, {0, 0, 1}, {33.781, 27.982, 11.119}},
      {{10, 20, 120}, {0, 0, -5}, {-168.905, -139.909, -55.595}}, {{10, 20, 120}, {2, -1, 3}, {183.647, -43.339, 79.490}}};
  const test::FalconTwin twin = test::libnifalcon_twin();
  for (const Row& row : rows) {
    const test::Angles published = twin.torques(row.grip, *twin.inverse(row.grip), row.force);
    const Pose pose = pose_at(*test::nearest_counts(twin, row.grip), libnifalcon_model());  // up to 0.03 mm beside the place
    ASSERT_TRUE(pose.settled);
    const JointTorques torques = joint_torques({newton(row.force.x), newton(row.force.y), newton(row.force.z)}, pose.statics);
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_NEAR(published[i], row.torques[i], 0.0006);
      EXPECT_NEAR(torques[i].raw() / 4096.0, row.torques[i], 0.15);
    }
  }
}

TEST(JointTorques, FollowTheTwinInBothGeometries) {
  for (const test::FalconSet& set : test::falcon_sets()) {
    test::Random random(91);
    double worst = 0;
    for (int n = 0; n < 5'000; ++n) {
      const Point grip = Point{0, 0, 128} + random.in_ball(50);
      const auto counts = test::nearest_counts(set.twin, grip, 2000);
      ASSERT_TRUE(counts);
      const Pose pose = pose_at(*counts, set.model);
      ASSERT_TRUE(pose.settled && !pose.statics.near_singular);
      const test::Angles angles = set.twin.angles_of(*counts);
      const Point force =
          n < 6 ? Point{n % 3 == 0 ? 1.0 : 0, n % 3 == 1 ? 1.0 : 0, n % 3 == 2 ? 1.0 : 0} * (n < 3 ? 12 : -12) : random.in_ball(12);
      const Vec3<Newton> f = {newton(force.x), newton(force.y), newton(force.z)};
      const test::Angles exact =
          set.twin.torques(*set.twin.forward(angles, grip), angles, {f.x.raw() / 65536.0, f.y.raw() / 65536.0, f.z.raw() / 65536.0});
      const JointTorques found = joint_torques(f, pose.statics);
      for (std::size_t i = 0; i < 3; ++i) worst = std::max(worst, std::abs(found[i].raw() / 4096.0 - exact[i]));
    }
    EXPECT_THAT(worst, test::IsAccuracyOf(0.0013)) << set.name;  // N·mm, of up to 900: below 0.02 units of a motor command
  }
}

TEST(JointTorques, OfNoForceAreNone) {
  const Pose pose = pose_at({100, -300, 50}, libnifalcon_model());
  EXPECT_EQ(joint_torques({}, pose.statics), JointTorques{});
}

TEST(JointTorques, OfAnAlmostSingularPoseEndAtTheirBoundWithTheSignKept) {
  constexpr SquareMm kLever = SquareMm::of(54'000);      // arm 120 mm, 450 mm away: the largest of any model
  constexpr NewtonMm kBound = NewtonMm::of(8 * 54'000);  // 8 N/mm at that lever
  Statics statics;
  statics.inverse.fill({PerMm::max(), PerMm::max(), PerMm::max()});
  statics.levers.fill(kLever);
  for (const double force : {127.9, 8.0, 1.0}) {
    const Vec3<Newton> pushed = {newton(force), newton(force), newton(force)};
    for (const NewtonMm torque : joint_torques(pushed, statics)) EXPECT_EQ(torque, kBound) << force;
    for (const NewtonMm torque : joint_torques(-pushed, statics)) EXPECT_EQ(torque, -kBound) << force;
  }
}

}  // namespace
}  // namespace isotouch::core
