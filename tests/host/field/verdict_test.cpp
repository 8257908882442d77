#include "host/field/verdict.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <string>

#include "host/cloud/check.h"
#include "host/cloud/random.h"
#include "host/cloud/shapes.h"
#include "host/field/scan_field.h"
#include "host/field/spacings.h"
#include "tests/support/sanitized.h"

namespace isotouch::field {
namespace {

using cloud::OrientedPoints;
using cloud::Random;
using Eigen::Vector3d;
using ::testing::AnyOf;
using ::testing::Contains;
using ::testing::Each;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

OrientedPoints of(const char* shape, std::size_t count = 3000) { return cloud::sample_shape(cloud::shape(shape), count); }

Verdict verdict_of(const OrientedPoints& points) {
  Progress progress;
  return scan_field(sound_scan(points), 1.6, kBand, progress).verdict;
}

TEST(Verdict, CleanScansArePlausible) {
  for (const char* name : test::examples<const char*>({"torus", "sphere", "box", "owl"})) {
    const Verdict verdict = verdict_of(of(name));
    EXPECT_THAT(verdict.reasons, IsEmpty()) << name;
    EXPECT_LT(verdict.noise_spacing, 0.05) << name;
    EXPECT_LT(verdict.off_surface_share, 0.01) << name;
    EXPECT_LT(verdict.gap_share, 0.001) << name;
  }
}

TEST(Verdict, TheVolumeOfTheHullIsThatOfGeometry) {
  EXPECT_NEAR(verdict_of(of("sphere")).volume_of_hull, 1.0, 0.06);
  // A torus' hull: two half balls' worth of rounding round a disc of its tube's height.
  const double ring = 70, tube = 25;
  const double torus = 2 * M_PI * M_PI * ring * tube * tube;
  const double hull = M_PI * ring * ring * 2 * tube + torus / 2 + M_PI * 4.0 / 3 * tube * tube * tube;
  EXPECT_NEAR(verdict_of(of("torus")).volume_of_hull, torus / hull, 0.06);
}

TEST(VerdictHeavy, WithoutNormalsAThinWallIsNoNoise) {
  OrientedPoints wall = cloud::sample_shape(cloud::shape("sphere"), 4000);
  const double spacing = cloud::median_spacing(wall.positions);
  Random random(3);
  for (std::size_t i = 0; i < wall.size(); ++i) {
    const bool inner = random.uniform() < 0.5;
    wall.positions[i] -= (inner ? 0.4 * spacing : 0.0) * wall.normals[i];
  }
  Progress progress;
  const Verdict verdict = scan_field(sound_scan(std::move(wall), {.estimate = true}), 1.6, kBand, progress).verdict;
  EXPECT_THAT(verdict.reasons, Contains(HasSubstr("two layers")));
  EXPECT_THAT(verdict.reasons, Contains(HasSubstr("or scans that do not fit; align the scans that were merged, save")));
}

TEST(VerdictHeavy, HalvesOfAScanThatOverlapBesideEachOtherAreRefused) {
  const OrientedPoints points = of("sphere", 5000);
  const double spacing = cloud::median_spacing(points.positions);
  for (const double apart : test::examples<double>({4.0, 7.0})) {
    OrientedPoints merged;
    for (std::size_t i = 0; i < points.size(); ++i) {
      for (const double side : {-1.0, 1.0}) {
        if (side * points.positions[i].x() < -20) continue;
        merged.positions.push_back(points.positions[i] + side * apart / 2 * spacing * Vector3d(0.3, 0.6, 0.74));
        merged.normals.push_back(points.normals[i]);
      }
    }
    EXPECT_THAT(verdict_of(merged).reasons, Contains(HasSubstr("another layer"))) << apart;
  }
  EXPECT_THAT(verdict_of(points).reasons, IsEmpty());
}

TEST(VerdictHeavy, AWallSeenThroughAnOpeningIsRefused) {
  const OrientedPoints ball = of("sphere", 5000);
  OrientedPoints seen = ball;
  for (std::size_t i = 0; i < ball.size(); ++i) {
    if (ball.positions[i].z() > -70) continue;
    seen.positions.push_back(0.8 * ball.positions[i]);
    seen.normals.push_back(-ball.normals[i]);
  }
  EXPECT_THAT(verdict_of(seen).reasons, Contains(HasSubstr("form patches")));
}

TEST(Verdict, ACavityRoundABallInTheBodyIsRefused) {
  OrientedPoints points = of("box");
  const OrientedPoints ball = of("sphere", 100);
  double least = 1e9;
  for (const Vector3d& p : points.positions) least = std::min(least, p.norm());
  const double scale = 0.35 * least / ball.positions.front().norm();
  for (std::size_t i = 0; i < ball.size(); ++i) {
    points.positions.push_back(scale * ball.positions[i]);
    points.normals.push_back(ball.normals[i]);
  }
  const Verdict verdict = verdict_of(points);
  EXPECT_THAT(verdict.reasons, Contains(HasSubstr("remove points within the body")));
  EXPECT_GT(verdict.invented_share, 0.01);
}

TEST(VerdictHeavy, WallsThinnerThanTheVoxelsAllowAreRefused) {
  const auto plate = [](double voxel) {
    Progress progress;
    return scan_field(sound_scan(of("plate")), voxel, kBand, progress).verdict;
  };
  const Verdict coarse = plate(3.2);  // 1.25 voxels
  EXPECT_THAT(coarse.reasons, Contains(HasSubstr("walls thinner than two voxels")));
  EXPECT_GT(coarse.thin_share, 0.99);
  const Verdict fine = plate(1.6);  // 2.5
  EXPECT_THAT(fine.reasons, IsEmpty());
  EXPECT_LT(fine.thin_share, 0.2);
}

TEST(VerdictHeavy, CoordinatesOfTooFewDigitsAreRefused) {
  const auto rounded = [](const char* shape, double step) {
    OrientedPoints points = of(shape, 6000);
    for (Vector3d& p : points.positions) p = step * (p / step).array().round().matrix();
    return verdict_of(points).reasons;
  };
  EXPECT_THAT(rounded("torus", 8.0), Contains(HasSubstr("rounded to steps of 5.0 voxels")));
  EXPECT_THAT(rounded("torus", 3.2), IsEmpty());
  EXPECT_THAT(rounded("box", 8.0), Each(Not(HasSubstr("rounded")))) << "its faces lie on the lattice";
}

TEST(Verdict, LinesFarApartNeedNormals) {
  SoundScan sound = sound_scan(of("sphere"));
  Progress progress;
  const ScanField built = scan_field(sound, 1.6, kBand, progress);
  const auto reasons = [&](double in_lines) {
    sound.in_lines = in_lines;
    return judge(built.field, sound, built.repair, Spacings(sound.points)).reasons;
  };
  EXPECT_THAT(reasons(0.24), IsEmpty());
  EXPECT_THAT(reasons(0.26), Contains(HasSubstr("scan more lines")));
}

TEST(Verdict, EstimatedNormalsNeedMoreDigits) {
  SoundScan sound = sound_scan(of("sphere"));
  Progress progress;
  const ScanField built = scan_field(sound, 1.6, kBand, progress);
  const auto reasons = [&](double voxels, bool is_estimated) {
    sound.rounding = 1.6 * voxels;
    sound.is_estimated = is_estimated;
    return judge(built.field, sound, built.repair, Spacings(sound.points)).reasons;
  };
  EXPECT_THAT(reasons(4.4, false), IsEmpty());
  EXPECT_THAT(reasons(4.6, false), Contains(HasSubstr("rounded to steps of 4.6 voxels")));
  EXPECT_THAT(reasons(2.9, true), IsEmpty());
  EXPECT_THAT(reasons(3.1, true), Contains(HasSubstr("rounded to steps of 3.1 voxels")));
}

/// Whatever the other axes are: a map's coordinates are larger along one axis than along another.
TEST(Verdict, FloatsTooFarFromTheOriginAreRefused) {
  OrientedPoints far = of("sphere");
  for (Vector3d& p : far.positions) p = (p + Vector3d(0, 100'000, 0)).cast<float>().cast<double>();
  SoundScan sound = sound_scan(far);
  EXPECT_EQ(sound.float_step, std::ldexp(1.0, -7));
  cloud::Placement placement;
  placement.scale = 0.5;
  sound.place(placement);
  EXPECT_EQ(sound.float_step, std::ldexp(1.0, -8));

  sound = sound_scan(of("sphere"));
  EXPECT_EQ(sound.float_step, 0.0);
  Progress progress;
  const ScanField built = scan_field(sound, 1.6, kBand, progress);
  const auto reasons = [&](double voxels, bool is_estimated) {
    sound.float_step = 1.6 * voxels;
    sound.is_estimated = is_estimated;
    return judge(built.field, sound, built.repair, Spacings(sound.points)).reasons;
  };
  EXPECT_THAT(reasons(4.4, false), IsEmpty());
  EXPECT_THAT(reasons(4.6, false), Contains(HasSubstr("32-bit floats have steps of 4.6 voxels there; shift the scan to a local origin")));
  EXPECT_THAT(reasons(2.9, true), IsEmpty());
  EXPECT_THAT(reasons(3.1, true), Contains(HasSubstr("32-bit floats have steps of 3.1 voxels")));
}

TEST(VerdictHeavy, NormalsWithoutMeaningAreRefused) {
  OrientedPoints points = of("sphere");
  for (std::size_t i = 0; i < points.size(); ++i) points.normals[i] = points.normals[(7 * i + 13) % points.size()];
  EXPECT_THAT(verdict_of(points).reasons, Contains(HasSubstr("normals")));
}

TEST(Verdict, AScanThatWasTurnedAsAWholeIsPlausible) {
  OrientedPoints points = of("torus");
  for (Vector3d& n : points.normals) n = -n;
  const Verdict verdict = verdict_of(points);
  EXPECT_GT(verdict.turned_share, 0.99);
  EXPECT_THAT(verdict.reasons, IsEmpty());
}

TEST(Verdict, AViewpointTurnsAWholeViewButNotTheHiddenSide) {
  const Vector3d sensor(0, 0, 1000);
  const OrientedPoints whole = of("sphere");
  OrientedPoints view;
  for (std::size_t i = 0; i < whole.size(); ++i) {
    if (whole.positions[i].z() < 10) continue;
    view.positions.push_back(whole.positions[i]);
    view.normals.push_back(-whole.normals[i]);
  }
  const auto reasons = [&](const OrientedPoints& points) {
    Progress progress;
    return scan_field(sound_scan(points, {.estimate = false, .viewpoint = sensor}), 1.6, kBand, progress).verdict.reasons;
  };
  EXPECT_THAT(reasons(view), IsEmpty());
  EXPECT_THAT(reasons(whole), Contains(HasSubstr("had to be turned")));
  EXPECT_THAT(reasons(whole).front(), HasSubstr("leave out --viewpoint"));
}

/// Both faces of a plate that is thicker than neighbours reach: nothing but the sensor's place says which side is out, and says it wrong of one face.
TEST(Verdict, AViewpointThatSawHalfOfThePointsIsRefused) {
  OrientedPoints plate;
  Random random(1);
  for (int i = 0; i < 5000; ++i) plate.positions.emplace_back(random.uniform(-70, 70), random.uniform(-70, 70), i % 2 == 0 ? 5 : -5);
  plate.normals.assign(plate.size(), Vector3d::Zero());
  Progress progress;
  const auto reasons = [&](SensorFrom from) {
    const SoundScan sound = sound_scan(plate, {.estimate = true, .viewpoint = Vector3d(0, 0, 1000), .from = from});
    return scan_field(sound, 1.6, kBand, progress).verdict.reasons;
  };
  ASSERT_THAT(reasons(SensorFrom::kPerson), Contains(HasSubstr("lie behind others as seen from the sensor's place")));
  EXPECT_THAT(reasons(SensorFrom::kPerson).front(), HasSubstr("leave out --viewpoint"));
  EXPECT_THAT(reasons(SensorFrom::kFile).front(), HasSubstr("ignore the file's line VIEWPOINT with --no-viewpoint"));
  EXPECT_THAT(reasons(SensorFrom::kAssumption).front(), HasSubstr("say with --viewpoint where the sensor stood"));
  EXPECT_THAT(reasons(SensorFrom::kDepthImage).front(),
              "if the depth image shows more than the object, such as a wall behind it, set pixels that are not the object to 0");
  EXPECT_THAT(reasons(SensorFrom::kDepthImage), Each(Not(AnyOf(HasSubstr("viewpoint"), HasSubstr("VIEWPOINT")))));
}

/// One side of a body on a table is built as it is, because a relief with a flat edge is no worse; only what is refused anyway is explained by it.
TEST(Verdict, AFlatEdgeOfOneSideExplainsARefusalAndMakesNone) {
  SoundScan sound = sound_scan(of("sphere"));
  Progress progress;
  const ScanField built = scan_field(sound, 1.6, kBand, progress);
  sound.is_sheet = true;
  sound.is_on_table = true;
  EXPECT_THAT(judge(built.field, sound, built.repair, Spacings(sound.points)).reasons, IsEmpty());
  Repair repair = built.repair;
  repair.unexplained = 0.5;
  EXPECT_THAT(
      judge(built.field, sound, repair, Spacings(sound.points)).reasons,
      ElementsAre("the scan ends at the edge of a flat part; if that is a table or a wall, remove it", HasSubstr("no smooth surface")));
}

TEST(Verdict, SeveralFiguresNearTheirLimitsAreRefusedTogether) {
  const SoundScan sound = sound_scan(of("sphere"));
  Progress progress;
  const ScanField built = scan_field(sound, 1.6, kBand, progress);
  const auto reasons = [&](double surprising, double unexplained, double twice) {
    Repair repair = built.repair;
    repair.surprising = surprising;
    repair.unexplained = unexplained;
    repair.twice_enclosed = twice;
    return judge(built.field, sound, repair, Spacings(sound.points)).reasons;
  };
  EXPECT_THAT(reasons(0.018, 0.36, 0.0), IsEmpty());
  EXPECT_THAT(reasons(0.0, 0.36, 0.027), IsEmpty());
  const auto together = reasons(0.0195, 0.38, 0.0285);
  ASSERT_EQ(together.size(), 1U);
  EXPECT_THAT(together[0], HasSubstr("near their limits, above all this: 1.9 % of the surface has points where"));
}

TEST(Verdict, WhatExplainsOtherReasonsStandsBeforeThem) {
  SoundScan sound = sound_scan(of("sphere"));
  Progress progress;
  ScanField built = scan_field(sound, 1.6, kBand, progress);
  built.repair.twice_enclosed = built.repair.surprising = built.repair.unexplained = 0.9;
  built.repair.debris.pieces = 1000;
  sound.layered = 0.9;
  sound.rounding = sound.float_step = 9.0;
  sound.outside = Outside::kDoubtful;
  sound.hidden = 0.5;
  sound.noise = sound.spacing;
  sound.in_lines = 0.5;
  sound.strays = sound.measured;
  sound.rim.samples = 100;
  sound.rim.least_surrounded = 0.0;
  sound.rim.patches = 100;
  sound.enclosed = 0.5 * sound.enclosed;
  for (std::size_t i = 0; i < sound.points.size(); i += 3) sound.points.normals[i] = -sound.points.normals[i];
  for (std::uint32_t i = 0; i < sound.measured / 2; ++i) sound.turned.push_back(i);
  EXPECT_THAT(judge(built.field, sound, built.repair, Spacings(sound.points)).reasons,
              ElementsAre(HasSubstr("another layer"), HasSubstr("two layers"), HasSubstr("rounded"), HasSubstr("32-bit floats"),
                          HasSubstr("do not agree on which side"), HasSubstr("behind others"), HasSubstr("scatter"), HasSubstr("in lines"),
                          HasSubstr("strays; remove"), HasSubstr("cut off"), HasSubstr("patches"), HasSubstr("point against"),
                          HasSubstr("had to be turned"), HasSubstr("no smooth surface"), HasSubstr("do not expect"),
                          HasSubstr("of the volume"), HasSubstr("no points support")));
}

TEST(Verdict, StepsAlongOneAxisExplainOtherReasons) {
  OrientedPoints points = of("sphere");
  for (Vector3d& p : points.positions) p.y() = 4.8 * std::round(p.y() / 4.8);
  SoundScan sound = sound_scan(points);
  EXPECT_NEAR(sound.coarsest.step, 4.8, 1e-9);
  ASSERT_EQ(sound.rounding, 0.0) << "of all axes";
  Progress progress;
  ScanField built = scan_field(sound, 1.5, kBand, progress);
  const auto reasons = [&](double surprising, double edge_of_step) {
    built.repair.surprising = surprising;
    sound.coarsest.step = 1.5 * edge_of_step;
    return judge(built.field, sound, built.repair, Spacings(sound.points)).reasons;
  };
  EXPECT_THAT(reasons(0.0, 3.2), Each(Not(HasSubstr("come in steps")))) << "nothing to be explained";
  EXPECT_THAT(reasons(0.9, 3.2).front(),
              "the coordinates along y come in steps of 3.2 voxels; if they are rounded, save the scan with more digits");
  EXPECT_THAT(reasons(0.9, 2.9), Each(Not(HasSubstr("come in steps"))));
  sound.float_step = 9.0;
  EXPECT_THAT(reasons(0.9, 3.2), Each(Not(HasSubstr("come in steps")))) << "the floats are named";
}

TEST(Verdict, OfSurprisesOnAFinerGridThanUsualTheGridIsNamedFirst) {
  const SoundScan sound = sound_scan(of("sphere"));
  Progress progress;
  Eigen::AlignedBox3d box;
  for (const Vector3d& point : sound.points.positions) box.extend(point);
  const double usual = box.sizes().maxCoeff() / sound.usual_grid(box.sizes());
  for (const bool is_finer : {false, true}) {
    const ScanField built = scan_field(sound, is_finer ? 0.9 * usual : 1.1 * usual, kBand, progress);
    Repair repair = built.repair;
    repair.surprising = 0.03;
    const auto reasons = judge(built.field, sound, repair, Spacings(sound.points)).reasons;
    EXPECT_THAT(reasons, Contains(HasSubstr(is_finer ? "do not expect them; leave out --voxel and --grid or choose a coarser one, scan more"
                                                     : "do not expect them; scan more densely")));
  }
}

TEST(Verdict, SurprisesWeighMoreInNoise) {
  SoundScan sound = sound_scan(of("sphere"));
  Progress progress;
  const ScanField built = scan_field(sound, 1.6, kBand, progress);
  Repair repair = built.repair;
  const auto reasons = [&](double noise_spacing, double surprising) {
    sound.noise = noise_spacing * sound.spacing;
    repair.surprising = surprising;
    return judge(built.field, sound, repair, Spacings(sound.points)).reasons;
  };
  EXPECT_THAT(reasons(0.0, 0.019), IsEmpty());
  EXPECT_THAT(reasons(0.0, 0.021), Contains(HasSubstr("do not expect")));
  EXPECT_THAT(reasons(0.5, 0.0095), IsEmpty());
  EXPECT_THAT(reasons(0.5, 0.0105), Contains(HasSubstr("do not expect")));
  EXPECT_THAT(reasons(0.79, 0.0), IsEmpty());
  // Where no surprise is allowed, the other figures count together all the same.
  repair.unexplained = 0.39;
  repair.twice_enclosed = 0.029;
  repair.debris.pieces = 145;
  EXPECT_THAT(reasons(0.79, 0.0), ElementsAre(HasSubstr("several figures")));
}

TEST(Verdict, AHoleOfHalfTheObjectIsRefused) {
  const OrientedPoints whole = of("torus");
  OrientedPoints points;
  for (std::size_t i = 0; i < whole.size(); ++i) {
    if ((whole.positions[i] - Vector3d(95, 0, 0)).norm() < 80) continue;
    points.positions.push_back(whole.positions[i]);
    points.normals.push_back(whole.normals[i]);
  }
  const Verdict verdict = verdict_of(points);
  EXPECT_THAT(verdict.reasons, Contains(HasSubstr("nobody scanned")));
  EXPECT_GT(verdict.rim_mm, 100);
}

/// A finger along x that ends in half a ball at 0 and is cut off at `length`; points about 1.2 apart.
OrientedPoints finger(double length, double radius = 20) {
  const double golden = M_PI * (3 - std::sqrt(5.0)), area = 1.44;
  OrientedPoints points;
  double x = -radius;  // of a ball and of a tube round it, slices have the same area
  for (int i = 0; x < length; ++i, x += area / (2 * M_PI * radius)) {
    const double around = x < 0 ? std::sqrt(radius * radius - x * x) : radius;
    const Vector3d normal(x < 0 ? x / radius : 0.0, around / radius * std::cos(golden * i), around / radius * std::sin(golden * i));
    points.positions.push_back(radius * normal + Vector3d(std::max(x, 0.0), 0, 0));
    points.normals.push_back(normal);
  }
  return points;
}

TEST(VerdictHeavy, ASmallEndThatWasCutOffIsFlat) {
  const Verdict verdict = verdict_of(finger(200));
  EXPECT_THAT(verdict.reasons, IsEmpty());
  EXPECT_GT(verdict.invented_share, 0.03);
  EXPECT_LT(verdict.gap_share, 0.002);
  EXPECT_NEAR(verdict.volume_of_enclosed, 1, 0.03);
  EXPECT_THAT(verdict_of(finger(60)).reasons, Contains(HasSubstr("closes gaps"))) << "of a short one more may well be missing";
  OrientedPoints ball = of("sphere");
  std::erase_if(ball.positions, [](const Vector3d& p) { return p.z() > 20; });
  ball.normals.clear();
  for (const Vector3d& p : ball.positions) ball.normals.push_back(p.normalized());
  EXPECT_THAT(verdict_of(ball).reasons, Contains(HasSubstr("closes gaps")));
}

/// A limb that ends in the air is no better because the body ends in a plane.
TEST(VerdictHeavy, ACleanCutExcusesNoOtherEnd) {
  constexpr double kBody = 30, kLimb = 3;
  OrientedPoints body = finger(270, kBody), points;
  for (std::size_t i = 0; i < body.size(); ++i) {
    const Vector3d& p = body.positions[i];
    if (p.z() > 0 && std::hypot(p.x() - 80, p.y()) < kLimb) continue;
    points.positions.push_back(p);
    points.normals.push_back(body.normals[i]);
  }
  const double golden = M_PI * (3 - std::sqrt(5.0));
  for (int i = 0; i < 470; ++i) {
    const Vector3d normal(std::cos(golden * i), std::sin(golden * i), 0);
    const Vector3d p = kLimb * normal + Vector3d(80, 0, kBody - 0.3 + 0.053 * i);
    if (std::hypot(p.y(), p.z()) < kBody) continue;
    points.positions.push_back(p);
    points.normals.push_back(normal);
  }
  ASSERT_TRUE(sound_scan(points).is_capped);
  EXPECT_THAT(
      verdict_of(points).reasons,
      ElementsAre(::testing::ContainsRegex("a limb or a wall is cut off in the scan near \\((79|80)\\.[0-9]+, .*, 5[0-9]\\.[0-9]+\\)")));
}

/// Strays far away have none like them at the surface, so they excuse no surprises there. Without normals the points of a part that is too sparse count as
/// strays, and excuse none either.
TEST(Verdict, StraysExcuseSurprisesWhereTheyAre) {
  const auto reasons_with_strays = [](double half, bool estimated = false) {
    OrientedPoints points = of("sphere");
    Random random(5);
    for (int n = 0; n < 300; ++n) {
      points.positions.emplace_back(random.uniform(-half, half), random.uniform(-half, half), random.uniform(-half, half));
      points.normals.emplace_back(Vector3d(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1) + 1e-3).normalized());
    }
    SoundScan sound = sound_scan(points);
    EXPECT_GT(sound.strays, 180U);
    Progress progress;
    ScanField built = scan_field(sound, 1.6, kBand, progress);
    built.repair.surprising = 0.03;
    sound.is_estimated = estimated;
    return judge(built.field, sound, built.repair, Spacings(sound.points)).reasons;
  };
  EXPECT_THAT(reasons_with_strays(85), Each(Not(HasSubstr("do not expect"))));
  EXPECT_THAT(reasons_with_strays(2000), Contains(HasSubstr("do not expect")));
  EXPECT_THAT(reasons_with_strays(85, true), Contains(HasSubstr("do not expect")));
}

TEST(Verdict, StraysAreCountedAndDoNotSpoilIt) {
  OrientedPoints points = of("torus");
  Random random(3);
  for (int n = 0; n < 150; ++n) {
    points.positions.emplace_back(random.uniform(-114, 114), random.uniform(-114, 114), random.uniform(-40, 40));
    points.normals.emplace_back(Vector3d(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1) + 1e-3).normalized());
  }
  const Verdict verdict = verdict_of(points);
  EXPECT_THAT(verdict.reasons, IsEmpty());
  EXPECT_NEAR(verdict.stray_share, 150.0 / 3150, 0.02);
}

}  // namespace
}  // namespace isotouch::field
