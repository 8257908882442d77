#include "host/field/hidden_share.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "host/cloud/random.h"
#include "host/cloud/shapes.h"
#include "tests/support/sanitized.h"

namespace isotouch::field {
namespace {

using cloud::OrientedPoints;
using Eigen::Vector3d;

constexpr double kFar = 2000;

TEST(HiddenShare, IsLargeOfAWholeBody) {
  for (const std::string& name : test::examples<std::string>({"sphere", "box", "owl"})) {
    const Scan scan(cloud::sample_shape(cloud::shape(name), 4000));
    EXPECT_GT(hidden_share(scan, Vector3d(0, 0, kFar)), 0.2) << name;
  }
}

/// Two flat layers, and nothing at their edges.
TEST(HiddenShare, IsHalfOfTwoLayers) {
  OrientedPoints plate;
  cloud::Random random(1);
  for (int i = 0; i < 4000; ++i) {
    const double x = random.uniform(-35, 35), y = random.uniform(-35, 35), side = i % 2 == 0 ? 1 : -1;
    plate.positions.emplace_back(x, y, 2 * side);
    plate.normals.emplace_back(0, 0, side);
  }
  EXPECT_NEAR(hidden_share(Scan(plate), Vector3d(0, 0, kFar)), 0.39, 0.05);
}

/// A ball before a wall, and no point of the wall in its shadow.
TEST(HiddenShare, IsSmallWhereShadowsAreEmpty) {
  OrientedPoints seen = cloud::sample_shape(cloud::shape("sphere"), 4000);
  std::size_t kept = 0;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    if (seen.normals[i].dot(Vector3d(0, 0, kFar) - seen.positions[i]) < 0) continue;
    seen.positions[kept] = seen.positions[i];
    seen.normals[kept++] = seen.normals[i];
  }
  seen.positions.resize(kept);
  seen.normals.resize(kept);
  for (double x = -160; x <= 160; x += 4) {
    for (double y = -160; y <= 160; y += 4) {
      if (std::hypot(x, y) < 84) continue;
      seen.positions.emplace_back(x, y, -90);
      seen.normals.emplace_back(0, 0, 1);
    }
  }
  EXPECT_LT(hidden_share(Scan(seen), Vector3d(0, 0, kFar)), 0.05);
}

/// Slats before a wall.
TEST(HiddenShare, IsSmallBesideManyShadows) {
  OrientedPoints seen;
  for (int x = 0; x < 160; ++x) {
    for (int y = 0; y < 60; ++y) {
      seen.positions.emplace_back(x, y, x / 8 % 2 == 0 ? 40 : 0);
      seen.normals.emplace_back(0, 0, 1);
    }
  }
  EXPECT_LT(hidden_share(Scan(seen), Vector3d(80, 30, kFar)), 0.06);
}

}  // namespace
}  // namespace isotouch::field
