#include "host/field/normal_voting.h"

#include <gtest/gtest.h>

#include <string>

#include "host/cloud/random.h"
#include "host/cloud/shapes.h"
#include "tests/support/sanitized.h"

namespace isotouch::field {
namespace {

/// Turns about a share of the normals; returns how many.
std::size_t damage(cloud::OrientedPoints& points, double share) {
  cloud::Random random(1);
  std::size_t strays = 0;
  for (auto& normal : points.normals) {
    if (random.uniform() >= share) continue;
    normal = -normal;
    ++strays;
  }
  return strays;
}

TEST(TurnContradicted, LeavesSoundCloudsAlone) {
  for (const char* name : test::examples<const char*>({"capsules", "sphere", "torus", "box", "plate"})) {
    for (const std::size_t count : {400U, 1500U, 3700U}) {
      const auto points = cloud::sample_shape(cloud::shape(name), count);
      Scan scan(points);
      EXPECT_EQ(turn_outvoted(scan), 0U) << name << ' ' << count;
      EXPECT_EQ(scan.normals(), points.normals) << name << ' ' << count;
    }
  }
}

TEST(TurnContradicted, TurnsStrayNormalsBackAlsoOnThinParts) {
  for (const char* name : test::examples<const char*>({"capsules", "sphere", "torus", "box", "plate"})) {
    auto points = cloud::sample_shape(cloud::shape(name), 1500);
    const auto sound = points.normals;
    const std::size_t strays = damage(points, 0.06);
    ASSERT_GT(strays, 60U);
    Scan scan(points);
    turn_outvoted(scan);
    std::size_t wrong = 0;
    for (std::size_t i = 0; i < sound.size(); ++i) wrong += scan.normals()[i] != sound[i] ? 1U : 0U;
    EXPECT_LE(wrong, name == std::string("plate") ? 2U : 0U) << name;  // the plate's rim is narrower than the spacing
  }
}

TEST(TurnContradicted, LeavesThePartsOfAPairBackToBack) {
  // Two sheets, nearer to each other than the samples of each are.
  for (const double thickness : {0.3, 0.6, 1.0}) {
    cloud::OrientedPoints points;
    for (int i = 0; i < 20; ++i) {
      for (int j = 0; j < 20; ++j) {
        points.positions.emplace_back(i + 0.5 * (j % 2), 0.866 * j, 0.0);
        points.normals.emplace_back(0.0, 0.0, -1.0);
        points.positions.emplace_back(i + 0.5 * (j % 2) + 0.3, 0.866 * j + 0.2, thickness);
        points.normals.emplace_back(0.0, 0.0, 1.0);
      }
    }
    Scan scan(points);
    EXPECT_EQ(turn_outvoted(scan), 0U) << thickness;
  }
}

}  // namespace
}  // namespace isotouch::field
