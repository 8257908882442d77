#include "firmware/core/kinematics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "tests/support/accuracy.h"
#include "tests/support/falcon_twin.h"

namespace isotouch::core {
namespace {

using test::FalconSet;
using test::Point;

Point mm(const Vec3<Mm>& v) { return {v.x.raw() / 1048576.0, v.y.raw() / 1048576.0, v.z.raw() / 1048576.0}; }

/// The pose from a cold start, or none if it does not settle in twelve ticks.
std::optional<Pose> cold(const Counts& counts, const DeviceModel& model, int* ticks = nullptr) {
  const Mechanism mechanism = make_mechanism(model);
  PoseState state;
  for (int tick = 1; tick <= 12; ++tick) {
    const Pose pose = follow_pose(joint_angles(counts, model), mechanism, state);
    if (ticks != nullptr) *ticks = tick;
    if (pose.settled) return pose;
  }
  return std::nullopt;
}

/// Row i of the Jacobian, rad/m, as the statics imply it: G is the inverse of the inverse, over the lever.
std::array<Point, 3> jacobian(const Statics& statics) {
  std::array<Point, 3> columns;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto as_double = [](PerMm v) { return v.raw() / 134217728.0; };
    columns[i] = {as_double(statics.inverse[i].x), as_double(statics.inverse[i].y), as_double(statics.inverse[i].z)};
  }
  const double determinant = test::dot(columns[0], test::cross(columns[1], columns[2]));
  std::array<Point, 3> rows = {test::cross(columns[1], columns[2]), test::cross(columns[2], columns[0]),
                               test::cross(columns[0], columns[1])};
  for (std::size_t i = 0; i < 3; ++i) rows[i] = rows[i] * (1000 / (determinant * (statics.levers[i].raw() / 4096.0)));
  return rows;
}

/// Is the grip where the header promises its bounds? |q| below 0.98 b, away from singular poses, elbows out.
bool is_in_working_space(const FalconSet& set, const Point& grip, const test::Angles& angles) {
  const test::FalconTwin& m = set.twin;
  std::array<Point, 3> gradients;
  const std::array<Point, 3> rows = m.jacobian(grip, angles);
  for (std::size_t i = 0; i < 3; ++i) {
    const double phi = (105 - 120 * static_cast<double>(i)) * 0.017453292519943295;
    const Point u = {std::cos(phi), std::sin(phi), 0};
    const double q = test::dot(grip, {-u.y, u.x, 0}) + m.kappa_sign * (m.f - m.s);
    const double lever = m.a * ((grip.z - m.a * std::sin(angles[i])) * std::cos(angles[i]) -
                                (test::dot(grip, u) + m.c - m.r - m.a * std::cos(angles[i])) * std::sin(angles[i]));
    if (std::abs(q) > 0.98 * m.b || lever < 300) return false;
    gradients[i] = rows[i] * lever;
  }
  return std::abs(test::dot(gradients[0], test::cross(gradients[1], gradients[2]))) > 60'000;
}

// Equal counts, axis and corners of the workspace with the published results of their rounded counts.
struct Published {
  Counts counts;
  Point grip;
};
const std::vector<Published> kPublished = {
    {{-1463, -1463, -1463}, {0, 0, 75.0110}},
    {{-990, -990, -990}, {0, 0, 89.9842}},
    {{-516, -516, -516}, {0, 0, 110.0149}},
    {{-200, -200, -200}, {0, 0, 125.0050}},
    {{336, 336, 336}, {0, 0, 149.9985}},
    {{872, 872, 872}, {0, 0, 170.0123}},
    {{-228, -994, -28}, {30.0109, 0.0073, 110.0050}},
    {{-557, 104, -809}, {-30.0089, 0.0260, 109.9993}},
    {{-985, -260, -6}, {0.0253, 29.9910, 110.0055}},
    {{96, -524, -833}, {-0.0088, -30.0054, 110.0060}},
    {{373, -798, 613}, {50.0045, 0.0001, 124.9846}},
    {{-785, 320, 650}, {-0.0295, 50.0062, 124.9922}},
    {{-351, 691, 509}, {-19.9634, 35.0070, 140.0068}},
    {{-273, -1402, -582}, {24.9996, -15.0197, 94.9983}},
    {{-370, -425, 849}, {40.0011, 40.0017, 120.0153}},
    {{327, 752, -618}, {-44.9832, -19.9884, 130.0015}},
    {{-1400, -1400, -1400}, {0, 0, 76.6793}},
    {{-1000, -1000, -1000}, {0, 0, 89.6106}},
    {{-600, -600, -600}, {0, 0, 106.1846}},
    {{0, 0, 0}, {0, 0, 134.6024}},
    {{200, 200, 200}, {0, 0, 143.9397}},
    {{600, 600, 600}, {0, 0, 160.7551}},
    {{1000, 1000, 1000}, {0, 0, 173.6032}},
    {{1400, 1400, 1400}, {0, 0, 181.2451}},
};

TEST(Kinematics, GivesThePublishedPositions) {
  for (const Published& row : kPublished) {
    const std::optional<Pose> pose = cold(row.counts, libnifalcon_model());
    ASSERT_TRUE(pose) << row.grip.z;
    for (std::size_t axis = 0; axis < 3; ++axis) EXPECT_NEAR(mm(pose->hip)[axis], row.grip[axis], 0.00006);  // four printed decimals
  }
}

TEST(Kinematics, GivesThePublishedPositionsOfMartinAndHillier) {
  struct Row {
    Point grip;
    test::Angles counts;
  };
  const std::vector<Row> rows = {{{0, 0, 110}, {-747.46, -747.46, -747.46}},   {{0, 0, 125}, {-422.63, -422.63, -422.63}},
                                 {{30, 0, 110}, {-490.24, -1184.73, -259.22}}, {{0, 30, 110}, {-1189.19, -473.82, -270.83}},
                                 {{-20, 35, 140}, {-526.66, 470.32, 245.34}},  {{25, -15, 95}, {-553.94, -1614.20, -807.91}}};
  for (const Row& row : rows) {
    Counts counts;
    for (std::size_t i = 0; i < 3; ++i) counts[i] = static_cast<std::int16_t>(std::lround(row.counts[i]));
    const std::optional<Pose> pose = cold(counts, martin_hillier_model());
    ASSERT_TRUE(pose);
    EXPECT_LT(test::length(mm(pose->hip) - row.grip), 0.03);  // rounding to counts, 0.039 mm a count at most
    const std::optional<test::Angles> angles = test::martin_hillier_twin().inverse(row.grip);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(test::martin_hillier_twin().counts_of(*angles)[i], row.counts[i], 0.006);
  }
}

TEST(Kinematics, GivesThePublishedJacobian) {
  struct Row {
    Point grip;
    std::array<Point, 3> rows;
  };
  const std::vector<Row> rows = {
      {{0, 0, 110}, {Point{3.51482, -11.78733, 13.78540}, {-11.96554, 2.84974, 13.78540}, {8.45072, 8.93759, 13.78540}}},
      {{10, 20, 120}, {Point{5.22881, -8.34700, 14.69599}, {-9.46050, 6.09293, 13.55391}, {7.92219, 10.02592, 11.17811}}}};
  const test::FalconTwin twin = test::libnifalcon_twin();
  for (const Row& row : rows) {
    const std::array<Point, 3> exact = twin.jacobian(row.grip, *twin.inverse(row.grip));
    const std::optional<Pose> pose = cold(*test::nearest_counts(twin, row.grip), libnifalcon_model());
    ASSERT_TRUE(pose);
    const std::array<Point, 3> there = twin.jacobian(mm(pose->hip), *twin.inverse(mm(pose->hip)));
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        EXPECT_NEAR(exact[i][axis] * 1000, row.rows[i][axis], 0.00001);
        EXPECT_NEAR(jacobian(pose->statics)[i][axis], there[i][axis] * 1000, 0.0002);
      }
    }
  }
}

TEST(Kinematics, FromAColdStartTheHipIsThatOfTheTwinOverTheWorkingSpace) {
  double worst = 0;  // mm
  for (const FalconSet& set : test::falcon_sets()) {
    test::Random random(81);
    int poses = 0, unsettled = 0, slowest = 0;
    while (poses < 20'000) {
      const Point grip = {random.uniform(-110, 110), random.uniform(-110, 110), random.uniform(50, 195)};
      const auto counts = test::nearest_counts(set.twin, grip);
      if (!counts) continue;
      const test::Angles angles = set.twin.angles_of(*counts);
      const std::optional<Point> exact = set.twin.forward(angles, grip);
      if (!exact || !is_in_working_space(set, *exact, angles)) continue;
      ++poses;
      int ticks = 0;
      const std::optional<Pose> pose = cold(*counts, set.model, &ticks);
      if (!pose) {
        if (std::hypot(exact->x, exact->y) <= 90) ++unsettled;  // Newton's way from the middle to the rim may lead outside the model
        continue;
      }
      slowest = std::max(slowest, ticks);
      worst = std::max(worst, test::length(mm(pose->hip) - *exact));
    }
    EXPECT_EQ(unsettled, 0) << set.name;
    EXPECT_LE(slowest, 10) << set.name;
  }
  EXPECT_THAT(worst, test::IsAccuracyOf(0.000045));
}

TEST(Kinematics, KeepsUpWithAHandOfOneMetreASecond) {
  for (const FalconSet& set : test::falcon_sets()) {
    test::Random random(82);
    const Mechanism mechanism = make_mechanism(set.model);
    double worst = 0;
    int ticks = 0;
    for (int path = 0; path < 200; ++path) {
      Point at = Point{0, 0, 125} + random.in_ball(30);
      PoseState state;
      std::uint32_t settled = 0;
      for (int stroke = 0; stroke < 8; ++stroke) {
        const Point to = Point{0, 0, 125} + random.in_ball(45);
        const int steps = 1 + static_cast<int>(test::length(to - at));  // at most 1 mm a tick
        const Point step = (to - at) * (1.0 / steps);
        for (int n = 0; n < steps; ++n) {
          at = at + step;
          const auto counts = test::nearest_counts(set.twin, at, 2000);
          ASSERT_TRUE(counts) << at.x << ' ' << at.y << ' ' << at.z;
          const Pose pose = follow_pose(joint_angles(*counts, set.model), mechanism, state);
          if (pose.settled) ++settled;
          if (settled == 0) continue;
          ASSERT_TRUE(pose.settled);
          worst = std::max(worst, test::length(mm(pose.hip) - *set.twin.forward(set.twin.angles_of(*counts), at)));
          ++ticks;
        }
      }
    }
    EXPECT_GT(ticks, 50'000);
    EXPECT_THAT(worst, test::IsAccuracyOf(0.000005)) << set.name;
  }
}

TEST(Kinematics, AnglesThatNoGripHasAreNotTakenForAPose) {
  const DeviceModel model = libnifalcon_model();
  for (const Counts& counts : {Counts{1600, 1600, -1600}, Counts{32767, 32767, 32767}, Counts{2400, 2400, 2400}}) {
    EXPECT_FALSE(cold(counts, model)) << counts[0];
  }
}

TEST(Kinematics, TheOtherPlaceWhereTheArmsMeetIsNotThatOfTheGrip) {
  const DeviceModel device = libnifalcon_model();
  const Mechanism mechanism = make_mechanism(device);
  PoseState state;
  // A solution of the closures, and there is a singularity between it and the middle.
  state.hip = {Mm::of(27.6), Mm::of(-90.0), Mm::of(139.0)};
  for (int t = 0; t < 100; ++t) {
    const Pose pose = follow_pose(joint_angles({2336, 830, 816}, device), mechanism, state);
    ASSERT_FALSE(pose.settled && pose.hip.z < Mm::of(150)) << t;
  }
}

TEST(Kinematics, LegsMayBeNumberedTheOtherWayRound) {
  DeviceModel device = libnifalcon_model();
  const auto expected = cold({373, -798, 613}, device);
  std::swap(device.legs[1], device.legs[2]);
  const auto found = cold({373, 613, -798}, device);
  ASSERT_TRUE(expected && found);
  EXPECT_LT(test::length(mm(found->hip) - mm(expected->hip)), 1e-6);
}

TEST(Kinematics, IsFoundAgainAfterItWasLost) {
  const DeviceModel model = libnifalcon_model();
  const Mechanism mechanism = make_mechanism(model);
  test::Random random(83);
  for (int run = 0; run < 200; ++run) {
    PoseState state;
    for (int tick = 0; tick < 50; ++tick) {  // nonsense of all kinds
      const auto count = [&] { return static_cast<std::int16_t>(random.uniform(-32768, 32767)); };
      follow_pose(joint_angles({count(), count(), count()}, model), mechanism, state);
    }
    bool settled = false;
    for (int tick = 0; tick < 24; ++tick) settled = follow_pose(joint_angles({-200, -200, -200}, model), mechanism, state).settled;
    EXPECT_TRUE(settled) << run;
    EXPECT_NEAR(mm(state.hip).z, 125.0050, 0.0001);
  }
}

}  // namespace
}  // namespace isotouch::core
