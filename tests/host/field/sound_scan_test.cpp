#include "host/field/sound_scan.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "host/cloud/random.h"
#include "host/cloud/shapes.h"
#include "host/error.h"
#include "host/field/orientation.h"
#include "tests/host/field/random_places.h"
#include "tests/support/sanitized.h"

namespace isotouch::field {
namespace {

using cloud::OrientedPoints;
using cloud::Random;
using Eigen::Vector3d;
using ::testing::AllOf;
using ::testing::Contains;
using ::testing::Each;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::ThrowsMessage;

OrientedPoints of(const char* shape, std::size_t count = 3756) { return cloud::sample_shape(cloud::shape(shape), count); }

OrientedPoints turned(OrientedPoints points) {
  for (Vector3d& n : points.normals) n = -n;
  return points;
}

/// A relief over 100 by 80, 12 deep from top to bottom, seen from above.
OrientedPoints relief(std::size_t count = 3000) {
  OrientedPoints points;
  Random random(3);
  while (points.size() < count) {
    const double x = random.uniform(-50, 50), y = random.uniform(-40, 40);
    points.positions.emplace_back(x, y, 6 * std::sin(x / 12) * std::cos(y / 10));
    points.normals.emplace_back(
        Vector3d(-0.5 * std::cos(x / 12) * std::cos(y / 10), 0.6 * std::sin(x / 12) * std::sin(y / 10), 1).normalized());
  }
  return points;
}

/// The upper half of a ball on a table that is three times as wide.
OrientedPoints ball_on_table() {
  OrientedPoints points;
  const OrientedPoints ball = of("sphere");
  double radius = 0;
  for (const Vector3d& p : ball.positions) radius = std::max(radius, p.norm());
  for (std::size_t i = 0; i < ball.size(); ++i) {
    if (ball.positions[i].z() < 0) continue;
    points.positions.push_back(ball.positions[i]);
    points.normals.push_back(ball.normals[i]);
  }
  Random random(3);
  const std::size_t on_ball = points.size();
  while (points.size() < 4 * on_ball) {
    const Vector3d p(random.uniform(-3 * radius, 3 * radius), random.uniform(-3 * radius, 3 * radius), 0);
    if (p.norm() < radius) continue;
    points.positions.push_back(p);
    points.normals.push_back(Vector3d::UnitZ());
  }
  return points;
}

std::size_t unlike(const SoundScan& scan, const OrientedPoints& truth) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < truth.size(); ++i) count += scan.points.normals[i].dot(truth.normals[i]) < 0 ? 1U : 0U;
  return count;
}

TEST(SoundScan, LeavesACleanScanAsItIs) {
  for (const char* name : test::examples<const char*>({"torus", "sphere", "box", "hydrant", "jaguar"})) {
    const OrientedPoints points = of(name);
    const SoundScan scan = sound_scan(points);
    EXPECT_EQ(scan.outside, Outside::kAsGiven) << name;
    EXPECT_EQ(scan.measured, scan.points.size()) << name;
    EXPECT_GE(scan.points.size() + 5, points.size()) << name;
    EXPECT_TRUE(scan.strays > 0 || scan.points.positions == points.positions) << name;
  }
  EXPECT_THAT(sound_scan(of("torus")).warnings(), IsEmpty());
}

/// A hollow ball whose wall is half as thick as samples are apart.
OrientedPoints thin_shell() {
  const OrientedPoints sphere = cloud::sample_shape(cloud::shape("sphere"), 2000);
  OrientedPoints points = sphere;
  const OrientedPoints other = cloud::sample_shape(cloud::shape("sphere"), 2000, 2);
  for (std::size_t i = 0; i < other.size(); ++i) {
    points.positions.push_back(0.97 * other.positions[i]);
    points.normals.push_back(-other.normals[i]);
  }
  return points;
}

TEST(SoundScan, BelievesTheNormalsOfAThinWall) {
  const OrientedPoints points = thin_shell();
  const SoundScan scan = sound_scan(points);
  EXPECT_EQ(scan.outside, Outside::kAsGiven);
  EXPECT_LT(unlike(scan, points), 10U);
  const SoundScan inside_out = sound_scan(turned(points));
  EXPECT_EQ(inside_out.outside, Outside::kTurned);
  EXPECT_LT(unlike(inside_out, points), 10U);
}

/// Both sides of half a hollow ball: it encloses hardly anything, though its outermost normals leave no doubt.
OrientedPoints thin_bowl() {
  constexpr std::size_t kOneSide = 20000;
  OrientedPoints points;
  for (const auto& [radius, side] : {std::pair(50.0, 1.0), std::pair(49.0, -1.0)}) {
    for (std::size_t i = 0; i < kOneSide; ++i) {
      const double z = -(static_cast<double>(i) + 0.5) / kOneSide, turn = 2.399963229728653 * static_cast<double>(i);
      const double across = std::sqrt(1 - z * z);
      const Vector3d out(across * std::cos(turn), across * std::sin(turn), z);
      points.positions.push_back(radius * out);
      points.normals.push_back(side * out);
    }
  }
  return points;
}

TEST(SoundScan, EveryLengthOfItIsPlacedAndTheVolumeToo) {
  SoundScan scan;
  scan.noise = scan.spacing = scan.rounding = scan.rim.length = scan.rim.longest = scan.enclosed = 8;
  scan.rim.along = {{.sample = 0, .length = 8, .on_longest = true, .rim = 0, .surrounded = 0.5}};
  scan.place({.scale = 0.5});
  for (const double length : {scan.noise, scan.spacing, scan.rounding, scan.rim.length, scan.rim.longest, scan.rim.along[0].length})
    EXPECT_EQ(length, 4);
  EXPECT_EQ(scan.enclosed, 1);
}

TEST(SoundScan, BelievesAnOpenThinWall) {
  const OrientedPoints points = thin_bowl();
  const Facing facing = field::facing(Scan({points.positions, points.normals, {}}));
  ASSERT_LT(facing.volume, 0.04) << "too little to be sure by";
  const SoundScan scan = sound_scan(points);
  EXPECT_EQ(scan.outside, Outside::kAsGiven) << facing.outward;
  EXPECT_LT(unlike(scan, points), 10U);
}

TEST(SoundScan, NamesTheTableUnderAnObject) {
  const OrientedPoints points = ball_on_table();
  EXPECT_THAT(sound_scan(points).warnings(), Contains(HasSubstr("a flat part: if that is a table or a wall, remove it")));
  EXPECT_THAT(sound_scan(relief()).warnings(), Each(Not(HasSubstr("table"))));
  const auto refusal_without_normals = [](const OrientedPoints& scanned) -> std::string {
    try {
      (void)sound_scan(scanned, {.estimate = true, .name = "scan.xyz"});
    } catch (const InputError& error) {
      return error.what();
    }
    return {};
  };
  EXPECT_EQ(
      refusal_without_normals(points),
      "scan.xyz: the points have no normals and show one side of an object only: they end at the edge of a flat part; if that is a table "
      "or a wall, remove it, else give the sensor's place with --viewpoint X Y Z, or scan all round; if several views were merged, save "
      "the scan with outward normals");
  EXPECT_EQ(refusal_without_normals(relief()),
            "scan.xyz: the points have no normals and show one side of an object only: give the sensor's place with --viewpoint X Y Z, or "
            "scan all round; if several views were merged, save the scan with outward normals");
}

/// Coordinates of a map in 32-bit floats, which leave slices of an object: each of them looks like a sheet.
TEST(SoundScan, NamesFloatsThatAreTooCoarseBeforeTheMissingSide) {
  for (const char* shape : {"plate", "capsules"}) {
    OrientedPoints points = of(shape, 6000);
    for (Vector3d& p : points.positions) p = 0.05 * p + Vector3d(5e5, 4.6e6, 120);
    EXPECT_NO_THROW((void)sound_scan(points, {.estimate = true})) << shape;
    for (Vector3d& p : points.positions) p = p.cast<float>().cast<double>();
    EXPECT_THAT(
        [&] { (void)sound_scan(points, {.estimate = true}); },
        ThrowsMessage<InputError>(AllOf(HasSubstr("32-bit floats have steps of "), HasSubstr("; shift the scan to a local origin"))))
        << shape;
  }
}

TEST(SoundScan, TurnsAClosedSurfaceThatIsInsideOut) {
  const OrientedPoints points = of("torus");
  const SoundScan scan = sound_scan(turned(points));
  EXPECT_EQ(scan.outside, Outside::kTurned);
  EXPECT_EQ(unlike(scan, points), 0U);
  EXPECT_THAT(scan.warnings(), Contains(HasSubstr("pointed inwards")));
}

TEST(SoundScan, BelievesAReliefAndGivesItABack) {
  const OrientedPoints points = relief();
  const SoundScan scan = sound_scan(points);
  EXPECT_EQ(scan.outside, Outside::kAsGiven);
  EXPECT_EQ(unlike(scan, points), 0U);
  EXPECT_GT(scan.points.size(), scan.measured);
  EXPECT_GT(scan.rim.samples, 50U);
  EXPECT_THAT(scan.warnings(), Contains(HasSubstr("only one side")));
  double lowest = 0, flux = 0;
  for (std::size_t i = scan.measured; i < scan.points.size(); ++i) {
    const Vector3d& p = scan.points.positions[i];
    lowest = std::min(lowest, p.z());
    flux += scan.points.normals[i].dot(Vector3d(p.x(), p.y(), p.z() + 10));
    const bool beyond = std::max(std::abs(p.x()) - 50, std::abs(p.y()) - 40) > -2;  // the sheet goes on a little
    EXPECT_TRUE(beyond || scan.points.normals[i].z() <= 0.03);
    EXPECT_LT(std::abs(p.x()), 55.5);
    EXPECT_LT(std::abs(p.y()), 45.5);
  }
  EXPECT_NEAR(lowest, -6 - 10, 2.0);  // the front is a little askew; a tenth of the longest side behind the deepest point
  EXPECT_GT(flux, 0);                 // walls and back look away from the body
}

TEST(SoundScan, ABowlSeenFromAboveStaysABowl) {
  OrientedPoints bowl;
  Random random(4);
  while (bowl.size() < 3000) {
    Vector3d p(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, -0.1));
    if (p.norm() > 1 || p.norm() < 0.5) continue;
    p.normalize();
    bowl.positions.emplace_back(50 * p);
    bowl.normals.emplace_back(-p);
  }
  const SoundScan scan = sound_scan(bowl);
  EXPECT_EQ(scan.outside, Outside::kAsGiven);
  EXPECT_EQ(unlike(scan, bowl), 0U);
}

TEST(SoundScan, ASphereWithHalfOfItsNormalsInvertedIsNoSheet) {
  const OrientedPoints points = of("sphere");
  OrientedPoints half = points;
  for (std::size_t i = 0; i < half.size(); ++i) {
    if (half.positions[i].x() < 5) half.normals[i] = -half.normals[i];
  }
  const SoundScan scan = sound_scan(half);
  EXPECT_EQ(scan.outside, Outside::kNeighbours);
  EXPECT_EQ(scan.measured, scan.points.size());
  EXPECT_EQ(unlike(scan, points), 0U);
}

/// An open ball looks like a sheet as long as a patch of its normals is turned.
TEST(SoundScan, WhatIsASheetIsAskedAfterPatchesWereTurned) {
  OrientedPoints truth = of("sphere"), scanned;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    if (truth.normals[i].z() > std::cos(1.22)) continue;  // 70 degrees
    truth.positions[kept] = truth.positions[i];
    truth.normals[kept++] = truth.normals[i];
  }
  truth.positions.resize(kept);
  truth.normals.resize(kept);
  scanned = truth;
  for (Vector3d& n : scanned.normals) n = n.x() < -std::cos(0.9) ? Vector3d(-n) : n;
  EXPECT_GT(facing(Scan({scanned.positions, scanned.normals, {}})).one_sided, 0.4);
  const SoundScan scan = sound_scan(scanned);
  EXPECT_EQ(unlike(scan, truth), 0U);
  EXPECT_LT(scan.one_sided, 0.4);
  EXPECT_FALSE(scan.is_sheet);
}

/// A small ball beside a large one, too far away for neighbours to reach.
TEST(SoundScan, APartThatHangsOnNothingFacesOutward) {
  OrientedPoints truth = of("sphere");
  const std::size_t large = truth.size();
  const OrientedPoints small = of("sphere", 200);
  for (std::size_t i = 0; i < small.size(); ++i) {
    truth.positions.emplace_back(0.2 * small.positions[i] + Vector3d(150, 0, 0));
    truth.normals.push_back(small.normals[i]);
  }
  OrientedPoints turned_part = truth;
  for (std::size_t i = large; i < truth.size(); ++i) turned_part.normals[i] = -truth.normals[i];
  const SoundScan scan = sound_scan(turned_part);
  ASSERT_EQ(scan.strays, 0U);
  EXPECT_EQ(unlike(scan, truth), 0U);
  EXPECT_THAT(scan.warnings(), Contains("200 normals of closed parts that hang on nothing pointed inwards and were turned"));
  OrientedPoints bare = truth;
  bare.normals.assign(bare.size(), Vector3d::Zero());
  EXPECT_EQ(unlike(sound_scan(bare, {.estimate = true}), truth), 0U);
}

TEST(SoundScan, SignsByChanceAreMendedWhereNeighboursTell) {
  const OrientedPoints points = of("capsules");
  OrientedPoints random_signs = points;
  Random random(9);
  for (Vector3d& n : random_signs.normals) n = random.uniform() < 0.5 ? Vector3d(-n) : n;
  const SoundScan scan = sound_scan(random_signs);
  EXPECT_EQ(scan.outside, Outside::kNeighbours);
  EXPECT_LE(unlike(scan, points), 10U);
}

TEST(SoundScan, SaysNothingOfTurnedNormalsWhereThereWereNone) {
  OrientedPoints points = of("torus");
  for (Vector3d& n : points.normals) n.setZero();
  const SoundScan scan = sound_scan(points, {.estimate = true});
  ASSERT_EQ(scan.outside, Outside::kNeighbours);
  EXPECT_THAT(scan.warnings(), IsEmpty());
}

TEST(SoundScan, NamesThePointsWhoseNormalWasTurned) {
  OrientedPoints points = of("torus");
  std::vector<std::uint32_t> wrong;
  for (std::uint32_t i = 7; i < points.size(); i += 50) {
    points.normals[i] = -points.normals[i];
    wrong.push_back(i);
  }
  const SoundScan scan = sound_scan(points);
  ASSERT_EQ(scan.strays, 0U);
  EXPECT_EQ(scan.turned, wrong);
}

TEST(SoundScan, NormalsWithoutMeaningAreLeftAndSaidToBeDoubtful) {
  OrientedPoints points = of("sphere", 1000);
  Random random(9);
  for (Vector3d& n : points.normals) n = Vector3d(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)).normalized();
  const SoundScan scan = sound_scan(points);
  EXPECT_EQ(scan.outside, Outside::kDoubtful);
  EXPECT_THAT(scan.warnings(), Contains(HasSubstr("do not agree")));
}

TEST(SoundScanHeavy, FindsMostStraysAndHardlyASoundPoint) {
  const OrientedPoints points = of("owl");
  for (const double share : test::examples<double>({0.1, 0.02, 0.2})) {
    OrientedPoints more = points;
    Random random(12);
    const auto strays = static_cast<std::size_t>(share * static_cast<double>(points.size()));
    for (std::size_t n = 0; n < strays; ++n) {
      more.positions.emplace_back(random.uniform(-110, 110), random.uniform(-105, 105), random.uniform(-60, 60));
      more.normals.emplace_back(Vector3d(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1) + 1e-3).normalized());
    }
    const SoundScan scan = sound_scan(more);
    EXPECT_GT(static_cast<double>(scan.strays), 0.7 * static_cast<double>(strays)) << share;
    EXPECT_LT(static_cast<double>(scan.strays), 1.05 * static_cast<double>(strays)) << share;
  }
}

/// Root mean square of the distances to the shape.
double off(const SoundScan& scan, const char* shape) {
  const cloud::Shape truth = cloud::shape(shape);
  double squares = 0;
  for (const Vector3d& p : scan.points.positions) squares += truth.distance(p) * truth.distance(p);
  return std::sqrt(squares / static_cast<double>(scan.points.size()));
}

TEST(SoundScan, MeasuresNoiseAndTakesMostOfItBack) {
  for (const double noise : test::examples<double>({0.1, 0.05, 0.25, 0.5})) {
    OrientedPoints points = of("torus");
    Random random(2);
    for (Vector3d& p : points.positions) p += noise * 4 * scatter(random);  // spacing about 4
    const SoundScan scan = sound_scan(points);
    EXPECT_NEAR(scan.noise, noise * 4, 0.25 * noise * 4) << noise;
    EXPECT_LT(off(scan, "torus"), 0.5 * noise * 4) << noise;
  }
  EXPECT_LT(sound_scan(of("torus")).noise, 0.05);
}

TEST(SoundScan, TakesNormalsFromThePositionsWhereTheFilesAreOff) {
  const OrientedPoints points = of("torus");
  OrientedPoints tilted = points;
  Random random(7);
  for (Vector3d& n : tilted.normals)
    n = (n + 0.5 * Vector3d(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1))).normalized();
  const SoundScan scan = sound_scan(tilted);
  double before = 0, after = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    before += points.normals[i].cross(tilted.normals[i]).squaredNorm();
    after += points.normals[i].cross(scan.points.normals[i]).squaredNorm();
  }
  EXPECT_LT(after, 0.01 * before);
}

TEST(SoundScan, FindsNormalsOfAClosedSurfaceWithoutAny) {
  for (const char* name : test::examples<const char*>({"torus", "box", "capsules", "jaguar"})) {
    const OrientedPoints truth = of(name);
    OrientedPoints bare = truth;
    bare.normals.assign(bare.size(), Vector3d::Zero());
    const SoundScan scan = sound_scan(bare, {.estimate = true});
    ASSERT_EQ(scan.strays, 0U) << name;
    EXPECT_LE(unlike(scan, truth), truth.size() / 100) << name;
  }
}

/// A hollow ball with a wall of 3 whose inside has a tenth of the outside's 8,000 points.
OrientedPoints sparse_within() {
  OrientedPoints points;
  for (const auto& [count, radius, side] : {std::array{8000.0, 30.0, 1.0}, {800.0, 27.0, -1.0}}) {
    for (double i = 0.5; i < count; ++i) {
      const double z = 1.0 - 2.0 * i / count, turn = 2.399963229728653 * i, r = std::sqrt(1.0 - z * z);
      points.normals.emplace_back(side * r * std::cos(turn), side * r * std::sin(turn), side * z);
      points.positions.emplace_back(side * radius * points.normals.back());
    }
  }
  return points;
}

TEST(SoundScan, KeepsASideThatIsMuchSparserThanTheOther) {
  const SoundScan scan = sound_scan(sparse_within());
  EXPECT_EQ(scan.strays, 0U);
  EXPECT_EQ(scan.sparse, 800U);
  EXPECT_EQ(scan.unknown_side, 0);
}

TEST(SoundScan, WithoutNormalsSaysHowLargeASideIsThatWasLeftOut) {
  OrientedPoints bare = sparse_within();
  bare.normals.assign(bare.size(), Vector3d::Zero());
  const SoundScan scan = sound_scan(bare, {.estimate = true});
  EXPECT_EQ(scan.sparse, 0U);
  EXPECT_GT(scan.strays, 0U);
  EXPECT_GT(scan.unknown_side, 0.3);
  bare.positions.resize(8000);
  bare.normals.resize(8000);
  EXPECT_EQ(sound_scan(bare, {.estimate = true}).unknown_side, 0);
}

TEST(SoundScan, EqualNormalsOnABodyArePlaceholdersAndOnTerracesNot) {
  cloud::OrientedPoints torus = cloud::sample_shape(cloud::shape("torus"), 2000);
  for (const Vector3d& way : {Vector3d(0, 0, 1), Vector3d(1, 0, 0), Vector3d(1, 1, 1)}) {
    torus.normals.assign(torus.size(), way.normalized());
    EXPECT_THROW(sound_scan(torus), InputError) << way.transpose();
    EXPECT_NO_THROW(sound_scan(torus, {.estimate = true}));
  }
  cloud::OrientedPoints terraces, relief;
  for (int x = 0; x < 40; ++x) {
    for (int y = 0; y < 40; ++y) {
      terraces.positions.emplace_back(x, y, x / 10 * 5);
      relief.positions.emplace_back(x, y, 3 * std::sin(0.2 * x) * std::sin(0.2 * y));
    }
  }
  for (cloud::OrientedPoints* sheet : {&terraces, &relief}) {
    sheet->normals.assign(sheet->positions.size(), Vector3d(0, 0, 1));
    EXPECT_NO_THROW(sound_scan(*sheet));
  }
}

TEST(SoundScan, NormalsOfASheetWithoutAnyNeedAViewpoint) {
  const OrientedPoints truth = relief();
  OrientedPoints bare = truth;
  bare.normals.assign(bare.size(), Vector3d::Zero());
  EXPECT_THROW(sound_scan(bare, {.estimate = true}), InputError);
  const SoundScan scan = sound_scan(bare, {.estimate = true, .viewpoint = Vector3d(0, 0, 500)});
  EXPECT_EQ(scan.outside, Outside::kViewpoint);
  EXPECT_EQ(unlike(scan, truth), 0U);
}

}  // namespace
}  // namespace isotouch::field
