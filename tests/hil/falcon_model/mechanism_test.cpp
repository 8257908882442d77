#include "hil/falcon_model/mechanism.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "tests/support/random.h"

namespace isotouch::falcon_model {
namespace {

constexpr auto kNobody = [](const Vector&, const Vector&) { return Vector{}; };

MechanismSettings weightless() {
  MechanismSettings settings;
  settings.gravity_n = {};
  return settings;
}

/// J, kinetic and of height; forces are constant where this is used.
double energy(const Mechanism& mechanism, const MechanismSettings& settings) {
  const Vector v = mechanism.velocity_mm_s();
  return 0.5 * settings.mass_kg * dot(v, v) * 1e-6 - dot(settings.gravity_n, mechanism.position_mm()) * 1e-3;
}

TEST(Mechanism, CountsAreTheAngleRoundedDown) {
  MechanismSettings settings;
  settings.start_mm = {30, 0, 110};
  EXPECT_EQ(Mechanism(settings).counts(), (Counts{-229, -995, -29}));  // -228.12, -994.03, -28.38
  settings.start_mm = {50, 0, 125};
  EXPECT_EQ(Mechanism(settings).counts(), (Counts{373, -798, 613}));
}

TEST(Mechanism, CommandsPushAsTheTableSays) {
  MechanismSettings settings;
  settings.start_mm = {10, 20, 120};
  EXPECT_LT(length(Mechanism(settings).motor_force_n({-1836, 433, -795}) - Vector{2, -1, 3}), 0.005);
  settings.transmission = martin_hillier_transmission();
  EXPECT_LT(length(Mechanism(settings).motor_force_n({-1215, 287, -526}) - Vector{2, -1, 3}), 0.005);
}

TEST(Mechanism, MotorsGiveNoMoreThanTheirLargestCommand) {
  const Mechanism mechanism(weightless());
  EXPECT_EQ(mechanism.motor_force_n({30000, -30000, 4096}), mechanism.motor_force_n({4095, -4095, 4095}));
}

TEST(Mechanism, AConstantForceEndsInTheSpeedThatDampingAllows) {
  MechanismSettings settings = weightless();
  settings.damping_n_s_per_m = 30;
  Mechanism mechanism(settings);
  const auto push = [](const Vector&, const Vector&) { return Vector{0, 0, 1.5}; };
  mechanism.step(1, {}, push);
  EXPECT_NEAR(mechanism.velocity_mm_s().z, 1000 * 1.5 / 0.3 * 0.001, 0.3);  // F/m first
  mechanism.step(200, {}, push);
  EXPECT_NEAR(mechanism.velocity_mm_s().z, 50, 0.01);  // F/b
}

/// A drawn spring at the grip: what the motors give at rest is what stretches it.
TEST(Mechanism, ASpringOfTheMotorsIsMeasuredAsTheSpringThatItIs) {
  MechanismSettings settings = weightless();
  settings.start_mm = {0, 0, 125};
  Mechanism mechanism(settings);
  constexpr double kStiffness = 0.8, kPush = 2.4;
  const Vector wall{0, 0, 125};
  for (int ms = 0; ms < 3000; ++ms) {
    const auto torques = torques_of(mechanism.legs(), kStiffness * (wall - mechanism.position_mm()) - 0.01 * mechanism.velocity_mm_s());
    ASSERT_TRUE(torques.has_value());
    Commands commands{};
    for (std::size_t i = 0; i < kLegs; ++i)
      commands[i] = static_cast<int>(std::lround(-(*torques)[i] / settings.transmission.torque_per_unit_n_mm));
    mechanism.step(1, commands, [&](const Vector&, const Vector&) { return Vector{0, 0, -kPush}; });
  }
  EXPECT_NEAR(kPush / (wall.z - mechanism.position_mm().z), kStiffness, 0.01);
  EXPECT_LT(length(mechanism.velocity_mm_s()), 0.5);
}

TEST(Mechanism, WithoutPowerNoEnergyIsCreatedNotEvenAtTheEnds) {
  test::Random random(5);
  double lost = 0;
  for (int throws = 0; throws < 60; ++throws) {
    MechanismSettings settings;
    settings.damping_n_s_per_m = 0.3;
    settings.start_mm = {random.uniform(-30, 30), random.uniform(-30, 30), random.uniform(100, 150)};
    Mechanism mechanism(settings);
    const Vector kick{random.uniform(-60, 60), random.uniform(-60, 60), random.uniform(-60, 60)};
    mechanism.step(10, {}, [&](const Vector&, const Vector&) { return kick; });  // up to 3 m/s: against the ends
    double before = energy(mechanism, settings);
    const double first = before;
    for (int ms = 0; ms < 1000; ++ms) {
      mechanism.step(1, {}, kNobody);
      const double now = energy(mechanism, settings);
      EXPECT_LE(now, before + 1e-5);  // of about 1 J: the way back from an end lifts the grip by some 10 micrometres
      before = now;
    }
    lost = std::max(lost, first - before);
  }
  EXPECT_GT(lost, 0.1);
}

TEST(Mechanism, ArmsStayBetweenTheirEnds) {
  test::Random random(6);
  const MechanismSettings settings;
  Mechanism mechanism(settings);
  int least = 0, most = 0;
  for (int pull = 0; pull < 200; ++pull) {
    const Vector force{random.uniform(-30, 30), random.uniform(-30, 30), random.uniform(-30, 30)};
    for (int ms = 0; ms < 100; ++ms) {
      mechanism.step(1, {}, [&](const Vector&, const Vector& v) { return force - 0.005 * v; });
      for (const int counts : mechanism.counts()) {
        least = std::min(least, counts);
        most = std::max(most, counts);
      }
    }
  }
  EXPECT_LT(most, 1700);
  EXPECT_GT(most, 1580);
  EXPECT_GT(least, -1700);
  EXPECT_LT(least, -1580);
}

TEST(Mechanism, RefusesWhatCannotMove) {
  MechanismSettings settings;
  settings.start_mm = {0, 0, 190};
  EXPECT_THROW(Mechanism{settings}, std::invalid_argument);
  settings = {};
  settings.mass_kg = 0;
  EXPECT_THROW(Mechanism{settings}, std::invalid_argument);
  settings = {};
  settings.sub_steps_per_ms = 0;
  EXPECT_THROW(Mechanism{settings}, std::invalid_argument);
}

}  // namespace
}  // namespace isotouch::falcon_model
