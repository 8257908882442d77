#include "host/field/agreement.h"

#include <gtest/gtest.h>

#include "host/cloud/random.h"
#include "host/cloud/shapes.h"

namespace isotouch::field {
namespace {

TEST(TurnContradicted, LeavesSoundCloudsAlone) {
  for (const char* name : {"sphere", "torus", "box", "plate", "capsules"}) {
    auto points = cloud::sample_shape(cloud::shape(name), 1500);
    const auto before = points.normals;
    EXPECT_EQ(turn_contradicted(points, Nearest(points.positions)), 0U) << name;
    EXPECT_EQ(points.normals, before) << name;
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
  EXPECT_EQ(turn_contradicted(points, Nearest(points.positions)), strays);
  EXPECT_EQ(points.normals, sound);
}

}  // namespace
}  // namespace isotouch::field
