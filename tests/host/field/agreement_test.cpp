#include "host/field/agreement.h"

#include <gtest/gtest.h>

#include "host/cloud/random.h"
#include "host/cloud/shapes.h"

namespace isotouch::field {
namespace {

TEST(TurnContradicted, LeavesSoundCloudsAlone) {
  for (const char* name : {"sphere", "torus", "box", "plate", "capsules"}) {
    const auto points = cloud::sample_shape(cloud::shape(name), 1500);
    Scan scan(points);
    EXPECT_EQ(turn_contradicted(scan), 0U) << name;
    EXPECT_EQ(scan.normals(), points.normals) << name;
  }
}

TEST(TurnContradicted, TurnsStrayNormalsBack) {
  auto points = cloud::sample_shape(cloud::shape("torus"), 1500);
  const auto sound = points.normals;
  cloud::Random random(1);
  std::size_t strays = 0;
  for (auto& normal : points.normals) {
    if (random.uniform() >= 0.04) continue;
    normal = -normal;
    ++strays;
  }
  ASSERT_GT(strays, 30U);
  Scan scan(points);
  EXPECT_EQ(turn_contradicted(scan), strays);
  EXPECT_EQ(scan.normals(), sound);
}

}  // namespace
}  // namespace isotouch::field
