#include "firmware/core/descent_proxy.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/field_image.h"
#include "tests/support/reference.h"

namespace isotouch::core {
namespace {

using test::FieldImage;
using test::Point;
using test::Random;

constexpr double kLambda = 10, kGamma = 1.0 / 31;

const Point kCentre = {19.3, 17.8, 21.6};
constexpr double kRadius = 10;

FieldImage sphere_field() {
  return FieldImage({40, 36, 44}, [](const Point& p) { return test::length(p - kCentre) - kRadius; },
                    {.prefilter = false, .interpolation = Interpolation::kTrilinear});
}

/// The whole levels of a body whose front is the plane z = 20: its nodes from there down are 0, -1, …
FieldImage levels_field() {
  const auto level = [](const Point& p) {
    const bool beside = p[0] < 6 || p[0] > 33 || p[1] < 6 || p[1] > 33 || p[2] < 6;
    return beside || p[2] > 20 ? 1.0 : std::max(p[2] - 20.0, -6.9);
  };
  const auto with_border = [level](const Point& p) {
    const auto outermost = [](double c) { return c < 2 || c > 37; };
    return outermost(p.x) || outermost(p.y) || outermost(p.z) ? 8.0 : level(p);
  };
  return FieldImage({40, 40, 40}, with_border, {.band = 7.0, .prefilter = false, .interpolation = Interpolation::kTrilinear});
}

/// The definition in doubles.
class Twin {
 public:
  explicit Twin(const FieldView& field) : field_(field) {}
  /// returns   whether it touches
  bool move_to(const Point& hip) {
    if (!inside_) proxy_ = hip;
    for (int step = 0; step < kDescentSteps; ++step) {
      const test::ReferenceSample at = test::reference_sample(field_, proxy_);
      const Point push = at.gradient * (kLambda * std::min(at.distance, 0.0));
      proxy_ = proxy_ - (proxy_ - hip + push) * kGamma;
    }
    inside_ = test::reference_sample(field_, proxy_).distance < 0;
    if (!inside_) proxy_ = hip;
    return inside_;
  }
  const Point& proxy() const { return proxy_; }

 private:
  const FieldView& field_;
  Point proxy_{};
  bool inside_ = false;
};

TEST(DescentProxy, IsItsTwinToAThousandthOfAVoxel) {
  const FieldImage image = sphere_field();
  ProxyState state;
  Twin twin(image.view());
  int touched = 0, left = 0;
  double worst = 0;
  for (int t = 0; t < 4000; ++t) {
    const double angle = 0.011 * t, height = kRadius + 1.5 - 4 * std::abs(std::sin(0.004 * t));
    const Point out = {std::cos(angle) * std::cos(0.3 * angle), std::sin(angle) * std::cos(0.3 * angle), std::sin(0.3 * angle)};
    const Vec3<Voxel> hip = test::to_voxel(kCentre + out * height);
    const Contact contact = descend_proxy(hip, image.view(), state);
    const bool touching = twin.move_to(test::to_point(hip));
    ASSERT_EQ(contact.touching, touching) << t;
    worst = std::max(worst, test::length(test::to_point(contact.proxy) - twin.proxy()));
    (touching ? touched : left) += 1;
  }
  EXPECT_GT(touched, 1000);
  EXPECT_GT(left, 500);
  EXPECT_LT(worst, 0.001);
  EXPECT_GT(worst, 0.00001) << "nothing was compared";
}

TEST(DescentProxy, OutsideItIsTheHipAndThereIsNoForce) {
  const FieldImage image = sphere_field();
  ProxyState state;
  Random random(3);
  for (int t = 0; t < 500; ++t) {
    const Vec3<Voxel> hip = test::to_voxel(kCentre + random.direction() * random.uniform(kRadius + 0.1, kRadius + 5));
    const Contact contact = descend_proxy(hip, image.view(), state);
    ASSERT_FALSE(contact.touching);
    ASSERT_EQ(contact.proxy, hip);
    ASSERT_EQ(contact.deflection, Vec3<Voxel>{});
  }
}

TEST(DescentProxy, RestsBelowAPlaneByOnePartInOnePlusLambdaOfTheDepth) {
  const FieldImage image = levels_field();
  ProxyState state;
  descend_proxy(test::to_voxel({20, 20, 25}), image.view(), state);
  for (const double depth : {1.5, 3.0, 5.0}) {
    Contact contact;
    for (int t = 0; t < 3; ++t) contact = descend_proxy(test::to_voxel({20, 20, 20 - depth}), image.view(), state);
    EXPECT_TRUE(contact.touching);
    EXPECT_NEAR(test::to_double(contact.deflection.z), depth * kLambda / (1 + kLambda), 0.001);
    EXPECT_NEAR(test::to_double(contact.deflection.x), 0, 0.001);
  }
}

TEST(DescentProxy, GivesNoForceToAHandThatBeganInside) {
  const FieldImage image = sphere_field();
  ProxyState state;
  const Vec3<Voxel> inside = test::to_voxel(kCentre + Point{0, 0, kRadius - 3}),
                    outside = test::to_voxel(kCentre + Point{0, 0, kRadius + 1});
  for (int t = 0; t < 10; ++t) {
    const Contact contact = descend_proxy(inside, image.view(), state);
    EXPECT_TRUE(contact.held_inside);
    EXPECT_FALSE(contact.touching);
  }
  EXPECT_FALSE(descend_proxy(outside, image.view(), state).held_inside);
  EXPECT_TRUE(descend_proxy(inside, image.view(), state).touching);
}

/// The worst that a checked field can hold, and hands that leap through all of the range: no sum may leave its 32 bits (the sanitizers watch), and the proxy
/// stays within what the header promises.
TEST(DescentProxy, StaysNearTheHipWhateverTheFieldHolds) {
  Random numbers(5);
  const FieldImage image({32, 32, 32}, [&](const Point&) { return numbers.bits() % 4 == 0 ? 7.99 : -7.99; },
                         {.band = 7.99, .prefilter = false, .interpolation = Interpolation::kTrilinear});
  ProxyState state;
  Random random(6);
  Point last{};
  int touched = 0;
  for (int t = 0; t < 3000; ++t) {
    const Point hip = Point{16, 16, 16} + random.in_box(t % 8 == 0 ? 8175 : 20);
    const Contact contact = descend_proxy(test::to_voxel(hip), image.view(), state);
    touched += contact.touching ? 1 : 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      ASSERT_LE(std::abs(test::to_point(contact.proxy)[axis] - hip[axis]), 1281 + std::abs(hip[axis] - last[axis])) << t;
    }
    last = hip;
  }
  EXPECT_GT(touched, 50);
}

}  // namespace
}  // namespace isotouch::core
