#include "host/cloud/check.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cstdlib>
#include <string>

#include "host/cloud/random.h"
#include "host/cloud/read_cloud.h"
#include "host/cloud/shapes.h"
#include "host/error.h"

namespace isotouch::cloud {
namespace {

using Eigen::Vector3d;

Model model_of(const OrientedPoints& points) { return {"test", points.positions, points.normals, {}, {}}; }

void expect_refused(const Model& model, const std::string& sentence) {
  CloudReport report;
  try {
    check("cloud", model, report);
    ADD_FAILURE() << sentence;
  } catch (const InputError& e) {
    EXPECT_THAT(e.what(), ::testing::HasSubstr("cloud: " + sentence));
  }
}

TEST(Check, AGoodCloudPassesUntouched) {
  const OrientedPoints cloud = sample_shape(shape("torus"), 500, 1);
  CloudReport report;
  const OrientedPoints checked = check("cloud", model_of(cloud), report);
  EXPECT_EQ(checked.positions, cloud.positions);
  EXPECT_THAT(report.warnings(), ::testing::IsEmpty());
  EXPECT_EQ(report.points_read, 500U);
  EXPECT_EQ(report.points, 500U);
  EXPECT_NEAR(median_spacing(checked.positions), 9.9, 1.0);  // hexagonal packing: 11.1
  EXPECT_NEAR(report.high.x(), 95.0, 1.0);
}

TEST(Check, PointsAtOnePlaceAreMergedInThePlaceOfTheFirst) {
  OrientedPoints cloud = sample_shape(shape("sphere"), 100, 1);
  const Vector3d tangent = cloud.normals[40].unitOrthogonal();
  cloud.positions.push_back(cloud.positions[40]);
  cloud.normals.push_back((cloud.normals[40] + 0.5 * tangent).normalized());
  CloudReport report;
  const OrientedPoints checked = check("cloud", model_of(cloud), report);
  EXPECT_EQ(checked.size(), 100U);
  EXPECT_EQ(report.merged, 1U);
  EXPECT_EQ(checked.positions[40], cloud.positions[40]);
  EXPECT_LT((checked.normals[40] - (cloud.normals[40] + cloud.normals[100]).normalized()).norm(), 1e-12);
  EXPECT_THAT(report.warnings(), ::testing::ElementsAre("1 point was merged with others at the same place"));
}

TEST(Check, PointsThatOnlyRoundingTellsApartAreMerged) {
  const OrientedPoints once = sample_shape(shape("sphere"), 500, 1);
  OrientedPoints cloud;
  Random random(3);
  for (int copy = 0; copy < 8; ++copy) {
    for (std::size_t i = 0; i < once.size(); ++i) {
      const Vector3d rounding(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
      cloud.positions.push_back(once.positions[i] + 1e-7 * rounding);
      cloud.normals.push_back(once.normals[i]);
    }
  }
  cloud.positions.emplace_back(1e9, 0, 0);  // says nothing of the object's size
  cloud.normals.emplace_back(1, 0, 0);
  CloudReport report;
  EXPECT_EQ(check("cloud", model_of(cloud), report).size(), 501U);  // wherever the borders of cells are
}

TEST(Check, PointsThatContradictEachOtherAreLeftOut) {
  OrientedPoints cloud = sample_shape(shape("sphere"), 100, 1);
  cloud.positions.push_back(cloud.positions[40]);
  cloud.normals.emplace_back(-cloud.normals[40]);
  CloudReport report;
  EXPECT_EQ(check("cloud", model_of(cloud), report).size(), 99U);
  EXPECT_EQ(report.contradictory, 2U);
  EXPECT_THAT(report.warnings(), ::testing::ElementsAre(::testing::HasSubstr("2 points were left out")));
}

TEST(Check, ACloudSavedOnceForEachSideKeepsOnePointOfEachPlace) {
  OrientedPoints cloud = sample_shape(shape("sphere"), 100, 1);
  for (std::size_t i = 0; i < 100; ++i) {
    cloud.positions.push_back(cloud.positions[i]);
    cloud.normals.emplace_back(-cloud.normals[i]);
  }
  CloudReport report;
  const OrientedPoints checked = check("cloud", model_of(cloud), report);
  EXPECT_EQ(checked.size(), 100U);
  EXPECT_EQ(checked.normals[7], cloud.normals[7]);
  EXPECT_TRUE(report.two_faced);
  EXPECT_THAT(report.warnings(), ::testing::ElementsAre(::testing::HasSubstr("opposite normals")));
}

/// So many times, each time moved a little at random.
OrientedPoints saved_again(const OrientedPoints& scan, int times, double moved) {
  OrientedPoints all = scan;
  Random random(7);
  for (int n = 1; n < times; ++n) {
    for (std::size_t i = 0; i < scan.size(); ++i) {
      all.positions.emplace_back(scan.positions[i] + moved * Vector3d(random.uniform(-2, 2), random.uniform(-2, 2), random.uniform(-2, 2)));
      all.normals.push_back(scan.normals[i]);
    }
  }
  return all;
}

TEST(Check, AScanThatWasSavedSeveralTimesIsOne) {
  const OrientedPoints cloud = sample_shape(shape("torus"), 1000, 1);
  const double spacing = median_spacing(cloud.positions);
  for (const int times : {2, 3, 5}) {
    for (const double moved : {1e-4, 0.01, 0.02}) {
      CloudReport report;
      const OrientedPoints checked = check("cloud", model_of(saved_again(cloud, times, moved * spacing)), report);
      EXPECT_EQ(checked.positions, cloud.positions) << times << ' ' << moved;
      EXPECT_EQ(report.merged, static_cast<std::size_t>(times - 1) * 1000);
    }
    CloudReport report;
    (void)check("cloud", model_of(saved_again(cloud, times, 0.2 * spacing)), report);
    EXPECT_EQ(report.merged, 0U) << "that is noise";
  }
}

TEST(Check, TheTwoSidesOfAThinSheetStay) {
  OrientedPoints sheet = sample_shape(shape("sphere"), 1000, 1);
  const double thickness = 0.01 * median_spacing(sheet.positions);
  for (std::size_t i = 0; i < 1000; ++i) {
    sheet.positions.emplace_back(sheet.positions[i] - thickness * sheet.normals[i]);
    sheet.normals.emplace_back(-sheet.normals[i]);
  }
  CloudReport report;
  EXPECT_EQ(check("cloud", model_of(sheet), report).positions, sheet.positions);
  EXPECT_THAT(report.warnings(), ::testing::IsEmpty());
}

TEST(Check, PointsWithoutNormalsPassAndAreSaidToHaveNone) {
  OrientedPoints cloud = sample_shape(shape("sphere"), 100, 1);
  cloud.positions.push_back(cloud.positions[3]);
  Model model = model_of(cloud);
  model.normals.clear();
  CloudReport report;
  const OrientedPoints checked = check("cloud", model, report);
  EXPECT_EQ(checked.size(), 100U);
  EXPECT_EQ(checked.normals.size(), 100U);
  EXPECT_FALSE(report.has_normals);
  EXPECT_EQ(report.merged, 1U);
}

TEST(Check, WhatMayBeNoNormalIsRefusedWithItsPlace) {
  for (const double length : {0.49, 2.01}) {
    Model model = model_of(sample_shape(shape("sphere"), 100, 1));
    model.normals[41] *= length;
    CloudReport report;
    EXPECT_THAT([&] { check("cloud.ply", model, report); },
                ::testing::ThrowsMessage<InputError>(::testing::HasSubstr("cloud.ply: point 42: the normal has length")))
        << length;
  }
}

TEST(Check, NormalsFarFromUnitLengthAreCounted) {
  Model model = model_of(sample_shape(shape("sphere"), 100, 1));
  model.normals[0] *= 0.51;
  for (const std::size_t i : {41U, 50U, 60U}) model.normals[i] *= 0.25;
  model.normals[70] *= 3.0;
  model.normals[80].setZero();
  expect_refused(model,
                 "point 42: the normal has length 0.250000 instead of 1, and 4 of 100 normals are that far off; normalise them, or choose "
                 "--normals estimate");
}

TEST(Check, ACoordinateThatIsTooLargeIsRefusedWithItsPlace) {
  for (const double coordinate : {1.001e12, -1.001e12, 1e300, -1e300}) {
    for (int axis = 0; axis < 3; ++axis) {
      Model model = model_of(sample_shape(shape("sphere"), 100, 1));
      model.positions[41][axis] = coordinate;
      CloudReport report;
      EXPECT_THAT([&] { check("cloud.ply", model, report); },
                  ::testing::ThrowsMessage<InputError>(::testing::HasSubstr("cloud.ply: point 42: a coordinate is larger than 1e12")))
          << coordinate;
    }
  }
}

TEST(Check, NormalsNearlyOfUnitLengthAreBroughtToIt) {
  OrientedPoints cloud = sample_shape(shape("sphere"), 100, 1);
  cloud.normals[3] *= 1.5;
  cloud.normals[4] *= 1.005;  // rounding in a text: not worth a word
  CloudReport report;
  const OrientedPoints checked = check("cloud", model_of(cloud), report);
  EXPECT_EQ(report.renormalised, 1U);
  EXPECT_NEAR(checked.normals[3].norm(), 1.0, 1e-15);
  EXPECT_NEAR(checked.normals[4].norm(), 1.0, 1e-15);
}

TEST(Check, FewPointsWithoutNormalAreLeftOutAndManyRefused) {
  OrientedPoints cloud = sample_shape(shape("sphere"), 100, 1);
  const auto set_zero = [&](std::size_t count) { std::fill_n(cloud.normals.begin() + 10, count, Vector3d::Zero()); };
  set_zero(10);
  Model model = model_of(cloud);
  model.stiffness.assign(100, 1.0);
  model.stiffness[20] = 2.0;
  CloudReport report;
  const OrientedPoints checked = check("cloud", model, report);
  ASSERT_EQ(checked.size(), 90U);
  EXPECT_EQ(checked.positions[10], cloud.positions[20]);
  EXPECT_EQ(checked.normals[10], cloud.normals[20]);
  EXPECT_EQ(checked.stiffness[10], 2.0);
  EXPECT_THAT(report.warnings(),
              ::testing::ElementsAre("10 points were left out: the normal is zero, or it or a coordinate is not a finite number"));
  set_zero(11);
  expect_refused(
      model_of(cloud),
      "point 11: the normal is zero or not a finite number, as at 11 of 100 points; remove these points, or choose --normals estimate");
  set_zero(10);
  cloud.normals[50] *= 3.0;
  expect_refused(model_of(cloud), "point 51: the normal has length 3");
  cloud.normals.assign(100, Vector3d::Zero());
  expect_refused(model_of(cloud), "all normals are zero or not finite numbers; choose --normals estimate");
}

TEST(Check, NormalsThatAreCodedWithoutASignAreRefused) {
  const OrientedPoints cloud = sample_shape(shape("sphere"), 100, 1);
  for (const double one : {1.0, 255.0}) {
    OrientedPoints coded = cloud;
    for (Vector3d& n : coded.normals) n = (127.5 * (n + Vector3d::Ones())).array().round() * one / 255;
    expect_refused(model_of(coded), "the normals are never negative, but coded as (n + 1) / 2");
  }
  OrientedPoints octant;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if (cloud.normals[i].minCoeff() < 0) continue;
    octant.positions.push_back(cloud.positions[i]);
    octant.normals.push_back(cloud.normals[i]);
  }
  CloudReport report;
  EXPECT_GT(check("cloud", model_of(octant), report).size(), 8U);
}

TEST(Check, PointsAtOnePlaceShareTheirMeanStiffness) {
  OrientedPoints cloud = sample_shape(shape("torus"), 100, 1);
  for (std::size_t i = 0; i < cloud.size(); ++i) cloud.stiffness.push_back(0.5 + 0.001 * static_cast<double>(i));
  for (const double stiffness : {2.0, 3.0}) {
    cloud.positions.push_back(cloud.positions[7]);
    cloud.normals.push_back(cloud.normals[7]);
    cloud.stiffness.push_back(stiffness);
  }
  Model model = model_of(cloud);
  model.stiffness = cloud.stiffness;
  CloudReport report;
  const OrientedPoints checked = check("cloud", model, report);
  ASSERT_EQ(checked.stiffness.size(), 100U);
  EXPECT_NEAR(checked.stiffness[7], (0.507 + 2.0 + 3.0) / 3, 1e-12);
  EXPECT_EQ(checked.stiffness[8], 0.508);
  EXPECT_TRUE(check("cloud", model_of(cloud), report).stiffness.empty());
}

TEST(Check, AStiffnessThatNoSurfaceHasIsRefusedWithItsPlace) {
  Model model = model_of(sample_shape(shape("torus"), 100, 1));
  for (const double wrong : {0.0, -1.0, 100.001, 1e300}) {
    model.stiffness.assign(100, 0.8);
    model.stiffness[41] = wrong;
    CloudReport report;
    try {
      check("cloud.ply", model, report);
      ADD_FAILURE() << wrong;
    } catch (const InputError& e) {
      EXPECT_THAT(e.what(), ::testing::HasSubstr("cloud.ply: point 42: the stiffness is"));
    }
  }
  model.stiffness[41] = 100.0;
  CloudReport report;
  EXPECT_EQ(check("cloud.ply", model, report).stiffness[41], 100.0);
}

TEST(CheckFrame, NormalsFarFromUnitLengthCountAsNone) {
  Model model = model_of(sample_shape(shape("sphere"), 100, 1));
  const std::vector<Vector3d> before = model.normals;
  model.normals[3] *= 0.4;
  model.normals[4] *= 3.0;
  model.normals[5] *= 1e-7;
  model.normals[6] *= 1.9;
  check_frame("frame", model);
  for (const std::size_t none : {std::size_t{3}, std::size_t{4}, std::size_t{5}}) EXPECT_EQ(model.normals[none], Vector3d(0, 0, 0));
  EXPECT_EQ(model.normals[6], 1.9 * before[6]);
  EXPECT_EQ(model.normals[7], before[7]);
  model.normals.clear();
  check_frame("frame", model);  // it may have none
}

TEST(CheckFrame, CodedNormalsAreRefused) {
  for (const double one : {1.0, 255.0}) {
    Model model = model_of(sample_shape(shape("sphere"), 100, 1));
    for (Vector3d& normal : model.normals) normal = one / 2 * (normal + Vector3d::Ones());
    EXPECT_THROW(check_frame("frame", model), InputError) << one;
  }
  Model single{"test", {Vector3d(1, 2, 3)}, {Vector3d(0.6, 0.0, 0.8)}, {}, {}};
  EXPECT_NO_THROW(check_frame("frame", single));
}

}  // namespace
}  // namespace isotouch::cloud
