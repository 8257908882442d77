#include "firmware/core/stiffness_at.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "firmware/core/render.h"
#include "tests/support/accuracy.h"
#include "tests/support/field_image.h"
#include "tests/support/reference.h"

namespace isotouch::core {
namespace {

using test::FieldImage;
using test::Point;
using test::Random;

constexpr Point kCentre = {24.3, 23.8, 24.1};
constexpr double kRadius = 14.0;
constexpr int kSoft = 85, kHard = 255;  // 255ths; the border at z = 24.1

double distance(const Point& p) { return test::length(p - kCentre) - kRadius; }

FieldImage ball(const std::function<int(const Point&)>& part, double stiffness = 1.2) {
  return FieldImage({49, 48, 49}, distance, {.stiffness = stiffness, .stiffness_part = part});
}
int in_halves(const Point& p) { return p.z < kCentre.z ? kSoft : kHard; }

double newton_per_mm(Stiffness k) { return k.raw() / 65536.0; }

/// Points within the band, so within stored bricks.
Point near_surface(Random& random) { return kCentre + random.direction() * (kRadius + random.uniform(-3.5, 3.5)); }

TEST(StiffnessAt, AgreesWithItsTwin) {
  Random values(61), places(62);
  const FieldImage image = ball([&](const Point&) { return 1 + static_cast<int>(values.bits() % 255); });
  double worst = 0, worst_slope = 0;
  for (int i = 0; i < 20000; ++i) {
    const Vec3<Voxel> point = test::to_voxel(near_surface(places));
    const test::ReferenceStiffness exact = test::reference_stiffness(image.view(), test::to_point(point));
    const StiffnessSample sample = sample_stiffness(point, image.view());
    worst = std::max(worst, std::abs(newton_per_mm(mul<Stiffness>(Stiffness::of(1.2), sample.part)) - 1.2 * exact.part));
    const Point slope = Point{1.0 * sample.slope.x.raw(), 1.0 * sample.slope.y.raw(), 1.0 * sample.slope.z.raw()} * (1.0 / (1 << 24));
    worst_slope = std::max(worst_slope, test::length(slope - exact.slope));
  }
  // A place is cut off at 1/512 voxel, which moves a quotient of up to 4 parts a voxel and axis; rounding of the result adds 2^-17.
  EXPECT_THAT(worst, test::IsAccuracyOf(0.0015));
  EXPECT_THAT(worst_slope, test::IsAccuracyOf(0.0025));
}

TEST(StiffnessAt, WithoutATableOrWithAFullOneIsTheLargest) {
  const FieldImage without({49, 48, 49}, distance), full = ball([](const Point&) { return 255; });
  ASSERT_EQ(without.view().stiffness_parts, nullptr);
  ASSERT_NE(full.view().stiffness_parts, nullptr);
  Random random(63);
  for (const Stiffness largest : {Stiffness::from_raw(1), Stiffness::of(0.8), Stiffness::of(99.99), Stiffness::of(100)}) {
    for (int i = 0; i < 5000; ++i) {
      const Vec3<Voxel> point = test::to_voxel(i % 2 == 0 ? near_surface(random) : random.in_box(60) + kCentre);
      ASSERT_EQ(stiffness_at(point, without.view(), largest), largest);
      ASSERT_EQ(stiffness_at(point, full.view(), largest), largest);
    }
  }
}

TEST(StiffnessAt, AConstantBrickTakesNothingAway) {
  const FieldImage image = ball([](const Point&) { return 51; });
  Random random(64);
  for (int i = 0; i < 20000; ++i) {
    const double k = newton_per_mm(stiffness_at(test::to_voxel(near_surface(random)), image.view(), Stiffness::of(1.2)));
    ASSERT_NEAR(k, 1.2 * 51 / 255, 1.2 / (1 << 20) + 1.0 / (1 << 16));
  }
}

TEST(StiffnessAt, AnywhereAtAllItLiesWithinItsRange) {
  Random values(65), places(66);
  const FieldImage image = ball([&](const Point&) { return 1 + static_cast<int>(values.bits() % 255); });
  for (int i = 0; i < 50000; ++i) {
    const Stiffness k = stiffness_at(test::to_voxel(places.in_box(i % 4 == 0 ? 8191 : 40)), image.view(), Stiffness::of(100));
    ASSERT_GT(k, Stiffness{});
    ASSERT_LE(k, Stiffness::of(100));
  }
}

TEST(StiffnessAt, IsContinuousWithinTheBand) {
  const FieldImage image = ball(in_halves);
  Random random(67);
  constexpr double kStep = 0.01;
  double largest = 0;
  for (int line = 0; line < 300; ++line) {
    const Point from = near_surface(random), direction = random.direction();
    double last = 0;
    for (int n = 0; n < 600; ++n) {
      const Point p = from + direction * (kStep * n);
      if (std::abs(distance(p)) > 3.5) break;
      const double k = newton_per_mm(stiffness_at(test::to_voxel(p), image.view(), Stiffness::of(1.2)));
      if (n > 0) largest = std::max(largest, std::abs(k - last));
      last = k;
    }
  }
  // Each axis moves weights of at most 1/2 a voxel to bricks whose values differ by 0.8 N/mm, divided by a known weight of at least 1/8 …
  EXPECT_LT(largest, 0.8 * kStep * 1.7321 * 0.5 * 8);
  EXPECT_GT(largest, 0.8 * kStep / 4.2);  // … and between two known bricks by 1/4 a voxel
}

struct Press {
  double newton;
  double depth_mm;  ///< from the HIP to the proxy
  Point proxy;      ///< index coordinates
};

/// Presses the ball along `normal`, 1.5 mm deep.
Press press(const FieldImage& image, const Point& normal, const TickSettings& settings = {}) {
  const PositionModel model = make_position_model(libnifalcon_model(), settings, 1'000'000, image.view());
  PositionState state;
  Output out;
  Input in = position_input({});
  const auto raw = [](double v) { return Mm::from_raw(static_cast<std::int32_t>(std::lround(v * 1048576))); };
  const auto mm = [](const Vec3<Mm>& v) { return Point{v.x.raw() / 1048576.0, v.y.raw() / 1048576.0, v.z.raw() / 1048576.0}; };
  constexpr double kEdge = 0.34;
  const Point origin = {-20, -20, -20};
  for (double r = kRadius + 2; r > kRadius - 1.5 / kEdge; r -= 0.05) {
    const Point hip = (kCentre + normal * r) * kEdge + origin;
    in.hip = {raw(hip.x), raw(hip.y), raw(hip.z)};
    out = render_position(in, image.view(), model, state);
  }
  EXPECT_EQ(out.status, std::uint32_t{kContact});
  const Point force = {out.force.x.raw() / 65536.0, out.force.y.raw() / 65536.0, out.force.z.raw() / 65536.0};
  return {test::length(force), test::length(mm(out.proxy) - mm(in.hip)), (mm(out.proxy) - origin) * (1 / kEdge)};
}

TEST(StiffnessAt, TheForceOnASoftAndAHardHalfIsStiffnessTimesDepth) {
  const FieldImage image = ball(in_halves);
  Random random(68);
  int soft = 0, hard = 0, between = 0;
  for (int touch = 0; touch < 150; ++touch) {
    const Press felt = press(image, random.direction());
    const double exact = 1.2 * test::reference_stiffness(image.view(), felt.proxy).part;
    EXPECT_NEAR(felt.newton, exact * felt.depth_mm, 0.01 * felt.depth_mm);  // what is felt may lag behind the table where it changes fast
    const double above = felt.proxy.z - kCentre.z;
    if (above < -8) {
      ++soft;
      EXPECT_NEAR(felt.newton, 0.4 * felt.depth_mm, 0.001);
    } else if (above > 8) {
      ++hard;
      EXPECT_NEAR(felt.newton, 1.2 * felt.depth_mm, 0.001);
    } else {
      ++between;
      EXPECT_GT(felt.newton, 0.4 * felt.depth_mm - 0.001);
      EXPECT_LT(felt.newton, 1.2 * felt.depth_mm + 0.001);
    }
  }
  EXPECT_GT(soft, 20);
  EXPECT_GT(hard, 20);
  EXPECT_GT(between, 20);
}

TEST(StiffnessAt, ASettingReplacesTheLargestAndTheTableStillScalesIt) {
  const FieldImage image = ball(in_halves);
  TickSettings settings;
  settings.stiffness = Stiffness::of(0.6);
  const Press hard = press(image, {0, 0, 1}, settings), soft = press(image, {0, 0, -1}, settings);
  EXPECT_NEAR(hard.newton, 0.6 * hard.depth_mm, 0.001);
  EXPECT_NEAR(soft.newton, 0.2 * soft.depth_mm, 0.001);
}

}  // namespace
}  // namespace isotouch::core
