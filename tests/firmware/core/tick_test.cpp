#include "firmware/core/tick.h"

#include <gtest/gtest.h>

#include <algorithm>

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

TickInput at(const Point& mm) {
  const auto q = [](double v) { return Mm::from_raw(static_cast<std::int32_t>(std::lround(v * 1048576))); };
  TickInput in;
  in.hip = {q(mm.x), q(mm.y), q(mm.z)};
  return in;
}

Point mm(const Vec3<Mm>& v) { return {v.x.raw() / 1048576.0, v.y.raw() / 1048576.0, v.z.raw() / 1048576.0}; }
Point newton(const Vec3<Newton>& v) { return {v.x.raw() / 65536.0, v.y.raw() / 65536.0, v.z.raw() / 65536.0}; }

struct Felt {
  TickModel model;
  TickState state;
  explicit Felt(const TickSettings& settings = {}) : model(make_model(settings, 1'000'000, ball().view())) {}
  TickOutput operator()(const TickInput& in) { return tick(in, ball().view(), model, state); }
};

TEST(Tick, InContactTheForceIsStiffnessTimesDepthAlongTheNormal) {
  Felt felt;
  Random random(51);
  for (int touch = 0; touch < 50; ++touch) {
    const Point n = random.direction();
    TickOutput out;
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

TEST(Tick, InFreeSpaceNothingIsFeltAndTheProxyIsTheHip) {
  Felt felt;
  Random random(52);
  int ticks = 0;
  while (ticks < 2000) {
    const Point p = random.in_box(11.0);
    if (test::length(p - kCentre) < 8.3) continue;
    felt = Felt();
    const TickInput in = at(p);
    const TickOutput out = felt(in);
    EXPECT_EQ(out.force, Vec3<Newton>{});
    EXPECT_EQ(out.proxy, in.hip);
    EXPECT_EQ(out.words, (std::array<std::int16_t, 3>{}));
    ++ticks;
  }
}

TEST(Tick, ContactBeginsAndEndsWithoutAJump) {
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

TEST(Tick, AHandThatBeginsInsideIsLeftAloneUntilItLeaves) {
  Felt felt;
  TickOutput out = felt(at(kCentre + Point{1, 0, 0}));
  EXPECT_TRUE(out.status & kHeldInside);
  for (double r = 1.0; r < 7.9; r += 0.05) {
    out = felt(at(kCentre + Point{r, 0, 0}));
    EXPECT_EQ(out.force, Vec3<Newton>{});
  }
  for (double r = 7.9; r < 9.0; r += 0.05) out = felt(at(kCentre + Point{r, 0, 0}));
  EXPECT_EQ(out.status, 0U);
  EXPECT_TRUE(felt(at(kCentre + Point{7.9, 0, 0})).status & kContact);
}

TEST(Tick, TellsWhatItDidToTheInput) {
  Felt felt;
  TickInput in = at({600, 0, 0});
  in.fresh = false;
  in.age = 2;
  const TickOutput out = felt(in);
  EXPECT_EQ(out.status, std::uint32_t{kInputClamped} | kOutsideGrid | kStale);
  EXPECT_EQ(out.proxy.x, Mm::of(512));
  EXPECT_EQ(felt(at({512, 0, 0})).status & kInputClamped, 0U);
}

TEST(Tick, TheForceNeverExceedsItsLimit) {
  TickSettings settings;
  settings.stiffness = Stiffness::of(50);
  settings.force_limit = Newton::of(3);
  Felt felt(settings);
  TickOutput out;
  for (double r = 9.0; r > 5.0; r -= 0.05) {
    out = felt(at(kCentre + Point{0, 0, 1} * r));
    EXPECT_LE(test::length(newton(out.force)), 3.0001);
  }
  EXPECT_TRUE(out.status & kForceLimited);
}

TEST(Tick, AllocatesNothing) {
  Felt felt;
  Random random(53);
  std::vector<TickInput> inputs;
  for (int i = 0; i < 20000; ++i) inputs.push_back(at(random.in_box(14.0)));
  felt(inputs[0]);
  const test::AllocGuard guard;
  for (const TickInput& in : inputs) felt(in);
  EXPECT_EQ(guard.count(), 0U);
}

}  // namespace
}  // namespace isotouch::core
