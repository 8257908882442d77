#include "host/field/build_field.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "host/cloud/random.h"
#include "host/cloud/read_cloud.h"
#include "host/cloud/shapes.h"
#include "host/error.h"
#include "host/field/make_grid.h"
#include "tests/support/sanitized.h"

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

/// The inside of a field on its whole grid, by the sign of every sample; x fastest.
std::vector<bool> inside(const BandField& field) {
  const Vector3i size = (field.grid.size + Vector3i::Constant(3)) / 4 * 4;
  const auto at = [&](int x, int y, int z) { return static_cast<std::size_t>((z * size.y() + y) * size.x() + x); };
  std::vector<bool> result(at(0, 0, size.z())), known(result.size());
  for (const Brick& brick : field.bricks) {
    for (int s = 0; s < 64; ++s) {
      const Vector3i p = 4 * brick.cell + Vector3i(s & 3, s >> 2 & 3, s >> 4);
      result[at(p.x(), p.y(), p.z())] = brick.distance[static_cast<std::size_t>(s)] < 0.0F;
      known[at(p.x(), p.y(), p.z())] = true;
    }
  }
  for (std::size_t n = 1; n < result.size(); ++n) {
    if (!known[n] && n % static_cast<std::size_t>(size.x()) != 0) result[n] = result[n - 1];
  }
  return result;
}

/// How many sets of samples of one sign hang together, face to face: first inside, then outside.
std::pair<int, int> pieces(const std::vector<bool>& inside, const Grid& grid) {
  const Vector3i size = (grid.size + Vector3i::Constant(3)) / 4 * 4;
  const std::size_t steps[3] = {1, static_cast<std::size_t>(size.x()), static_cast<std::size_t>(size.x() * size.y())};
  std::vector<bool> seen(inside.size());
  std::pair<int, int> count{0, 0};
  for (std::size_t first = 0; first < inside.size(); ++first) {
    if (seen[first]) continue;
    ++(inside[first] ? count.first : count.second);
    std::vector<std::size_t> front{first};
    seen[first] = true;
    while (!front.empty()) {
      const std::size_t n = front.back();
      front.pop_back();
      const auto visit = [&](std::size_t next) {
        if (seen[next] || inside[next] != inside[n]) return;
        seen[next] = true;
        front.push_back(next);
      };
      for (int axis = 0; axis < 3; ++axis) {
        const auto along = static_cast<int>(n / steps[axis]) % size[axis];
        if (along > 0) visit(n - steps[axis]);
        if (along + 1 < size[axis]) visit(n + steps[axis]);
      }
    }
  }
  return count;
}

/// The five shapes, sampled and then damaged: each must stay one closed body of the same volume.
void expect_one_body(const char* what, void (*damage)(cloud::OrientedPoints&, cloud::Random&), Repair* repair = nullptr) {
  for (const char* name : test::examples<const char*>({"torus", "sphere", "box", "capsules"})) {
    const cloud::Shape shape = cloud::shape(name);
    auto points = cloud::sample_shape(shape, 3000);
    cloud::Random random(11);
    damage(points, random);
    Progress progress;
    const auto field = build_field(points, grid_for(points, 1.6, field_margin(kBand)), kBand, progress, repair);
    EXPECT_EQ(torn_gaps(field), 0U) << what << ' ' << name;
    const std::vector<bool> body = inside(field);
    EXPECT_EQ(pieces(body, field.grid), (std::pair{1, 1})) << what << ' ' << name;
    const auto volume = static_cast<double>(std::count(body.begin(), body.end(), true));
    double truth = 0.0;
    for (int z = 0; z < field.grid.size.z(); ++z) {
      for (int y = 0; y < field.grid.size.y(); ++y) {
        for (int x = 0; x < field.grid.size.x(); ++x) truth += shape.distance(field.grid.position({x, y, z})) < 0.0;
      }
    }
    EXPECT_NEAR(volume / truth, 1.0, 0.03) << what << ' ' << name;
  }
}

Vector3d anywhere(cloud::Random& random, double reach) {
  return {random.uniform(-reach, reach), random.uniform(-reach, reach), random.uniform(-reach, reach)};
}

/// Keeps the points that `keep` accepts.
template <class Keep>
void thin_out(cloud::OrientedPoints& points, const Keep& keep) {
  cloud::OrientedPoints kept;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!keep(points.positions[i])) continue;
    kept.positions.push_back(points.positions[i]);
    kept.normals.push_back(points.normals[i]);
  }
  points = kept;
}

TEST(BuildField, MakesOneBodyOfANoisyScan) {
  expect_one_body("noise", [](cloud::OrientedPoints& points, cloud::Random& random) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      points.positions[i] += anywhere(random, 1.0);  // a fifth of the spacing
      points.normals[i] = (points.normals[i] + anywhere(random, 0.3)).normalized();
    }
  });
}

TEST(BuildField, MakesOneBodyOfAScanWithTurnedNormalsAndCountsThem) {
  Repair repair;
  expect_one_body(
      "turned normals",
      [](cloud::OrientedPoints& points, cloud::Random& random) {
        for (auto& normal : points.normals) normal *= random.uniform() < 0.06 ? -1.0 : 1.0;
      },
      &repair);
  EXPECT_NEAR(static_cast<double>(repair.turned), 180.0, 45.0);
  EXPECT_EQ(repair.warnings().size(), 1U);
}

TEST(BuildField, MakesOneBodyOfAScanWithStrayPointsAndCountsThem) {
  Repair repair;
  expect_one_body(
      "stray points",
      [](cloud::OrientedPoints& points, cloud::Random& random) {
        for (int n = 0; n < 30; ++n) {  // 1 %
          points.positions.push_back(anywhere(random, 90.0));
          points.normals.push_back((anywhere(random, 1.0) + Vector3d(1e-3, 0, 0)).normalized());
        }
      },
      &repair);
  EXPECT_GT(repair.isolated, 5U);
  EXPECT_FALSE(repair.warnings().empty());
}

TEST(BuildField, MakesOneBodyOfAnUnevenScan) {
  expect_one_body("uneven", [](cloud::OrientedPoints& points, cloud::Random& random) {
    thin_out(points, [&](const Vector3d& p) { return random.uniform() < std::pow(10.0, -(p.x() + 100.0) / 200.0); });
  });
}

TEST(BuildField, ClosesSmallHoles) {
  expect_one_body("holes", [](cloud::OrientedPoints& points, cloud::Random& random) {
    std::vector<Vector3d> middles;
    for (int n = 0; n < 5; ++n) middles.push_back(points.positions[random.bits() % points.size()]);
    thin_out(points, [&](const Vector3d& p) {
      return std::all_of(middles.begin(), middles.end(), [&](const Vector3d& m) { return (p - m).norm() > 12.0; });  // two spacings
    });
  });
}

TEST(BuildField, HoldsTheDistanceToTheShapesInTheirBand) {
  for (const char* name : test::examples<const char*>({"capsules", "sphere", "torus"})) {
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
