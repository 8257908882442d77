#include "host/field/thinning.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "host/cloud/random.h"
#include "host/cloud/shapes.h"

namespace isotouch::field {
namespace {

using Eigen::Vector3d;

/// To one sample a voxel and side.
Thinned thinned(const cloud::OrientedPoints& points) {
  const CellOrder order(points.positions);
  return thinned(points, order, order.cells(0));
}

/// A square of 10 by 10 voxels at one height.
void add_sheet(cloud::OrientedPoints& points, double height, const Vector3d& normal, std::size_t count, std::uint64_t seed) {
  cloud::Random random(seed);
  for (std::size_t i = 0; i < count; ++i) {
    const double x = 10.0 * random.uniform();
    points.positions.emplace_back(x, 10.0 * random.uniform(), height);
    points.normals.push_back(normal);
  }
}

TEST(Thinned, KeepsOneSampleACellAndMovesNone) {
  cloud::OrientedPoints points;
  add_sheet(points, 0.5, Vector3d::UnitZ(), 20000, 1);
  const auto kept = thinned(points).samples;
  EXPECT_EQ(kept.size(), 100U);
  for (const Vector3d& p : kept.positions) {
    EXPECT_NE(std::find(points.positions.begin(), points.positions.end(), p), points.positions.end());
    const Vector3d middle = p.array().floor() + 0.5;
    EXPECT_LT((p - middle).norm(), 0.1);
  }
}

TEST(Thinned, LeavesASparseCloudAsItIs) {
  const auto points = cloud::sample_shape(cloud::shape("sphere"), 1000);
  auto kept = thinned(points).samples.positions;
  auto before = points.positions;
  const auto order = [](const Vector3d& a, const Vector3d& b) { return std::tuple(a.x(), a.y(), a.z()) < std::tuple(b.x(), b.y(), b.z()); };
  std::sort(kept.begin(), kept.end(), order);
  std::sort(before.begin(), before.end(), order);
  EXPECT_EQ(kept, before);
}

TEST(Thinned, KeepsBothSidesOfAThinPlateAndDropsStrayNormals) {
  cloud::OrientedPoints plate;
  add_sheet(plate, 0.3, -Vector3d::UnitZ(), 5000, 2);
  add_sheet(plate, 0.7, Vector3d::UnitZ(), 5000, 3);
  EXPECT_EQ(thinned(plate).samples.size(), 200U);

  cloud::OrientedPoints strays;
  add_sheet(strays, 0.5, Vector3d::UnitZ(), 20000, 4);
  for (std::size_t i = 0; i < strays.size(); i += 16) strays.normals[i] = -Vector3d::UnitZ();
  const auto kept = thinned(strays).samples;
  EXPECT_EQ(kept.size(), 100U);
  EXPECT_TRUE(std::all_of(kept.normals.begin(), kept.normals.end(), [](const Vector3d& n) { return n.z() > 0.0; }));
}

TEST(Thinned, LeavesOutLonePointsAtAnEdgeAndCountsThemWithTheLargerGroup) {
  cloud::OrientedPoints points;
  add_sheet(points, 0.5, Vector3d::UnitZ(), 20000, 4);
  for (const double x : {2.5, 7.5}) points.positions.emplace_back(x, 5.5, 0.5), points.normals.push_back(Vector3d::UnitX());
  const CellOrder order(points.positions);
  const Thinned thin = thinned(points, order, order.cells(0));
  EXPECT_EQ(thin.samples.size(), 100U);
  EXPECT_EQ(std::count(thin.sample_of.begin(), thin.sample_of.end(), Thinned::kStray), 0);
  for (std::size_t n = 0; n < 20; ++n) points.positions.emplace_back(2.5, 5.5, 0.5), points.normals.push_back(Vector3d::UnitX());
  EXPECT_EQ(thinned(points).samples.size(), 101U);
}

TEST(Thinned, DoesNotDependOnTheOrderOfThePoints) {
  cloud::OrientedPoints points;
  add_sheet(points, 0.5, Vector3d::UnitZ(), 5000, 5);
  const auto before = thinned(points).samples.positions;
  std::reverse(points.positions.begin(), points.positions.end());
  EXPECT_EQ(thinned(points).samples.positions, before);
}

TEST(Thinned, AKeptSampleHasTheMeanStiffnessOfItsGroup) {
  cloud::OrientedPoints points;
  add_sheet(points, 0.5, Vector3d::UnitZ(), 20000, 5);
  for (const Vector3d& p : points.positions) points.stiffness.push_back(1.0 + 0.1 * p.x());
  const auto kept = thinned(points).samples;
  ASSERT_EQ(kept.stiffness.size(), kept.size());
  for (std::size_t i = 0; i < kept.size(); ++i) {
    EXPECT_NEAR(kept.stiffness[i], 1.0 + 0.1 * (std::floor(kept.positions[i].x()) + 0.5), 0.02);
  }
}

TEST(Thinned, TellsWhichSampleStandsForAPoint) {
  cloud::OrientedPoints points;
  add_sheet(points, 0.5, Vector3d::UnitZ(), 20000, 6);
  for (std::size_t i = 0; i < points.size(); i += 16) points.normals[i] = -Vector3d::UnitZ();
  const CellOrder order(points.positions);
  const Thinned thin = thinned(points, order, order.cells(1));
  ASSERT_EQ(thin.samples.size(), 25U);
  std::size_t stray = 0;
  for (std::size_t n = 0; n < order.size(); ++n) {
    if (thin.sample_of[n] == Thinned::kStray) {
      ++stray;
      EXPECT_LT(points.normals[order[n]].z(), 0.0);
      continue;
    }
    const std::uint32_t sample = thin.point[thin.sample_of[n]];
    EXPECT_EQ(points.positions[sample], thin.samples.positions[thin.sample_of[n]]);
    EXPECT_EQ((points.positions[sample] / 2.0).array().floor().matrix(), (points.positions[order[n]] / 2.0).array().floor().matrix());
  }
  EXPECT_EQ(stray, 1250U);
}

}  // namespace
}  // namespace isotouch::field
