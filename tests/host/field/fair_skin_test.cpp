#include "host/field/fair_skin.h"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>

#include "host/cloud/random.h"

namespace isotouch::field {
namespace {

using cloud::OrientedPoints;
using Eigen::Vector3d;

constexpr double kRadius = 40;  // of a cylinder along x; samples are 1 apart

struct Pierced {
  OrientedPoints scan, skin;
};

/// A part of a cylinder without a round part in its middle, and a flat skin there.
Pierced pierced_cylinder() {
  Pierced result;
  cloud::Random random(3);
  for (int x = -20; x <= 20; ++x) {
    for (int y = -20; y <= 20; ++y) {
      const double u = x + random.uniform(-0.2, 0.2), v = y + random.uniform(-0.2, 0.2), turn = v / kRadius;
      const Vector3d normal(0, std::sin(turn), std::cos(turn));
      const bool open = std::hypot(x, y) < 8;
      OrientedPoints& to = open ? result.skin : result.scan;
      to.positions.push_back(open ? Vector3d(u, v, kRadius * std::cos(8 / kRadius)) : Vector3d(kRadius * normal + u * Vector3d::UnitX()));
      to.normals.push_back(open ? Vector3d::UnitZ() : normal);
    }
  }
  return result;
}

TEST(FairSkin, ContinuesACylinder) {
  Pierced pierced = pierced_cylinder();
  fair_skin(Scan(pierced.scan), pierced.skin);
  for (std::size_t i = 0; i < pierced.skin.size(); ++i) {
    const Vector3d& p = pierced.skin.positions[i];
    EXPECT_NEAR(std::hypot(p.y(), p.z()), kRadius, 0.12) << i;  // flat: up to 0.8 deeper
  }
}

TEST(FairSkin, StaysAPlane) {
  Pierced pierced = pierced_cylinder();
  for (OrientedPoints* points : {&pierced.scan, &pierced.skin}) {
    for (std::size_t i = 0; i < points->size(); ++i)
      points->positions[i].z() = points == &pierced.skin ? 1.0 : 0.0, points->normals[i] = Vector3d::UnitZ();
  }
  fair_skin(Scan(pierced.scan), pierced.skin);
  for (const Vector3d& p : pierced.skin.positions) EXPECT_NEAR(p.z(), 0.0, 1e-3);
}

}  // namespace
}  // namespace isotouch::field
