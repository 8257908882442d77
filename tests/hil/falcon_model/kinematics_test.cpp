/// The legs against vectors that another program computed for the same model.
#include "hil/falcon_model/kinematics.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <utility>

namespace isotouch::falcon_model {
namespace {

struct Pose {
  Vector grip;
  Angles angles;
  std::array<double, 3> counts;
  std::array<int, 3> rounded{};
  Vector grip_of_rounded{};
};

constexpr Pose kLibnifalcon[] = {
    {{0, 0, 75}, {-0.319735, -0.319735, -0.319735}, {-1463.43, -1463.43, -1463.43}, {-1463, -1463, -1463}, {0, 0, 75.0110}},
    {{0, 0, 90}, {-0.018413, -0.018413, -0.018413}, {-989.58, -989.58, -989.58}, {-990, -990, -990}, {0, 0, 89.9842}},
    {{0, 0, 110}, {0.282533, 0.282533, 0.282533}, {-516.32, -516.32, -516.32}, {-516, -516, -516}, {0, 0, 110.0149}},
    {{0, 0, 125}, {0.483618, 0.483618, 0.483618}, {-200.10, -200.10, -200.10}, {-200, -200, -200}, {0, 0, 125.0050}},
    {{0, 0, 150}, {0.824551, 0.824551, 0.824551}, {336.03, 336.03, 336.03}, {336, 336, 336}, {0, 0, 149.9985}},
    {{0, 0, 170}, {1.165114, 1.165114, 1.165114}, {871.59, 871.59, 871.59}, {872, 872, 872}, {0, 0, 170.0123}},
    {{30, 0, 110}, {0.465802, -0.021246, 0.592821}, {-228.12, -994.03, -28.38}, {-228, -994, -28}, {30.0109, 0.0073, 110.0050}},
    {{-30, 0, 110}, {0.256980, 0.676828, 0.096206}, {-556.51, 103.73, -809.33}, {-557, 104, -809}, {-30.0089, 0.0260, 109.9993}},
    {{0, 30, 110}, {-0.015764, 0.445816, 0.606930}, {-985.41, -259.55, -6.19}, {-985, -260, -6}, {0.0253, 29.9910, 110.0055}},
    {{0, -30, 110}, {0.671800, 0.277443, 0.081166}, {95.82, -524.33, -832.98}, {96, -524, -833}, {-0.0088, -30.0054, 110.0060}},
    {{50, 0, 125}, {0.848188, 0.103682, 1.000775}, {373.20, -797.58, 613.16}, {373, -798, 613}, {50.0045, 0.0001, 124.9846}},
    {{0, 50, 125}, {0.111942, 0.814111, 1.024336}, {-784.59, 319.62, 650.21}, {-785, 320, 650}, {-0.0295, 50.0062, 124.9922}},
    {{-20, 35, 140}, {0.387592, 1.050515, 0.934276}, {-351.11, 691.38, 508.58}, {-351, 691, 509}, {-19.9634, 35.0070, 140.0068}},
    {{25, -15, 95}, {0.437005, -0.280633, 0.240933}, {-273.41, -1401.94, -581.74}, {-273, -1402, -582}, {24.9996, -15.0197, 94.9983}},
    {{40, 40, 120}, {0.375351, 0.340366, 1.150585}, {-370.36, -425.38, 848.74}, {-370, -425, 849}, {40.0011, 40.0017, 120.0153}},
    {{-45, -20, 130}, {0.819027, 1.089312, 0.217760}, {327.35, 752.39, -618.18}, {327, 752, -618}, {-44.9832, -19.9884, 130.0015}},
};

constexpr Pose kMartinHillier[] = {
    {{0, 0, 110}, {0.216627, 0.216627, 0.216627}, {-747.46, -747.46, -747.46}},
    {{0, 0, 125}, {0.425875, 0.425875, 0.425875}, {-422.63, -422.63, -422.63}},
    {{30, 0, 110}, {0.382322, -0.065061, 0.531146}, {-490.24, -1184.73, -259.22}},
    {{0, 30, 110}, {-0.067935, 0.392901, 0.523668}, {-1189.19, -473.82, -270.83}},
    {{-20, 35, 140}, {0.358860, 1.001106, 0.856179}, {-526.66, 470.32, 245.34}},
    {{25, -15, 95}, {0.341287, -0.341723, 0.177680}, {-553.94, -1614.20, -807.91}},
};

double counts_of(const Leg& leg, const Transmission& t) { return (leg.angle() - t.angle_at_zero[0]) * t.counts_per_radian; }

void expect_pose(const Kinematics& kinematics, const Transmission& transmission, const Pose& pose) {
  const auto legs = kinematics.legs(pose.grip);
  ASSERT_TRUE(legs.has_value());
  Angles exact{};
  for (std::size_t i = 0; i < kLegs; ++i) {
    exact[i] = (*legs)[i].angle();
    EXPECT_NEAR(exact[i], pose.angles[i], 6e-7);
    EXPECT_NEAR(counts_of((*legs)[i], transmission), pose.counts[i], 0.006);
  }
  const auto back = kinematics.grip(exact);
  ASSERT_TRUE(back.has_value());
  EXPECT_LT(length(*back - pose.grip), 1e-9);
}

TEST(Kinematics, AgreesWithTheTableOfTheFirstGeometry) {
  const Kinematics kinematics(libnifalcon_geometry());
  for (const Pose& pose : kLibnifalcon) {
    SCOPED_TRACE(testing::Message() << pose.grip.x << " " << pose.grip.y << " " << pose.grip.z);
    expect_pose(kinematics, libnifalcon_transmission(), pose);
    Angles rounded{};
    for (std::size_t i = 0; i < kLegs; ++i) rounded[i] = radians(0.0364346591 * pose.rounded[i] + 35);
    const auto grip = kinematics.grip(rounded);
    ASSERT_TRUE(grip.has_value());
    EXPECT_NEAR(grip->x, pose.grip_of_rounded.x, 6e-5);
    EXPECT_NEAR(grip->y, pose.grip_of_rounded.y, 6e-5);
    EXPECT_NEAR(grip->z, pose.grip_of_rounded.z, 6e-5);
  }
}

TEST(Kinematics, AgreesWithTheTableOfTheSecondGeometry) {
  const Kinematics kinematics(martin_hillier_geometry());
  for (const Pose& pose : kMartinHillier) {
    SCOPED_TRACE(testing::Message() << pose.grip.x << " " << pose.grip.y << " " << pose.grip.z);
    expect_pose(kinematics, martin_hillier_transmission(), pose);
  }
}

TEST(Kinematics, SaysWhereNoArmsReach) {
  const Kinematics kinematics(libnifalcon_geometry());
  for (const Vector& grip : {Vector{0, 0, 190}, {0, 0, 50}, {100, 0, 160}, {0, -90, 150}, {130, 0, 100}})
    EXPECT_FALSE(kinematics.legs(grip).has_value());
}

TEST(Kinematics, TheJacobianIsTheAnglesSlope) {
  constexpr double kStep = 1e-4;
  for (const Geometry& geometry : {libnifalcon_geometry(), martin_hillier_geometry()}) {
    const Kinematics kinematics(geometry);
    for (const Pose& pose : kLibnifalcon) {
      const auto legs = kinematics.legs(pose.grip);
      for (const Vector& axis : {Vector{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}) {
        const auto before = kinematics.legs(pose.grip - kStep * axis), after = kinematics.legs(pose.grip + kStep * axis);
        for (std::size_t i = 0; i < kLegs; ++i) {
          const double slope = ((*after)[i].angle() - (*before)[i].angle()) / (2 * kStep);
          EXPECT_NEAR(dot((*legs)[i].angle_per_mm, axis), slope, 1e-8);
        }
      }
    }
  }
}

TEST(Kinematics, TheJacobianIsTheTables) {
  const Kinematics kinematics(libnifalcon_geometry());
  const auto expect_rows = [&](const Vector& grip, const std::array<Vector, 3>& rad_per_m) {
    const auto legs = kinematics.legs(grip);
    ASSERT_TRUE(legs.has_value());
    for (std::size_t i = 0; i < kLegs; ++i) EXPECT_LT(length(1000 * (*legs)[i].angle_per_mm - rad_per_m[i]), 1e-5);
  };
  expect_rows({0, 0, 110}, {{{3.51482, -11.78733, 13.78540}, {-11.96554, 2.84974, 13.78540}, {8.45072, 8.93759, 13.78540}}});
  expect_rows({10, 20, 120}, {{{5.22881, -8.34700, 14.69599}, {-9.46050, 6.09293, 13.55391}, {7.92219, 10.02592, 11.17811}}});
}

TEST(Kinematics, EqualAnglesStayOnTheAxis) {
  const Kinematics kinematics(libnifalcon_geometry());
  constexpr std::pair<int, double> kHeights[] = {{-1400, 76.6793}, {-1000, 89.6106}, {-600, 106.1846}, {-200, 125.0050}, {0, 134.6024},
                                                 {200, 143.9397},  {600, 160.7551},  {1000, 173.6032}, {1400, 181.2451}};
  for (const auto& [counts, height] : kHeights) {
    const double angle = radians(0.0364346591 * counts + 35);
    const auto grip = kinematics.grip({angle, angle, angle});
    ASSERT_TRUE(grip.has_value());
    EXPECT_LT(length(*grip - Vector{0, 0, height}), 6e-5) << counts;
  }
}

struct Load {
  Vector grip, force;
  Torques torques;  ///< N·mm
  std::array<int, 3> units, larger_units;
};

constexpr Load kLoads[] = {
    {{0, 0, 110}, {1, 0, 0}, {15.488, -52.725, 37.237}, {-155, 527, -372}, {-102, 349, -246}},
    {{0, 0, 110}, {0, 1, 0}, {-51.940, 12.557, 39.383}, {519, -126, -394}, {344, -83, -261}},
    {{0, 0, 110}, {0, 0, 1}, {24.180, 24.180, 24.180}, {-242, -242, -242}, {-160, -160, -160}},
    {{0, 0, 110}, {0, 0, -5}, {-120.901, -120.901, -120.901}, {1209, 1209, 1209}, {800, 800, 800}},
    {{0, 0, 110}, {2, -1, 3}, {155.456, -45.466, 107.632}, {-1555, 455, -1076}, {-1029, 301, -712}},
    {{0, 0, 125}, {1, 0, 0}, {17.890, -60.600, 42.710}, {-179, 606, -427}, {-118, 401, -283}},
    {{0, 0, 125}, {0, 1, 0}, {-59.646, 14.330, 45.316}, {596, -143, -453}, {395, -95, -300}},
    {{0, 0, 125}, {0, 0, 1}, {25.243, 25.243, 25.243}, {-252, -252, -252}, {-167, -167, -167}},
    {{0, 0, 125}, {2, -1, 3}, {171.153, -59.801, 115.832}, {-1712, 598, -1158}, {-1132, 396, -766}},
    {{30, 0, 110}, {1, 0, 0}, {17.150, -40.548, 43.621}, {-172, 405, -436}, {-113, 268, -289}},
    {{30, 0, 110}, {0, 1, 0}, {-56.569, 10.302, 47.678}, {566, -103, -477}, {374, -68, -315}},
    {{30, 0, 110}, {0, 0, 1}, {19.090, 38.103, 11.469}, {-191, -381, -115}, {-126, -252, -76}},
    {{30, 0, 110}, {2, -1, 3}, {148.139, 22.911, 73.969}, {-1481, -229, -740}, {-980, -152, -489}},
    {{10, 20, 120}, {1, 0, 0}, {15.999, -56.800, 47.838}, {-160, 568, -478}, {-106, 376, -317}},
    {{10, 20, 120}, {0, 1, 0}, {-50.305, 13.684, 49.544}, {503, -137, -495}, {333, -91, -328}},
    {{10, 20, 120}, {0, 0, 1}, {33.781, 27.982, 11.119}, {-338, -280, -111}, {-224, -185, -74}},
    {{10, 20, 120}, {0, 0, -5}, {-168.905, -139.909, -55.595}, {1689, 1399, 556}, {1118, 926, 368}},
    {{10, 20, 120}, {2, -1, 3}, {183.647, -43.339, 79.490}, {-1836, 433, -795}, {-1215, 287, -526}},
};

TEST(Kinematics, TorquesOfAForceAgreeWithTheTable) {
  const Kinematics kinematics(libnifalcon_geometry());
  for (const Load& load : kLoads) {
    const auto legs = kinematics.legs(load.grip);
    ASSERT_TRUE(legs.has_value());
    const auto torques = torques_of(*legs, load.force);
    ASSERT_TRUE(torques.has_value());
    for (std::size_t i = 0; i < kLegs; ++i) {
      EXPECT_NEAR((*torques)[i], load.torques[i], 6e-4);
      EXPECT_NEAR(-(*torques)[i] / libnifalcon_transmission().torque_per_unit_n_mm, load.units[i], 0.51);
      EXPECT_NEAR(-(*torques)[i] / martin_hillier_transmission().torque_per_unit_n_mm, load.larger_units[i], 0.51);
    }
    EXPECT_LT(length(force_of(*legs, *torques) - load.force), 1e-12);
  }
}

TEST(Kinematics, TheReachIsTheSheetsReach) {
  const Kinematics kinematics(libnifalcon_geometry());
  EXPECT_FALSE(kinematics.legs({0, 0, 59.6}).has_value());
  EXPECT_TRUE(kinematics.legs({0, 0, 59.8}).has_value());
  EXPECT_TRUE(kinematics.legs({0, 0, 183.1}).has_value());
  EXPECT_FALSE(kinematics.legs({0, 0, 183.3}).has_value());
}

}  // namespace
}  // namespace isotouch::falcon_model
