#include "host/field/unseen_end.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

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
