#include "host/field/mesh_distance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "host/cloud/random.h"
#include "tests/host/field/box_mesh.h"

namespace isotouch::field {
namespace {

using Eigen::Vector3d;

const Vector3d kHalf{1, 2, 3};

cloud::TriangleMesh box() { return box_mesh(-kHalf, kHalf); }

Vector3d any_point(cloud::Random& random) {
  Vector3d p;
  for (double& coordinate : p) coordinate = random.uniform(-5, 5);
  return p;
}

TEST(MeshDistance, IsTheBoxesOwnEverywhere) {
  const MeshDistance distance(box());
  EXPECT_EQ(distance.crossings().faces, 0U);
  cloud::Random random(5);
  for (int i = 0; i < 20'000; ++i) {
    const Vector3d p = any_point(random);
    ASSERT_NEAR(distance(p), box_distance(kHalf, p), 1e-12) << p.transpose();
  }
}

TEST(MeshDistance, HasTheRightSignAtAReentrantCorner) {
  // A tetrahedron pushed in from one face: the sign of the nearest face's own normal fails beside its inner corner.
  cloud::TriangleMesh mesh;
  mesh.vertices = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}, {1.0, 1.0, 0.4}};
  mesh.faces = {{0, 2, 4}, {2, 1, 4}, {1, 0, 4}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};  // the bottom has its middle at (1, 1, 0.4)
  ASSERT_GT(cloud::signed_volume(mesh), 0);
  const MeshDistance distance(mesh);
  EXPECT_GT(distance({1, 1, 0.3}), 0);
  EXPECT_GT(distance({1, 1, 0.05}), 0);
  EXPECT_LT(distance({1, 1, 0.5}), 0);
  EXPECT_NEAR(distance({1, 1, 0.4}), 0, 1e-15);
  EXPECT_GT(distance({-1, -1, -1}), 0);
}

TEST(MeshDistance, ABlockOfSamplesIsTheSameAsOneByOne) {
  const MeshDistance plain(box());
  const MeshDistance crossed(together(box(), box_mesh({0, 0, 0}, {2, 3, 4})));
  cloud::Random random(6);
  int inside = 0;
  for (int i = 0; i < 300; ++i) {
    const Vector3d first = any_point(random);
    for (const MeshDistance* distance : {&plain, &crossed}) {
      const double middle = (*distance)(first + Vector3d::Constant(1.5 * 0.31));
      const auto block = distance->block(first, 0.31, std::abs(middle) / 0.31 + 1e-9);
      ASSERT_EQ(block.middle, middle);
      ASSERT_TRUE(block.points);
      ASSERT_FALSE(distance->block(first, 0.31, std::abs(middle) / 0.31 - 1e-9).points);
      for (int s = 0; s < 64; ++s) {
        const double d = (*distance)(first + 0.31 * Vector3d(s & 3, s >> 2 & 3, s >> 4));
        ASSERT_EQ((*block.points)[static_cast<std::size_t>(s)], d);
        inside += d < 0 ? 1 : 0;
      }
    }
  }
  EXPECT_GT(inside, 1000);
}

TEST(MeshDistance, OfBoxesThatRunThroughEachOtherIsThatOfTheirUnion) {
  const MeshDistance distance(together(box(), box_mesh({0, 0, 0}, {2, 3, 4})));
  EXPECT_GT(distance.crossings().faces, 0U);
  cloud::Random random(7);
  int inside = 0;
  for (int i = 0; i < 20'000; ++i) {
    const Vector3d p = any_point(random);
    const double exact = std::min(box_distance(kHalf, p), box_distance({1, 1.5, 2}, p - Vector3d(1, 1.5, 2)));
    const double d = distance(p);
    ASSERT_EQ(d < 0, exact < 0) << p.transpose();
    if (exact > 0) {
      ASSERT_NEAR(d, exact, 1e-12) << p.transpose();
    }
    inside += d < 0 ? 1 : 0;
  }
  EXPECT_GT(inside, 1000);
}

TEST(MeshDistance, OfBoxesThatShareAnEdgeIsThatOfBoth) {
  // Four faces at one edge: the sum of their normals is zero.
  cloud::TriangleMesh mesh = together(box_mesh({-1, -1, -1}, {0, 0, 1}), box_mesh({0, 0, -1}, {1, 1, 1}));
  for (auto& face : mesh.faces) {
    for (auto& v : face) v = v == 8 ? 3 : v == 12 ? 7 : v;  // the common edge runs from (0, 0, -1) to (0, 0, 1)
  }
  const MeshDistance distance(mesh);
  EXPECT_EQ(distance.crossings().faces, 0U);
  EXPECT_LT(distance({-0.1, -0.1, 0}), 0);
  EXPECT_LT(distance({0.1, 0.1, 0}), 0);
  EXPECT_GT(distance({0.1, -0.1, 0}), 0);
  EXPECT_GT(distance({-0.1, 0.1, 0}), 0);
  EXPECT_GT(distance({1e-3, -1.1e-3, 0}), 0);
}

struct Block {
  Vector3d low, high;
};

bool is_in(const std::vector<Block>& blocks, const Vector3d& p) {
  return std::any_of(blocks.begin(), blocks.end(),
                     [&](const Block& b) { return (p.array() > b.low.array()).all() && (p.array() < b.high.array()).all(); });
}

void expect_union(const cloud::TriangleMesh& mesh, const std::vector<Block>& blocks, const char* what) {
  const MeshDistance distance(mesh);
  EXPECT_EQ(distance.crossings().faces, 0U) << what;
  cloud::Random random(8);
  int inside = 0;
  for (int i = 0; i < 20'000; ++i) {
    const Vector3d p = any_point(random);
    const bool expected = is_in(blocks, p);
    ASSERT_EQ(distance(p) < 0, expected) << what << " at " << p.transpose();
    inside += expected ? 1 : 0;
  }
  EXPECT_GT(inside, 100) << what;
}

TEST(MeshDistance, OfPiecesThatNestAbutOrAreFlushIsThatOfTheirUnion) {
  const Block base = {-kHalf, kHalf};
  const std::pair<const char*, Block> others[] = {{"nested", {{-0.4, -1.5, -2}, {0.7, 1.2, 2.9}}},
                                                  {"abutting", {{-0.5, -0.7, 3}, {0.6, 1.1, 4.5}}},
                                                  {"flush", {{0.2, -2, -3}, {3, 2, 3}}},
                                                  {"the same twice", base}};
  for (const auto& [what, other] : others)
    expect_union(together(box_mesh(base.low, base.high), box_mesh(other.low, other.high)), {base, other}, what);
}

TEST(MeshDistance, AHollowStaysHollow) {
  const MeshDistance distance(together(box(), turned(box_mesh(-kHalf / 2, kHalf / 2))));
  cloud::Random random(9);
  for (int i = 0; i < 20'000; ++i) {
    const Vector3d p = any_point(random);
    ASSERT_NEAR(distance(p), std::max(box_distance(kHalf, p), -box_distance(kHalf / 2, p)), 1e-12) << p.transpose();
  }
}

TEST(MeshDistance, HollowsThatOverlapAreOne) {
  const Vector3d half(4, 3, 3), hollow(2, 1, 1);
  const auto one = box_mesh({-2, -1, -1}, {1, 1, 1}), other = box_mesh({-1, -1, -1}, {2, 1, 1});
  const MeshDistance distance(together(together(box_mesh(-half, half), turned(one)), turned(other)));
  cloud::Random random(14);
  for (int i = 0; i < 10'000; ++i) {
    const Vector3d p = any_point(random);
    const double exact = std::max(box_distance(half, p), -box_distance(hollow, p)), found = distance(p);
    ASSERT_NEAR(found, exact, exact > 0 ? 1e-6 : 0.006) << p.transpose();
  }
}

TEST(MeshDistance, OfOnePieceThatTouchesItselfIsThatOfItsInside) {
  // A ring of bars, open where the end of the last one stands on the first one's side.
  const std::vector<Block> bars = {{{0, 0, 0}, {4, 1, 1}}, {{0, 0, 0}, {1, 3, 1}}, {{0, 2, 0}, {3.5, 3, 1}}, {{3, 0.5, 0}, {3.5, 3, 1}}};
  const double outline[][2] = {{0, 0}, {4, 0}, {4, 1}, {1, 1}, {1, 2}, {3, 2}, {3, 1}, {3.5, 1}, {3.5, 3}, {0, 3}};
  const std::array<std::uint32_t, 3> cap[] = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 9}, {4, 5, 8}, {4, 8, 9}, {5, 6, 7}, {5, 7, 8}};
  cloud::TriangleMesh mesh;
  for (const double z : {0.0, 1.0}) {
    for (const auto& [x, y] : outline) mesh.vertices.emplace_back(x, y, z);
  }
  for (const auto& [a, b, c] : cap) {
    mesh.faces.push_back({a, c, b});
    mesh.faces.push_back({a + 10, b + 10, c + 10});
  }
  for (std::uint32_t i = 0; i < 10; ++i) {
    const std::uint32_t j = (i + 1) % 10;
    mesh.faces.push_back({i, j, j + 10});
    mesh.faces.push_back({i, j + 10, i + 10});
  }
  expect_union(mesh, bars, "ring");
  for (Vector3d& vertex : mesh.vertices) vertex = vertex.cast<float>().cast<double>() + Vector3d(1e-8 * vertex.x(), 0, 0);
  expect_union(mesh, bars, "ring, rounded");
}

TEST(MeshDistance, OfPiecesThatHaveOneVertexTogetherIsThatOfBoth) {
  // The nearest place of many points is that vertex, and the normals there are of both.
  cloud::TriangleMesh mesh = together(box_mesh({-1, -1, -1}, {0, 0, 0}), box_mesh({0, 0, 0}, {3, 3, 3}));
  for (auto& face : mesh.faces) {
    for (auto& v : face) v = v == 8 ? 7 : v;
  }
  expect_union(mesh, {{{-1, -1, -1}, {0, 0, 0}}, {{0, 0, 0}, {3, 3, 3}}}, "vertex");
}

/// Points inside the union are as deep as they are below its surface: faces within it do not count.
TEST(MeshDistance, FacesInsideTheUnionDoNotCount) {
  cloud::TriangleMesh cubes, plates;
  for (int n = 0; n < 27; ++n) {
    const Vector3d low(2 * (n % 3) - 3, 2 * (n / 3 % 3) - 3, 2 * (n / 9) - 3);
    cubes = together(cubes, box_mesh(low, low + Vector3d(2, 2, 2)));
  }
  for (int n = 0; n < 12; ++n) plates = together(plates, box_mesh({-3, -3, -3 + 0.5 * n}, {3, 3, -2.5 + 0.5 * n}));
  const auto body = box_mesh({-3, -3, -3}, {3, 3, 3});
  // Both crossing boxes go beyond the body; where they leave it, their faces are cut.
  const std::pair<const char*, cloud::TriangleMesh> meshes[] = {
      {"cubes", cubes},
      {"plates", plates},
      {"nested", together(body, box_mesh({-1, -2, -0.5}, {1.3, 0.4, 2}))},
      {"the same twice", together(body, body)},
      {"abutting", together(box_mesh({-3, -3, -3}, {3, 3, 0}), box_mesh({-3, -3, 0}, {3, 3, 3}))}};
  for (const auto& [what, mesh] : meshes) {
    const MeshDistance distance(mesh);
    cloud::Random random(10);
    for (int i = 0; i < 5'000; ++i) {
      const Vector3d p = any_point(random);
      ASSERT_NEAR(distance(p), box_distance({3, 3, 3}, p), 1e-12) << what << " at " << p.transpose();
    }
  }
}

/// Distance to a box and one that stands on it or runs into it, both round the z axis.
double two_boxes(const Vector3d& p) {
  const Vector3d low(3, 3, 3), high(1, 1.5, 2);  // half sides; the second one's middle is at z = 4
  const double foot = box_distance(low, p), tower = box_distance(high, p - Vector3d(0, 0, 4));
  if (foot > 0 && tower > 0) return std::min(foot, tower);
  // Inside: the faces of the union alone.
  double inside = std::numeric_limits<double>::max();
  const auto to_rectangle = [&](const Vector3d& from, const Vector3d& to) {
    inside = std::min(inside, (p - p.cwiseMax(from).cwiseMin(to)).norm());
  };
  for (const double s : {-1.0, 1.0}) {
    to_rectangle({3 * s, -3, -3}, {3 * s, 3, 3});
    to_rectangle({-3, 3 * s, -3}, {3, 3 * s, 3});
    to_rectangle({s, -1.5, 3}, {s, 1.5, 6});
    to_rectangle({-1, 1.5 * s, 3}, {1, 1.5 * s, 6});
    to_rectangle({s < 0 ? -3.0 : 1.0, -3, 3}, {s < 0 ? -1.0 : 3.0, 3, 3});
    to_rectangle({-3, s < 0 ? -3 : 1.5, 3}, {3, s < 0 ? -1.5 : 3, 3});
  }
  to_rectangle({-3, -3, -3}, {3, 3, -3});
  to_rectangle({-1, -1.5, 6}, {1, 1.5, 6});
  return -inside;
}

/// A box whose ends are fans of slivers round a corner beside their middles.
cloud::TriangleMesh fan_box() {
  constexpr std::uint32_t kSide = 7, kRound = 4 * kSide;
  cloud::TriangleMesh mesh;
  for (const double z : {-3.0, 3.0}) {
    for (std::uint32_t i = 0; i < kRound; ++i) {
      const double way = 6.0 * (i % kSide) / kSide - 3;
      const Vector3d sides[] = {{way, -3, z}, {3, way, z}, {-way, 3, z}, {-3, -way, z}};
      mesh.vertices.push_back(sides[i / kSide]);
    }
  }
  mesh.vertices.emplace_back(0.2, 0.3, -3);
  mesh.vertices.emplace_back(0.2, 0.3, 3);
  for (std::uint32_t i = 0; i < kRound; ++i) {
    const std::uint32_t j = (i + 1) % kRound;
    mesh.faces.insert(mesh.faces.end(),
                      {{i, j, kRound + j}, {i, kRound + j, kRound + i}, {2 * kRound, j, i}, {2 * kRound + 1, kRound + i, kRound + j}});
  }
  return mesh;
}

TEST(MeshDistance, FacesThatAreInsideTheUnionInPartCountForTheRest) {
  const auto foot = box_mesh({-3, -3, -3}, {3, 3, 3}), fan = fan_box();
  ASSERT_NEAR(cloud::signed_volume(fan), 216, 1e-9);
  const std::pair<const cloud::TriangleMesh*, double> feet[] = {{&foot, 3}, {&foot, 2}, {&fan, 3}, {&fan, 2}};
  for (const auto& [below, low] : feet) {  // it stands on the foot; it runs into it
    const MeshDistance distance(together(*below, box_mesh({-1, -1.5, low}, {1, 1.5, 6})));
    cloud::Random random(11);
    for (int i = 0; i < 10'000; ++i) {
      Vector3d p = any_point(random);
      p.z() += 2;
      const double exact = two_boxes(p), found = distance(p);
      ASSERT_EQ(found < 0, exact < 0) << low << " at " << p.transpose();
      if (exact > 0) {
        ASSERT_NEAR(found, exact, 1e-6) << low << " at " << p.transpose();
      } else {
        ASSERT_LE(-found, -exact + 1e-12) << low << " at " << p.transpose();
        ASSERT_GE(-found, -exact - 0.006) << low << " at " << p.transpose() << ": a two-thousandth of the size";
      }
    }
  }
}

/// Moves a mesh's coordinates on by one axis.
cloud::TriangleMesh rolled(cloud::TriangleMesh mesh) {
  for (Vector3d& v : mesh.vertices) v = {v.z(), v.x(), v.y()};
  return mesh;
}

TEST(MeshDistance, AGapThatFilesRoundToIsNone) {
  const double size = Vector3d(6, 6, 9).norm();
  for (const double gap : {0.0, 0.3e-6, 0.9e-6, 1.1e-6, 1.5e-6, 1.9e-6}) {
    const double low = 3 + gap * size;
    auto mesh = together(box_mesh({-3, -3, -3}, {3, 3, 3}), box_mesh({-1, -1.5, low}, {1, 1.5, low + 3}));
    for (int axis = 0; axis < 3; ++axis, mesh = rolled(mesh)) {
      const MeshDistance distance(mesh);
      const auto ask = [&](const Vector3d& p) {
        const Vector3d turned = axis == 0 ? p : axis == 1 ? Vector3d(p.z(), p.x(), p.y()) : Vector3d(p.y(), p.z(), p.x());
        const double exact = two_boxes(p), found = distance(turned);
        ASSERT_EQ(found < 0, exact < 0) << gap << ", axis " << axis << " at " << p.transpose();
        if (exact > 0) {
          ASSERT_NEAR(found, exact, 3e-6 * size) << gap << ", axis " << axis << " at " << p.transpose();
        } else {
          ASSERT_NEAR(found, exact, 0.006) << gap << ", axis " << axis << " at " << p.transpose();
        }
      };
      cloud::Random random(12);
      for (int i = 0; i < 5'000; ++i) {
        Vector3d p = any_point(random);
        p.z() += 2;
        ask(p);
      }
      for (int i = 0; i < 200; ++i) {  // in the gap, and on either side of it
        const double beside = size * random.uniform(0, 12e-6);
        for (const double z : {3.0, 3 + gap * size / 2, low, 3 - beside, low + beside})
          ask({random.uniform(-0.9, 0.9), random.uniform(-1.4, 1.4), z});
      }
      for (int i = 0; i < 20; ++i) {  // layers of samples in the gap
        const double step = random.uniform(0.05, 0.4);
        Vector3d first(random.uniform(-2, 1), random.uniform(-2, 1), 3 + random.uniform() * gap * size - (i % 2) * step);
        for (int turn = 0; turn < axis; ++turn) first = Vector3d(first.z(), first.x(), first.y());
        const auto block = distance.block(first, step, 100);
        ASSERT_TRUE(block.points);
        for (int n = 0; n < 64; ++n)
          ASSERT_EQ((*block.points)[static_cast<std::size_t>(n)], distance(first + step * Vector3d(n & 3, n >> 2 & 3, n >> 4))) << gap;
      }
    }
  }
}

TEST(MeshDistance, APieceThatStandsOnItsTipLeavesTheFaceBelow) {
  // The tip stands on the middle of the body's largest face.
  cloud::TriangleMesh body, tip;
  body.vertices = {{0, 0, 3}, {6, 0, 3}, {0, 6, 3}, {1, 1, 0}};
  body.faces = {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}};
  tip.vertices = {{2, 2, 3}, {1, 1, 5}, {3, 1, 5}, {2, 4, 5}};
  tip.faces = {{0, 2, 1}, {0, 3, 2}, {0, 1, 3}, {1, 2, 3}};
  ASSERT_GT(cloud::signed_volume(body), 0);
  ASSERT_GT(cloud::signed_volume(tip), 0);
  for (const double up : {0.0, 2e-6, 8e-6}) {
    auto lifted = tip;
    for (Vector3d& v : lifted.vertices) v.z() += up;
    const MeshDistance distance(together(body, lifted));
    for (const Vector3d& p : {Vector3d(2, 2, 2.9), {3, 1, 2.9}, {1, 3, 2.9}}) EXPECT_NEAR(distance(p), -0.1, 1e-9) << up;
  }
}

}  // namespace
}  // namespace isotouch::field
