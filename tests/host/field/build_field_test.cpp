#include "host/field/build_field.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <string>
#include <tuple>

#include "host/cloud/read_cloud.h"
#include "host/cloud/shapes.h"
#include "host/error.h"
#include "host/field/make_grid.h"

namespace isotouch::field {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3i;

constexpr double kBand = 4.0;

Grid grid_for(const cloud::OrientedPoints& points, double edge, double margin) {
  Vector3d low = points.positions.front(), high = low;
  for (const auto& p : points.positions) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  return make_grid(low, high, edge, margin);
}

BandField field_of(const cloud::OrientedPoints& points, double edge) {
  Progress progress;
  return build_field(points, grid_for(points, edge, field_margin(kBand)), kBand, progress);
}

std::tuple<int, int, int> place(const Brick& brick) { return {brick.cell.z(), brick.cell.y(), brick.cell.x()}; }

bool on_border(const Vector3i& sample, const Grid& grid) {
  return (sample.array() < 2).any() || (sample.array() >= grid.size.array() - 2).any();
}

/// Sorted, closed, and of one sign across every gap of a row of bricks. Returns how many gaps disagree.
std::size_t torn_gaps(const BandField& field) {
  const auto inside = [](const Brick& brick, int face, std::size_t n) {  // the face sample n of the -x or +x face
    return brick.distance[(n >> 2) * 16 + (n & 3) * 4 + (face < 0 ? 0 : 3)] < 0;
  };
  std::size_t torn = 0;
  for (std::size_t b = 0; b < field.bricks.size(); ++b) {
    const Brick& brick = field.bricks[b];
    const bool follows = b > 0 && field.bricks[b - 1].cell.y() == brick.cell.y() && field.bricks[b - 1].cell.z() == brick.cell.z();
    if (b > 0) {
      EXPECT_LT(place(field.bricks[b - 1]), place(brick));
    }
    for (int s = 0; s < 64; ++s) {
      const Vector3i sample = 4 * brick.cell + Vector3i(s & 3, s >> 2 & 3, s >> 4);
      if (on_border(sample, field.grid)) {
        EXPECT_GT(brick.distance[static_cast<std::size_t>(s)], kBand);
      }
    }
    const bool touches = follows && field.bricks[b - 1].cell.x() + 1 == brick.cell.x();
    if (touches) continue;
    bool differs = false;
    for (std::size_t n = 0; n < 16; ++n) differs = differs || inside(brick, -1, n) != (follows && inside(field.bricks[b - 1], 1, 0));
    for (std::size_t n = 0; follows && n < 16; ++n)
      differs = differs || inside(field.bricks[b - 1], 1, n) != inside(field.bricks[b - 1], 1, 0);
    torn += differs;
  }
  return torn;
}

TEST(BuildField, HoldsTheDistanceToTheShapesInTheirBand) {
  for (const char* name : {"sphere", "torus", "capsules"}) {
    const auto shape = cloud::shape(name);
    const auto field = field_of(cloud::sample_shape(shape, 3756), 2.0);
    EXPECT_EQ(torn_gaps(field), 0U) << name;
    std::size_t near = 0;
    for (const auto& brick : field.bricks) {
      for (int s = 0; s < 64; ++s) {
        const Vector3d x = field.grid.position(4 * brick.cell + Vector3i(s & 3, s >> 2 & 3, s >> 4));
        const double truth = shape.distance(x) / 2.0;
        if (std::abs(truth) > 1.0) continue;
        ++near;
        EXPECT_NEAR(static_cast<double>(brick.distance[static_cast<std::size_t>(s)]), truth, 0.25) << name;
      }
    }
    EXPECT_GT(near, 5000U) << name;
  }
}

TEST(BuildField, ListsEveryBrickOfTheBand) {
  const auto shape = cloud::shape("box");
  const auto field = field_of(cloud::sample_shape(shape, 2000), 2.5);
  std::map<std::tuple<int, int, int>, const Brick*> listed;
  for (const auto& brick : field.bricks) listed[place(brick)] = &brick;
  std::size_t in_band = 0;
  for (int z = 0; z < field.grid.size.z(); ++z) {
    for (int y = 0; y < field.grid.size.y(); ++y) {
      for (int x = 0; x < field.grid.size.x(); ++x) {
        // The field is conservative: where the truth is well within the band, so is the field.
        if (std::abs(shape.distance(field.grid.position({x, y, z}))) / 2.5 > kBand - 0.1) continue;
        ++in_band;
        ASSERT_EQ(listed.count({z / 4, y / 4, x / 4}), 1U) << x << ' ' << y << ' ' << z;
      }
    }
  }
  EXPECT_GT(in_band, 10000U);
}

TEST(BuildField, ClosesAnOpenScan) {
  // A tube without ends.
  cloud::OrientedPoints points;
  for (int i = 0; i < 40; ++i) {
    for (int j = 0; j < 24; ++j) {
      const double a = (j + 0.5 * (i % 2)) * 2 * 3.14159265358979 / 24;
      points.normals.emplace_back(std::cos(a), std::sin(a), 0);
      points.positions.emplace_back(12 * std::cos(a), 12 * std::sin(a), 2.5 * i);
    }
  }
  const auto field = field_of(points, 1.0);
  EXPECT_EQ(torn_gaps(field), 0U);
}

TEST(BuildField, CopesWithEveryCloud) {
  const char* folder = std::getenv("ISOTOUCH_DATA");
  if (folder == nullptr) GTEST_SKIP() << "ISOTOUCH_DATA is not set";
  for (const char* name : {"clouds/penguin.ply", "clouds/drill.ply", "clouds/bunny_scan.ply", "clouds/bunny_scan_badnormals.ply",
                           "clouds/hand_open.ply", "clouds/foreign/oni.ply"}) {
    cloud::CloudReport report;
    const auto points = cloud::read_cloud(std::filesystem::path(folder) / name, report);
    Vector3d low = points.positions.front(), high = low;
    for (const auto& p : points.positions) {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
    auto scaled = points;
    for (auto& p : scaled.positions) p *= 60.0 / (high - low).maxCoeff();
    const auto field = field_of(scaled, 1.0);
    EXPECT_GT(field.bricks.size(), 200U) << name;
    EXPECT_EQ(torn_gaps(field), 0U) << name;
  }
}

TEST(BuildField, RefusesTooFewPointsAndATightGrid) {
  Progress progress;
  auto points = cloud::sample_shape(cloud::shape("sphere"), 200);
  EXPECT_THROW(build_field(points, grid_for(points, 4.0, 3.0), kBand, progress), InputError);
  points.positions.resize(7);
  points.normals.resize(7);
  EXPECT_THROW(build_field(points, grid_for(points, 4.0, field_margin(kBand)), kBand, progress), InputError);
}

}  // namespace
}  // namespace isotouch::field
