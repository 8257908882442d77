/// The device's tick in a closed loop with the simulated mechanism, 0.3 kg and 3 N·s/m, whose commands act so many ticks late: up to which stiffness a wall
/// is held without trembling, and what the passivity controller does beyond it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <deque>

#include "firmware/core/tick.h"
#include "hil/falcon_model/mechanism.h"
#include "tests/support/field_image.h"

namespace isotouch::core {
namespace {

using falcon_model::Mechanism;
using falcon_model::MechanismSettings;
using falcon_model::Vector;
using test::FieldImage;
using test::Point;

constexpr double kDamping = 0.003;  // N·s/mm, of the device
constexpr double kPeriod = 0.001;   // s
constexpr double kPush = 1.0;       // N, of a hand that gives way freely

/// A block whose upper side is flat at z = 0.
const FieldImage& block() {
  static const FieldImage image({72, 72, 64},
                                [](const Point& p) {
                                  const Point mm = p * 0.5 - Point{18, 18, 24};
                                  const Point out = {std::abs(mm.x) - 14, std::abs(mm.y) - 14, std::abs(mm.z + 10) - 10};
                                  const Point apart = {std::max(out.x, 0.0), std::max(out.y, 0.0), std::max(out.z, 0.0)};
                                  return (test::length(apart) + std::min(std::max({out.x, out.y, out.z}), 0.0)) / 0.5;
                                },
                                {.edge_mm = 0.5, .origin_mm = {-18, -18, -24}});
  return image;
}

/// 2b / ((2d + 1) T), N/mm.
double certified(std::uint32_t delay) { return 2 * kDamping / ((2 * delay + 1) * kPeriod); }

struct Trial {
  double stiffness;     // N/mm
  std::uint32_t delay;  // ticks
  bool controlled;
  double height;        // mm above the surface from where the grip is let go
  bool rests = false;   // the hand does not give way but holds, with 0.5 N/mm and 5 N·s/m
  double most = 0.012;  // N·s/mm that the controller may inject
};

struct Seen {
  double trembling = 0;     // mm peak to peak, in the last two seconds
  double before = 0;        // the same in the two seconds before them
  double lowest = 0;        // mJ, of what the renderer took and the device lost, from the first contact on
  double injected_rms = 0;  // N from tick to tick, in the last two seconds
  int damped = 0;           // ticks
};

struct Range {
  double low = 1e9, high = -1e9;
  void add(double value) { low = std::min(low, value), high = std::max(high, value); }
  double size() const { return high - low; }
};

Seen simulate(const Trial& run, int ticks) {
  TickSettings settings;
  settings.stiffness = Stiffness::from_raw(static_cast<std::int32_t>(run.stiffness * 65536));
  settings.force_limit = Newton::of(20);
  settings.passivity = Damping::from_raw(run.controlled ? static_cast<std::int32_t>(run.most * 16777216) : 0);
  settings.device_damping = Damping::of(kDamping);
  settings.delay_ticks = run.delay;
  const TickModel model = make_tick_model(libnifalcon_model(), settings, 1'000'000);
  TickState state;

  MechanismSettings body;
  body.gravity_n = {};
  body.start_mm = {0, 0, 125 + run.height};
  Mechanism mechanism(body);
  std::deque<falcon_model::Commands> way(run.delay);  // to the motors
  Seen seen;
  double energy = 0, square = 0;
  bool touched = false;
  Range late, earlier;
  Vec3<Newton> last;
  for (int t = 0; t < ticks; ++t) {
    const falcon_model::Counts counts = mechanism.counts();
    Input in;
    FalconReply reply;
    for (std::size_t i = 0; i < 3; ++i) reply.counts[i] = static_cast<std::int16_t>(counts[i]);
    reply.homed = 7;
    in.packet = encode(reply);
    in.fresh = true;
    in.field_generation = 1;
    const Damping injects = injected_damping(state.felt.passivity, state.render.passivity);
    const Output out = tick(in, &block().view(), model, state);
    if (!touched && (out.status & kContact) != 0) {  // what the hand lost on its way there is no credit
      touched = true;
      energy = seen.lowest = 0;
    }
    way.push_back({out.commands[0], out.commands[1], out.commands[2]});
    const falcon_model::Commands commands = way.front();
    way.pop_front();

    const bool held = t < 300;  // until forces are there in full
    mechanism.step(1, commands, [&](const Vector& at, const Vector& v) {
      if (held) return Vector{0, 0, 0} + 5.0 * (body.start_mm - at) - 0.02 * v;
      const double dt = kPeriod / body.sub_steps_per_ms;
      energy += (-falcon_model::dot(mechanism.motor_force_n(commands), v) + kDamping * falcon_model::dot(v, v)) * dt;
      if (run.rests) return 0.5 * (Vector{0, 0, 123} - at) - 0.005 * v;
      return Vector{-20 * 0.001 * v.x, -20 * 0.001 * v.y, -kPush};  // sideways the hand holds it
    });
    const double z = mechanism.position_mm().z - 125;
    seen.lowest = std::min(seen.lowest, energy);
    seen.damped += (out.status & kDamped) != 0 ? 1 : 0;
    const Vec3<Newton> injected = damping_force(state.motion.quiet.velocity, injects);
    const Vec3<Newton> step = injected - last;
    last = injected;
    if (t >= ticks - 4000 && t < ticks - 2000) earlier.add(z);
    if (t < ticks - 2000) continue;
    late.add(z);
    square += std::ldexp(static_cast<double>(dot_raw(step, step)), -32) / 2000;
  }
  seen.trembling = late.size();
  seen.before = earlier.size();
  seen.injected_rms = std::sqrt(square);
  return seen;
}

constexpr std::uint32_t kDelays[] = {1, 2, 3};

TEST(ClosedLoop, TremblingDiesOutUpToTheCertificateAndStaysAtOneAndAHalfTimesIt) {
  for (const std::uint32_t delay : kDelays) {
    for (const double part : {0.5, 0.9, 1.0}) {
      const Seen seen = simulate({part * certified(delay), delay, false, 0.02}, 12'000);
      EXPECT_LT(seen.trembling, std::max(0.12, 0.95 * seen.before))
          << delay << " ticks, " << part;  // two counts and a half, or less and less
    }
    const Seen seen = simulate({1.5 * certified(delay), delay, false, 0.02}, 12'000);
    EXPECT_GT(seen.trembling, 1.5) << delay;
    EXPECT_GT(seen.trembling, 0.95 * seen.before) << delay;
  }
}

TEST(ClosedLoop, WithTheControllerNoEnergyComesFromNothingUpToTwiceTheCertificate) {
  for (const std::uint32_t delay : kDelays) {
    double lowest = 0;
    for (const double height : {0.02, 2.0, 6.0}) {  // set down, and dropped at up to 200 mm/s
      for (const double part : {0.5, 1.0, 1.25, 1.5, 1.75, 2.0}) {
        const Seen seen = simulate({part * certified(delay), delay, true, height}, 6'000);
        EXPECT_GT(seen.lowest, -0.5) << delay << " ticks, " << part << ", " << height;
        lowest = std::min(lowest, seen.lowest);
      }
    }
    EXPECT_LT(lowest, -0.1);  // else the bound above could be tighter
    EXPECT_LT(simulate({2 * certified(delay), delay, false, 0.02}, 6'000).lowest, -0.5) << "without it, " << delay;
  }
}

TEST(ClosedLoop, TheControllerIsNotFeltByAHandThatRestsNorWithinTheCertificate) {
  for (const std::uint32_t delay : kDelays) {
    for (const double part : {0.5, 1.0, 1.5, 2.0}) {
      const Seen seen = simulate({part * certified(delay), delay, true, 2.0, true}, 6'000);
      EXPECT_LT(seen.injected_rms, 0.02) << delay << " ticks, " << part;
      EXPECT_LT(seen.trembling, 0.1) << delay << " ticks, " << part;
      EXPECT_EQ(seen.damped > 20, part > 1) << delay << " ticks, " << part;
    }
  }
}

}  // namespace
}  // namespace isotouch::core
