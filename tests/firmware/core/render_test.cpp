#include "firmware/core/render.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/alloc_guard.h"
#include "tests/support/field_image.h"
#include "tests/support/reference.h"

namespace isotouch::core {
namespace {

using test::FieldImage;
using test::Point;
using test::Random;

constexpr Point kCentre = {2.0, -1.0, 3.0};  // mm, of a ball of 8 mm

const FieldImage& ball() {
  static const FieldImage image({64, 64, 64},
                                [](const Point& p) {
                                  const Point mm = p * 0.4 - Point{12, 12, 12};
                                  return (test::length(mm - kCentre) - 8.0) / 0.4;
                                },
                                {.edge_mm = 0.4, .origin_mm = {-12, -12, -12}});
  return image;
}

Input at(const Point& mm) {
  const auto q = [](double v) { return Mm::from_raw(static_cast<std::int32_t>(std::lround(v * 1048576))); };
  return position_input({q(mm.x), q(mm.y), q(mm.z)});
}

Point mm(const Vec3<Mm>& v) { return {v.x.raw() / 1048576.0, v.y.raw() / 1048576.0, v.z.raw() / 1048576.0}; }
Point newton(const Vec3<Newton>& v) { return {v.x.raw() / 65536.0, v.y.raw() / 65536.0, v.z.raw() / 65536.0}; }

struct Felt {
  PositionModel model;
  PositionState state;
  explicit Felt(const TickSettings& settings = {}) : model(make_position_model(libnifalcon_model(), settings, 1'000'000, ball().view())) {}
  Output operator()(const Input& in) { return render_position(in, ball().view(), model, state); }
};

TEST(Render, InContactTheForceIsStiffnessTimesDepthAlongTheNormal) {
  Felt felt;
  Random random(51);
  for (int touch = 0; touch < 50; ++touch) {
    const Point n = random.direction();
    Output out;
    for (double r = 9.5; r > 7.0; r -= 0.05) out = felt(at(kCentre + n * r));
    EXPECT_EQ(out.status, std::uint32_t{kContact});
    EXPECT_NEAR(test::length(newton(out.force)), 0.8 * 0.95, 0.002);
    EXPECT_LT(test::angle_degrees(newton(out.force), n), 0.1);
    EXPECT_NEAR(test::length(mm(out.proxy) - kCentre), 8.0, 0.002);
    for (double r = 7.0; r < 9.5; r += 0.05) out = felt(at(kCentre + n * r));
    EXPECT_EQ(out.force, Vec3<Newton>{});
    for (int t = 0; t < 20; ++t) felt(at({2.0, -1.0, 11.8}));
  }
}

TEST(Render, InFreeSpaceNothingIsFeltAndTheProxyIsTheHip) {
  Felt felt;
  Random random(52);
  int ticks = 0;
  while (ticks < 2000) {
    const Point p = random.in_box(11.0);
    if (test::length(p - kCentre) < 8.3) continue;
    felt = Felt();
    const Input in = at(p);
    const Output out = felt(in);
    EXPECT_EQ(out.force, Vec3<Newton>{});
    EXPECT_EQ(out.proxy, in.hip);
    EXPECT_EQ(out.commands, (std::array<std::int16_t, 3>{}));
    ++ticks;
  }
}

TEST(Render, ContactBeginsAndEndsWithoutAJump) {
  Felt felt;
  Point last = {};
  double largest = 0;
  for (int t = 0; t <= 4000; ++t) {  // in and out through the surface, 15 µm a tick
    const double way = t % 80 < 40 ? t % 40 : 40 - t % 40;
    const double r = 8.3 - 0.015 * way;
    const Point force = newton(felt(at(kCentre + Point{0, 0.6, 0.8} * r)).force);
    largest = std::max(largest, test::length(force - last));
    last = force;
  }
  EXPECT_LT(largest, 0.8 * 0.0155);  // stiffness times the hand's way in a tick, and rounding
  EXPECT_GT(largest, 0.8 * 0.0145);
}

TEST(Render, AHandThatBeginsInsideIsLeftAloneUntilItLeaves) {
  Felt felt;
  Output out = felt(at(kCentre + Point{1, 0, 0}));
  EXPECT_TRUE(out.status & kHeldInside);
  for (double r = 1.0; r < 7.9; r += 0.05) {
    out = felt(at(kCentre + Point{r, 0, 0}));
    EXPECT_EQ(out.force, Vec3<Newton>{});
  }
  for (double r = 7.9; r < 9.0; r += 0.05) out = felt(at(kCentre + Point{r, 0, 0}));
  EXPECT_EQ(out.status, 0U);
  EXPECT_TRUE(felt(at(kCentre + Point{7.9, 0, 0})).status & kContact);
}

TEST(Render, TellsWhatItDidToTheInput) {
  Felt felt;
  Input in = at({600, 0, 0});
  in.fresh = false;
  in.age = 2;
  const Output out = felt(in);
  EXPECT_EQ(out.status, std::uint32_t{kInputClamped} | kOutsideGrid | kStale);
  EXPECT_EQ(out.proxy.x, Mm::of(512));
  EXPECT_EQ(felt(at({512, 0, 0})).status & kInputClamped, 0U);
}

TEST(Render, TheForceNeverExceedsItsLimit) {
  TickSettings settings;
  settings.stiffness = Stiffness::of(50);
  settings.force_limit = Newton::of(3);
  Felt felt(settings);
  Output out;
  for (double r = 9.0; r > 5.0; r -= 0.05) {
    out = felt(at(kCentre + Point{0, 0, 1} * r));
    EXPECT_LE(test::length(newton(out.force)), 3.0001);
  }
  EXPECT_TRUE(out.status & kForceLimited);
}

/// A block whose upper side is flat and level at z = 0.
const FieldImage& block() {
  static const FieldImage image({96, 96, 64},
                                [](const Point& p) {
                                  const Point mm = p * 0.4 - Point{19, 19, 20};
                                  const Point out = {std::abs(mm.x) - 15, std::abs(mm.y) - 15, std::abs(mm.z + 8) - 8};
                                  const Point apart = {std::max(out.x, 0.0), std::max(out.y, 0.0), std::max(out.z, 0.0)};
                                  return (test::length(apart) + std::min(std::max({out.x, out.y, out.z}), 0.0)) / 0.4;
                                },
                                {.edge_mm = 0.4, .origin_mm = {-19, -19, -20}});
  return image;
}

TickSettings rough(Ratio friction) {
  TickSettings settings;
  settings.friction = friction;
  return settings;
}

TEST(Render, TheWidestStickingAngleIsThatOfTheFrictionCone) {
  for (const Ratio mu : {Ratio::of(0.1), Ratio::of(0.2), Ratio::of(0.4), Ratio::of(0.6), Ratio::of(0.8)}) {
    for (const double turn : {0.0, 1.1, 4.0}) {
      const PositionModel model = make_position_model(libnifalcon_model(), rough(mu), 1'000'000, block().view());
      PositionState state;
      const Point way = {std::cos(turn), std::sin(turn), 0};
      for (double z = 0.5; z > -2; z -= 0.05) render_position(at({-3, 2, z}), block().view(), model, state);
      const Vec3<Voxel> grip = state.render.friction.grip;
      double widest = 0;
      for (double pull = 0; state.render.friction.grip == grip; pull += 0.001) {
        const Output out = render_position(at(Point{-3, 2, -2} + way * pull), block().view(), model, state);
        const Point force = newton(out.force);
        if (state.render.friction.grip == grip) widest = std::hypot(force.x, force.y) / force.z;
      }
      const double expected = mu.raw() / 1073741824.0;
      EXPECT_NEAR(widest, expected, 0.01 * expected) << turn;
    }
  }
}

TEST(Render, AStickHoldsForAMinuteWithoutDrift) {
  const PositionModel model = make_position_model(libnifalcon_model(), rough(Ratio::of(0.4)), 1'000'000, block().view());
  PositionState state;
  Random random(54);
  const Point press = {0.3, -0.2, -1.5};  // tangent 0.24, within the cone
  for (double part = -0.2; part < 1; part += 0.02) render_position(at({0, 0, press.z * part}), block().view(), model, state);
  for (double part = 0; part < 1; part += 0.02)
    render_position(at({press.x * part, press.y * part, press.z}), block().view(), model, state);
  const Vec3<Voxel> grip = state.render.friction.grip;
  Vec3<Mm> first, last;
  for (int t = 0; t <= 60'000; ++t) {
    const bool tremor = t % 60'000 != 0;
    last = render_position(at(press + (tremor ? random.in_ball(0.05) : Point{})), block().view(), model, state).proxy;
    if (t == 0) first = last;
    ASSERT_EQ(state.render.friction.grip, grip) << t;
  }
  EXPECT_LT(test::length(mm(last) - mm(first)), 0.00002);
  EXPECT_LT(std::hypot(mm(last).x, mm(last).y), 0.001);  // still where it was touched first
}

TEST(Render, WithoutContactThereIsNoForceWhateverIsSet) {
  TickSettings settings = rough(Ratio::of(0.6));
  settings.damping = Damping::of(0.002);
  settings.friction_damping = Damping::of(0.002);
  settings.hand_damping = Damping::of(0.004);
  settings.passivity = Damping::of(0.05);
  settings.delay_ticks = 2;
  Felt felt(settings);
  Random random(55);
  int touching = 0, apart = 0;
  Point hip = {};
  for (int t = 0; t < 1'000'000; ++t) {
    hip = t % 7 == 0 ? random.in_box(15) : hip + random.in_ball(1.5);  // any place, and short ways from there
    const Output out = felt(at(hip));
    if ((out.status & kContact) != 0) {
      ++touching;
      continue;
    }
    ++apart;
    ASSERT_EQ(out.force, Vec3<Newton>{}) << t;
    ASSERT_EQ(out.status & kDamped, 0U);
  }
  EXPECT_GT(touching, 10'000);
  EXPECT_GT(apart, 100'000);
}

TEST(Render, DampingActsAgainstTheHandInContact) {
  TickSettings settings;
  settings.hand_damping = Damping::of(0.01);
  Felt felt(settings), bare;
  for (double r = 9; r > 6.5; r -= 0.05) felt(at(kCentre + Point{0, 0, 1} * r)), bare(at(kCentre + Point{0, 0, 1} * r));
  const Input in = at(kCentre + Point{0, 0, 6.5});
  EXPECT_NEAR(newton(felt(in).force).z - newton(bare(in).force).z, 0.01 * 50, 0.01);  // 50 mm/s inwards
  for (int t = 0; t < 100; ++t) felt(in), bare(in);
  EXPECT_NEAR(newton(felt(in).force).z, newton(bare(in).force).z, 0.00003);
}

TEST(Render, AllocatesNothing) {
  Felt felt;
  Random random(53);
  std::vector<Input> inputs;
  for (int i = 0; i < 20000; ++i) inputs.push_back(at(random.in_box(14.0)));
  felt(inputs[0]);
  const test::AllocGuard guard;
  for (const Input& in : inputs) felt(in);
  EXPECT_EQ(guard.count(), 0U);
}

TEST(Render, ASettingThatChangesLeavesTheOthersToTheBitAtEveryRate) {
  TickSettings settings;
  settings.damping = Damping::of(0.01);
  settings.friction_damping = Damping::of(0.002);
  settings.device_damping = Damping::of(0.003);
  for (const std::uint32_t period_ns : {100'000U, 250'000U, 333'333U, 1'000'000U, 3'999'999U}) {
    const RenderModel before = make_render_model(settings, make_motion_model(libnifalcon_model(), period_ns).rate);
    RenderModel after = before;
    TickSettings changed = settings;
    changed.friction = Ratio::of(0.3);
    retune(changed, after);
    EXPECT_EQ(after.coupling.damping, before.coupling.damping) << period_ns;
    EXPECT_EQ(after.friction.viscous, before.friction.viscous) << period_ns;
    EXPECT_EQ(after.passivity.device, before.passivity.device) << period_ns;
    EXPECT_EQ(after.friction.coefficient, Ratio::of(0.3));
  }
}

}  // namespace
}  // namespace isotouch::core
