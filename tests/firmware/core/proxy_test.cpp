#include "firmware/core/proxy.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/firmware/core/proxy_hand.h"

namespace isotouch::core {
namespace {

using test::FieldImage;
using test::FieldOptions;
using test::Frame;
using test::Point;
using test::Random;

/// In the middle of 64 voxels.
FieldImage ball(double radius, const FieldOptions& options) {
  return FieldImage(
      {64, 64, 64},
      [=](const Point& p) {
        return test::length(p - Point{32, 32, 32}) - radius;
      },
      options);
}

INSTANTIATE_TEST_SUITE_P(Both, ProxyOn, testing::Values(Interpolation::kSpline, Interpolation::kTrilinear), name_of);

class ProxyOnHeavy : public ProxyOn {};
INSTANTIATE_TEST_SUITE_P(Both, ProxyOnHeavy, testing::Values(Interpolation::kSpline, Interpolation::kTrilinear), name_of);

TEST_P(ProxyOn, OnASphereFollowsTheClosestPoint) {
  const Point centre = {90.3, 90.1, 89.7};
  const double radius = 80.0, depth = 4.0;
  const FieldImage image(
      {180, 180, 180}, [&](const Point& p) { return test::length(p - centre) - radius; }, options());
  const Frame frame({0.3, 0.5, 0.8});
  for (const auto& [speed, bound] : {std::pair{0.1, 0.05}, {0.3, 0.05}, {1.0, 0.1}}) {  // m/s, degrees
    Hand hand(image.view());
    const auto on_arc = [&](double angle, double deep) {
      return centre + (frame.y * std::cos(angle) + frame.z * std::sin(angle)) * (radius - deep);
    };
    hand.move(on_arc(0, -4), on_arc(0, depth), 0.1, [](const Point&, const Contact&) {});
    double worst = 0, square = 0;
    const int ticks = 3000;
    for (int t = 0; t < ticks; ++t) {
      const Point hip = on_arc(t * speed * kMetreASecond / (radius - depth), depth);
      const Contact contact = hand.move_to(hip);
      ASSERT_TRUE(contact.touching);
      const Point deflection = test::to_point(contact.deflection);
      worst = std::max(worst, test::angle_degrees(deflection, hip - centre));
      square += std::pow(test::length(deflection) / depth - 1, 2);
    }
    EXPECT_LT(worst, bound) << speed << " m/s";
    EXPECT_LT(100 * std::sqrt(square / ticks), is_spline() ? 0.01 : 0.06) << speed << " m/s";  // percent
    EXPECT_GT(hand.deepest(), deepest());
  }
}

TEST_P(ProxyOn, InFreeSpaceIsTheHip) {
  const FieldImage image = ball(10.0, options());
  Hand hand(image.view());
  Random random(31);
  Point at = {5, 5, 5};
  int ticks = 0;
  for (int i = 0; i < 200; ++i) {
    const Point to = random.in_box(26.0) + Point{32, 32, 32};
    const Point middle = at + (to - at) * std::clamp(test::dot(Point{32, 32, 32} - at, to - at) / test::dot(to - at, to - at), 0.0, 1.0);
    if (test::length(middle - Point{32, 32, 32}) < 10.5) continue;  // the way leads through the body
    hand.move(at, to, 1.0 * kMetreASecond, [&](const Point& hip, const Contact& contact) {
      EXPECT_FALSE(contact.touching);
      EXPECT_FALSE(contact.following);
      EXPECT_EQ(contact.proxy, test::to_voxel(hip));
      EXPECT_EQ(contact.deflection, Vec3<Voxel>{});
      ++ticks;
    });
    at = to;
  }
  EXPECT_GT(ticks, 500);
}

TEST_P(ProxyOn, ThatBeginsInsideGivesNoContactUntilTheHandHasLeft) {
  const FieldImage image = ball(10.0, options());
  Hand hand(image.view());
  hand.move({32, 32, 32}, {32, 32, 41.9}, 0.2, [](const Point&, const Contact& contact) {
    EXPECT_FALSE(contact.touching);
    EXPECT_TRUE(contact.held_inside);
    EXPECT_EQ(contact.deflection, Vec3<Voxel>{});
  });
  EXPECT_FALSE(hand.move_to({32, 32, 42.5}).held_inside);
  EXPECT_TRUE(hand.move_to({32, 32, 41.5}).touching);
}

TEST_P(ProxyOn, ThatCannotArriveInOneTickFollowsWithoutContact) {
  const FieldImage image = ball(6.0, options());
  Hand hand(image.view());
  hand.move_to({4, 4, 4});
  const Contact jump = hand.move_to({60, 60, 4});
  EXPECT_TRUE(jump.following);
  EXPECT_FALSE(jump.touching);
  EXPECT_EQ(jump.deflection, Vec3<Voxel>{});
  EXPECT_FALSE(hand.converged({60, 60, 4}, 20).following);
}

/// A plate of the given thickness through `centre`, cut to a disc so that the object is closed.
FieldImage plate(const Point& normal, const Point& centre, double thickness, const FieldOptions& options) {
  return FieldImage(
      {128, 128, 128},
      [=](const Point& p) { return std::max(std::abs(test::dot(p - centre, normal)) - thickness / 2, test::length(p - centre) - 58.0); },
      options);
}

TEST_P(ProxyOnHeavy, TenThousandStabsThroughAPlateNeverReachItsOtherSide) {
  Random random(32);
  int stabs = 0, wrong = 0;
  double lowest = 1.0;
  for (int body = 0; body < 20; ++body) {
    const Point normal = body < 3 ? Point{body == 0 ? 1.0 : 0.0, body == 1 ? 1.0 : 0.0, body == 2 ? 1.0 : 0.0} : random.direction();
    const Point centre = random.in_box(0.5) + Point{64, 64, 64};
    const FieldImage image = plate(normal, centre, 4.0, options());
    for (int stab = 0; stab < 500; ++stab) {
      Point direction;  // at least 27 degrees to the plate, so that the way ends inside its rim
      do {
        direction = random.direction();
      } while (test::dot(direction, normal) > -0.45);
      const double steep = -test::dot(direction, normal), height = 6.0 / steep, depth = 24.0 / steep;
      const Point hit = centre + random.in_ball(4.0);
      const Point surface = hit - normal * test::dot(hit - centre, normal);
      Hand hand(image.view());
      bool passed = false;
      const auto see = [&](const Point&, const Contact& contact) {
        passed = passed || test::dot(test::to_point(contact.proxy) - centre, normal) < 0;
      };
      const double speed = random.uniform(0.05, 1.0) * kMetreASecond;
      const Point above = surface - direction * height, beyond = surface + direction * depth;
      hand.move_to(above);
      hand.move(above, beyond, speed, see);
      hand.move(beyond, above, speed, see);
      wrong += passed ? 1 : 0;
      lowest = std::min(lowest, hand.deepest());
      ++stabs;
    }
  }
  EXPECT_EQ(stabs, 10000);
  EXPECT_EQ(wrong, 0);
  EXPECT_GT(lowest, deepest());
}

/// Stabs, fast ones too, at a plate of 3 voxels whose field claims three times its distance; how many passed.
int stabs_through_an_overstated_plate(double certified_slope, FieldOptions options) {
  options.largest_slope = certified_slope;
  Random random(37);
  int passed = 0;
  for (int body = 0; body < 10; ++body) {
    const Point normal = random.direction(), centre = random.in_box(0.5) + Point{48, 48, 48};
    const FieldImage image(
        {96, 96, 96},
        [&](const Point& p) { return 3 * std::max(std::abs(test::dot(p - centre, normal)) - 1.5, test::length(p - centre) - 42.0); },
        options);
    for (int stab = 0; stab < 300; ++stab) {
      const Point hit = centre + random.in_ball(4.0), above = hit + normal * random.uniform(12, 16), beyond = hit - normal * 12.0;
      Hand hand(image.view());
      bool wrong = false;
      hand.move_to(above);
      hand.move(above, beyond, random.uniform(0.3, 8.0), [&](const Point&, const Contact& contact) {
        wrong = wrong || test::dot(test::to_point(contact.proxy) - centre, normal) < 0;
      });
      passed += wrong ? 1 : 0;
    }
  }
  return passed;
}

TEST_P(ProxyOnHeavy, AFieldThatOverstatesItsDistancesIsNotJumpedWhenItsCertificateSaysSo) {
  EXPECT_EQ(stabs_through_an_overstated_plate(3.3, options()), 0);
  EXPECT_GT(stabs_through_an_overstated_plate(0.0, options()), 30) << "the danger that this test is about";
}

/// Three plates of 4 voxels through one centre, their normals at `degrees` to each other.
struct CrossedPlates {
  Point centre;
  std::array<Point, 3> normals;
  FieldImage image;

  CrossedPlates(Random& random, double degrees, const FieldOptions& options)
      : centre(random.in_box(0.5) + Point{48, 48, 48}), normals(directions(random, degrees)), image(make(centre, normals, options)) {}

 private:
  static std::array<Point, 3> directions(Random& random, double degrees) {
    const Frame frame(random.direction());
    const double cosine = std::cos(degrees / 57.295779513);
    const double along = std::sqrt((1 + 2 * cosine) / 3), across = std::sqrt(1 - along * along);
    std::array<Point, 3> normals;
    for (int i = 0; i < 3; ++i) {
      const double angle = i * 2.0943951023932;
      normals[static_cast<std::size_t>(i)] = frame.x * along + frame.y * (across * std::cos(angle)) + frame.z * (across * std::sin(angle));
    }
    return normals;
  }
  static FieldImage make(const Point& centre, const std::array<Point, 3>& normals, const FieldOptions& options) {
    return FieldImage(
        {96, 96, 96},
        [&](const Point& p) {
          double nearest = 1e9;
          for (const Point& n : normals) nearest = std::min(nearest, std::abs(test::dot(p - centre, n)) - 2.0);
          return std::max(nearest, test::length(p - centre) - 42.0);
        },
        options);
  }
};

TEST_P(ProxyOnHeavy, AmongThreeCrossedPlatesItStaysInItsChamber) {
  for (const double degrees : {90.0, 40.0}) {
    Random random(33);
    int runs = 0, wrong = 0;
    std::int64_t in_contact = 0;
    double lowest = 1.0;
    for (int body = 0; body < 20; ++body) {
      const CrossedPlates plates(random, degrees, options());
      for (int run = 0; run < 100; ++run) {
        Point at;
        const auto height = [&](const Point& p, std::size_t i) { return test::dot(p, plates.normals[i]); };
        do {
          at = random.in_ball(28.0);
        } while (std::abs(height(at, 0)) < 3 || std::abs(height(at, 1)) < 3 || std::abs(height(at, 2)) < 3);
        const std::array<bool, 3> above = {height(at, 0) > 0, height(at, 1) > 0, height(at, 2) > 0};
        Hand hand(plates.image.view());
        hand.move_to(plates.centre + at);
        bool left = false;
        for (int segment = 0; segment < 12; ++segment) {
          const Point to = random.in_ball(28.0);
          hand.move(plates.centre + at, plates.centre + to, random.uniform(0.05, 1.0) * kMetreASecond,
                    [&](const Point&, const Contact& contact) {
                      const Point proxy = test::to_point(contact.proxy) - plates.centre;
                      for (std::size_t i = 0; i < 3; ++i) left = left || (height(proxy, i) > 0) != above[i];
                      in_contact += contact.touching ? 1 : 0;
                    });
          at = to;
        }
        wrong += left ? 1 : 0;
        lowest = std::min(lowest, hand.deepest());
        ++runs;
      }
    }
    EXPECT_EQ(runs, 2000);
    EXPECT_EQ(wrong, 0) << degrees << " degrees";
    EXPECT_GT(in_contact, 100000);
    EXPECT_GT(lowest, deepest()) << degrees << " degrees";
  }
}

}  // namespace
}  // namespace isotouch::core
