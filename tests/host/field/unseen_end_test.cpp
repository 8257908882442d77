#include "host/field/unseen_end.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "host/field/parallel.h"
#include "host/field/scan_field.h"

namespace isotouch::field {
namespace {

using cloud::OrientedPoints;
using Eigen::Vector2d;
using Eigen::Vector3d;
using ::testing::Contains;
using ::testing::Each;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr double kSpacing = 1.2;  // mm

/// Points on the surface that a piece of a profile describes round the z axis.
///
/// from, to   radius and height; the body lies to the left of the way from one to the other
void revolve(OrientedPoints& points, const Vector2d& from, const Vector2d& to) {
  const Vector2d way = (to - from).normalized();
  const int rings = static_cast<int>(std::lround((to - from).norm() / kSpacing));
  for (int ring = 0; ring < rings; ++ring) {
    const Vector2d at = from + (ring + 0.5) / rings * (to - from);
    const int count = std::max(1, static_cast<int>(std::lround(2 * M_PI * at.x() / kSpacing)));
    for (int k = 0; k < count; ++k) {
      const double angle = 2 * M_PI * (k + 0.618 * ring) / count;
      const Vector3d out(std::cos(angle), std::sin(angle), 0);
      points.positions.emplace_back(at.x() * out + at.y() * Vector3d::UnitZ());
      points.normals.emplace_back(way.y() * out - way.x() * Vector3d::UnitZ());
    }
  }
}

/// A cylinder with a bore in its upper face.
struct Bored {
  double radius;     ///< of the bore
  double seen;       ///< of its wall
  bool end = false;  ///< it is as deep, and its end was seen
};
OrientedPoints scan_of(const Bored& bored) {
  OrientedPoints points;
  revolve(points, {0, -20}, {16, -20});
  revolve(points, {16, -20}, {16, 20});
  revolve(points, {16, 20}, {bored.radius, 20});
  revolve(points, {bored.radius, 20}, {bored.radius, 20 - bored.seen});
  if (bored.end) revolve(points, {bored.radius, 20 - bored.seen}, {0, 20 - bored.seen});
  return points;
}

UnseenEnd unseen_end_of(const OrientedPoints& points) {
  Progress progress;
  const SoundScan sound = sound_scan(points);
  return unseen_end(built_scan(sound, 0.6, kBand, progress).field, Spacings(sound.points));
}

TEST(UnseenEnd, OfABoreIsSomewhereInIt) {
  for (const Bored& bored : {Bored{3, 6}, {5, 8}, {8, 10}}) {
    const UnseenEnd end = unseen_end_of(scan_of(bored));
    EXPECT_GT(end.share, 0.001) << bored.radius;
    EXPECT_LT(end.place.head<2>().norm(), 0.5 * bored.radius) << bored.radius;
    EXPECT_LT(end.place.z(), 20 + kSpacing) << bored.radius;
  }
}

TEST(UnseenEnd, IsNoneWhereItWasSeen) {
  for (const Bored& bored : {Bored{3, 6, true}, {5, 8, true}, {8, 10, true}}) {
    EXPECT_EQ(unseen_end_of(scan_of(bored)).share, 0) << bored.radius;
  }
}

TEST(UnseenEnd, IsNoneOfAHoleInAFaceOrOfTheEndOfALimb) {
  OrientedPoints hole;
  revolve(hole, {0, -20}, {16, -20});
  revolve(hole, {16, -20}, {16, 20});
  revolve(hole, {16, 20}, {5, 20});
  EXPECT_EQ(unseen_end_of(hole).share, 0);
  OrientedPoints limb = hole;
  revolve(limb, {5, 20}, {5, 32});
  EXPECT_EQ(unseen_end_of(limb).share, 0);
}

/// The field of a bore with its end, and points that differ: what its wall looks like decides.
constexpr Bored kBore{3.5, 8, true};

const BandField& bore() {
  static const BandField field = [] {
    Progress progress;
    return built_scan(sound_scan(scan_of(kBore)), 0.6, kBand, progress).field;
  }();
  return field;
}

/// Points on the bore's wall above its end, which has none, and on the outside.
///
/// normal    (number, angle) → of one of the kLowest points just over the end; alone they say whether it closes a hollow. Those above look inward
/// others    more points
/// count     of all points, at most; those outside are thinned
constexpr int kLowest = 48;
Vector3d inward(double angle) { return {-std::cos(angle), -std::sin(angle), 0}; }
template <typename Normal>
double share_of_wall(const Normal& normal, OrientedPoints points = {}, std::size_t count = 10'000) {
  const auto ring = [&](double height, int around, const auto& normal_of) {
    for (int k = 0; k < around; ++k) {
      const double angle = 2 * M_PI * k / around;
      points.positions.emplace_back(kBore.radius * -inward(angle) + (20 - kBore.seen + height) * Vector3d::UnitZ());
      points.normals.push_back(normal_of(k, angle));
    }
  };
  ring(0.6, kLowest, normal);
  for (const double height : {3.2, 4.4, 5.6, 6.8}) ring(height, 24, [](int, double angle) { return inward(angle); });
  const OrientedPoints outside = scan_of({kBore.radius, 0});
  const std::size_t step = 1 + (outside.size() - 1) / (count - points.size());
  for (std::size_t i = 0; i < outside.size(); i += step) {
    points.positions.push_back(outside.positions[i]);
    points.normals.push_back(outside.normals[i]);
  }
  return unseen_end(bore(), Spacings(points)).share;
}

TEST(UnseenEnd, HasNormalsThatCancelEachOther) {
  const auto within = [](double degrees) { return share_of_wall([&](int, double angle) { return inward(angle * degrees / 360); }); };
  EXPECT_GT(within(360), 0.003);
  EXPECT_GT(within(240), 0.003) << "their mean has a length of 0.41";
  EXPECT_EQ(within(185), 0) << "0.62, as round a hole in a face";
}

TEST(UnseenEnd, HasNormalsInAllDirectionsRoundIt) {
  const auto across = [](int of_ten) {  // so many along y, the others along x
    return share_of_wall([&](int number, double angle) {
      const Vector3d own = inward(angle);
      return number * 7 % 10 < of_ten ? Vector3d(0, own.y() > 0 ? 1 : -1, 0) : Vector3d(own.x() > 0 ? 1 : -1, 0, 0);
    });
  };
  EXPECT_GT(across(5), 0.003);
  EXPECT_GT(across(3), 0.003);
  EXPECT_EQ(across(2), 0) << "two faces of a slot";
}

TEST(UnseenEnd, HasNormalsAcrossAnAxisUnlessItIsLarge) {
  const auto tilted = [](double square, std::size_t count) {
    return share_of_wall(
        [&](int number, double angle) {
          const double side = number % 2 == 0 ? 1 : -1;
          return Vector3d(std::sqrt(1 - square) * inward(angle) + side * std::sqrt(square) * Vector3d::UnitZ());
        },
        {}, count);
  };
  EXPECT_GT(tilted(0.09, 3'000), 0.003);
  EXPECT_EQ(tilted(0.16, 3'000), 0) << "as between teeth";
  EXPECT_GT(tilted(0.16, 10'000), 0.003) << "no gap between teeth is so large";
}

TEST(UnseenEnd, IsLookedAt) {
  const auto looking = [](int count) {  // the others have their backs to it, as at the end of a limb
    return share_of_wall([&](int number, double angle) { return Vector3d((number * 7 % kLowest < count ? 1 : -1) * inward(angle)); });
  };
  EXPECT_GT(looking(10), 0.003);
  EXPECT_EQ(looking(6), 0);
  const auto turned = [](double cosine) { return share_of_wall([&](int, double angle) { return inward(angle + std::acos(cosine)); }); };
  EXPECT_GT(turned(0.65), 0.003);
  EXPECT_EQ(turned(0.4), 0);
}

TEST(UnseenEnd, IsShownByAPointThatLooksItsWay) {
  const auto one_in_the_middle = [](double cosine) {
    OrientedPoints one;
    one.positions.emplace_back(0, 0, 20 - kBore.seen);
    one.normals.emplace_back(std::sqrt(1 - cosine * cosine), 0, cosine);
    return share_of_wall([](int, double angle) { return inward(angle); }, one);
  };
  const double whole = one_in_the_middle(-1);
  EXPECT_EQ(one_in_the_middle(0.4), whole);
  EXPECT_LT(one_in_the_middle(0.65), 0.9 * whole);
}

TEST(UnseenEnd, WouldHaveThreePoints) {
  const auto of_points = [](std::size_t count) { return share_of_wall([](int, double angle) { return inward(angle); }, {}, count); };
  EXPECT_GT(of_points(660), 0.001) << of_points(660);
  EXPECT_EQ(of_points(330), 0);
}

/// A bottle's mouth that is three spacings wide: what closes it is no plane.
OrientedPoints bottle() {
  OrientedPoints points;
  revolve(points, {0, -20}, {16, -20});
  revolve(points, {16, -20}, {16, 8});
  revolve(points, {16, 8}, {3, 14});
  revolve(points, {3, 14}, {3, 22});
  revolve(points, {3, 22}, {1.8, 22});
  revolve(points, {1.8, 22}, {1.8, 17});
  return points;
}

TEST(UnseenEnd, OfANarrowMouthIsFound) {
  const UnseenEnd end = unseen_end_of(bottle());
  EXPECT_GT(end.share, 0.0002);
  EXPECT_LT(end.place.head<2>().norm(), 1.8);
}

TEST(UnseenEnd, IsTheSameOnEveryThreadAndInEveryOrder) {
  const OrientedPoints points = scan_of({5, 8});
  const SoundScan sound = sound_scan(points);
  Progress progress;
  const BandField field = built_scan(sound, 0.6, kBand, progress).field;
  const auto end_of = [&](unsigned threads, const OrientedPoints& of) {
    const ThreadLimit limit(threads);
    return unseen_end(field, Spacings(of));
  };
  const UnseenEnd one = end_of(1, points), many = end_of(7, points);
  EXPECT_GT(one.share, 0.001);
  EXPECT_EQ(one.share, many.share);
  EXPECT_EQ(one.place, many.place);
  OrientedPoints turned = points;
  std::reverse(turned.positions.begin(), turned.positions.end());
  std::reverse(turned.normals.begin(), turned.normals.end());
  EXPECT_EQ(one.share, end_of(1, turned).share);
  EXPECT_EQ(one.place, end_of(1, turned).place);
}

TEST(UnseenEnd, RefusesTheField) {
  const auto reasons = [](const Bored& bored) {
    Progress progress;
    return scan_field(sound_scan(scan_of(bored)), 0.6, kBand, progress).verdict.reasons;
  };
  EXPECT_THAT(reasons({3, 6}), Contains(HasSubstr("sees into a hollow but not to its end near (")));
  EXPECT_THAT(reasons({3, 6, true}), Each(Not(HasSubstr("sees into a hollow"))));
}

}  // namespace
}  // namespace isotouch::field
