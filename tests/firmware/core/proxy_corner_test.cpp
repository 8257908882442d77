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

class ProxyInCornersHeavy : public ProxyOn {};
INSTANTIATE_TEST_SUITE_P(Both, ProxyInCornersHeavy, testing::Values(Interpolation::kSpline, Interpolation::kTrilinear), name_of);

enum class Corner { kConcaveCrease, kConvexEdge, kConvexCorner, kConcaveCorner };

/// The smaller of two distances, with a fillet of `radius` where they meet: what the host does with a crease that the grid cannot hold.
double filleted_min(double a, double b, double radius) {
  const double near = std::max(radius - std::abs(a - b), 0.0);
  return std::min(a, b) - (radius > 0 ? near * near / (4 * radius) : 0.0);
}

/// Two or three planes that meet at `centre`: solid where any of them (concave) or all of them (convex) say so, inside a ball.
FieldImage corner_field(Corner kind, const std::vector<Point>& normals, const Point& centre, bool walls, double fillet,
                        const FieldOptions& options) {
  const bool convex = kind == Corner::kConvexEdge || kind == Corner::kConvexCorner;
  return FieldImage(
      {64, 64, 64},
      [=](const Point& p) {
        double value = convex ? -1e9 : 1e9;
        for (const Point& n : normals) {
          const double height = test::dot(p - centre, n);
          const double one = walls ? std::abs(height + 2) - 2 : height;  // a wall of 4 voxels behind the plane
          value = convex ? std::max(value, one) : filleted_min(value, one, fillet);
        }
        return std::max(value, test::length(p - centre) - 25.0);
      },
      options);
}

/// Presses into the corner, then holds still; the largest movement of the deflection in ticks 100 to 200 of stillness.
double dwell(Corner kind, double degrees, bool walls, double fillet, int bodies, std::uint64_t seed, const FieldOptions& options,
             int& touching, double& lowest) {
  Random random(seed);
  double worst = 0;
  for (int body = 0; body < bodies; ++body) {
    const Frame frame(random.direction());  // x out of the corner
    const Point centre = random.in_box(0.5) + Point{32, 32, 32};
    const bool convex = kind == Corner::kConvexEdge || kind == Corner::kConvexCorner;
    const double half = degrees / 57.295779513 / 2;  // opening of the free space, or of the solid where it is convex
    const double out = std::sin(half), side = std::cos(half);
    std::vector<Point> normals = {frame.x * out + frame.y * side, frame.x * out - frame.y * side};
    if (kind == Corner::kConvexCorner || kind == Corner::kConcaveCorner) normals.push_back(frame.x * out + frame.z * side);
    const FieldImage image = corner_field(kind, normals, centre, walls, fillet, options);
    for (int place = 0; place < 4; ++place) {
      const Point start = centre + frame.x * 12.0 + frame.z * random.uniform(-3, 3);
      const Point end =
          centre - frame.x * random.uniform(0.5, convex ? 6.0 : 8.0) + frame.y * random.uniform(-4, 4) + frame.z * random.uniform(-5, 5);
      Hand hand(image.view());
      hand.move_to(start);
      hand.move(start, end, random.uniform(0.4, 2.0), [](const Point&, const Contact&) {});
      Point low = {1e9, 1e9, 1e9}, high = {-1e9, -1e9, -1e9};
      Contact contact;
      for (int t = 0; t < 200; ++t) {
        contact = hand.move_to(end);
        if (t < 100) continue;
        const Point deflection = test::to_point(contact.deflection);
        for (std::size_t axis = 0; axis < 3; ++axis) {
          low[axis] = std::min(low[axis], deflection[axis]);
          high[axis] = std::max(high[axis], deflection[axis]);
        }
      }
      touching += contact.touching ? 1 : 0;
      worst = std::max(worst, test::length(high - low));
      lowest = std::min(lowest, hand.deepest());
    }
  }
  return worst;
}

TEST_P(ProxyInCornersHeavy, HeldStillInACornerTheForceIsStill) {
  struct Case {
    Corner kind;
    double degrees;
    bool walls;
    double fillet;
  };
  for (const Case& c :
       {Case{Corner::kConcaveCrease, 90, false, 0}, Case{Corner::kConcaveCrease, 120, false, 0}, Case{Corner::kConcaveCrease, 90, true, 0},
        Case{Corner::kConcaveCrease, 40, false, 2}, Case{Corner::kConcaveCrease, 60, false, 2}, Case{Corner::kConcaveCrease, 90, false, 2},
        Case{Corner::kConcaveCrease, 40, true, 2}, Case{Corner::kConcaveCorner, 90, false, 0}, Case{Corner::kConcaveCorner, 90, false, 2},
        Case{Corner::kConvexEdge, 90, false, 0}, Case{Corner::kConvexEdge, 40, false, 0}, Case{Corner::kConvexCorner, 90, false, 0}}) {
    int touching = 0;
    double lowest = 1.0;
    EXPECT_LE(dwell(c.kind, c.degrees, c.walls, c.fillet, 40, 34, options(), touching, lowest), 0.01)
        << "kind " << static_cast<int>(c.kind) << ", " << c.degrees << " degrees";
    EXPECT_GT(lowest, deepest());
    EXPECT_GT(touching, 50);  // of 160: the others ended in free space
  }
}

/// Slides along a crease; the largest angle between the force and that of a proxy left to converge at the same place.
double crease_lag(double degrees, double speed, bool aligned, double fillet, std::uint64_t seed, const FieldOptions& options, int& compared,
                  double& lowest) {
  Random random(seed);
  double worst = 0;
  for (int body = 0; body < 12; ++body) {
    const Point along = aligned ? Point{0, 1, 0} : random.direction();
    const Frame frame(along);
    const double turn = random.uniform(0, 6.28), half = degrees / 57.295779513 / 2;
    const Point out = frame.y * std::cos(turn) + frame.z * std::sin(turn), side = test::cross(along, out);
    const Point n1 = out * std::sin(half) + side * std::cos(half), n2 = out * std::sin(half) - side * std::cos(half);
    const Point centre = random.in_box(0.5) + Point{48, 48, 48};
    const FieldImage image(
        {96, 96, 96},
        [&](const Point& p) {
          const double a = test::dot(p - centre, n1), b = test::dot(p - centre, n2);
          return std::max(filleted_min(a, b, fillet), test::length(p - centre) - 40.0);
        },
        options);
    Hand hand(image.view());
    const auto place = [&](double s, double deep) { return centre + along * s - out * deep + side * (0.5 * std::sin(s / 6)); };
    hand.move_to(place(-20, -6));
    hand.move(place(-20, -6), place(-20, 4), 0.25, [](const Point&, const Contact&) {});
    for (double s = -20; s < 20; s += speed * kMetreASecond) {
      const Point hip = place(s, 4);
      const Contact now = hand.move_to(hip), later = hand.converged(hip, 16);
      EXPECT_TRUE(now.touching && later.touching);
      worst = std::max(worst, test::angle_degrees(test::to_point(now.deflection), test::to_point(later.deflection)));
      ++compared;
    }
    lowest = std::min(lowest, hand.deepest());
  }
  return worst;
}

TEST_P(ProxyInCornersHeavy, SlidingAlongACreaseTheForceIsThatOfTheConvergedProxy) {
  for (const double degrees : {60.0, 90.0, 120.0}) {
    for (const double speed : {0.1, 0.3}) {
      int compared = 0;
      double lowest = 1.0;
      EXPECT_LT(crease_lag(degrees, speed, true, 0.0, 35, options(), compared, lowest), 1.0)
          << degrees << " degrees along an axis, " << speed << " m/s";
      EXPECT_LT(crease_lag(degrees, speed, false, 2.0, 36, options(), compared, lowest), 1.0)
          << degrees << " degrees, filleted as the host does, " << speed << " m/s";
      EXPECT_GT(lowest, deepest());
      EXPECT_GT(compared, 1000);
    }
  }
}

}  // namespace
}  // namespace isotouch::core
