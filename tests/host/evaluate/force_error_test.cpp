#include "host/evaluate/force_error.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "host/error.h"

namespace isotouch::evaluate {
namespace {

using Eigen::Vector3d;

SphereSlide slide() {
  SphereSlide made;
  made.centre = {1, 2, 3};
  made.radius = 27.2;
  made.depth = 1.36;
  made.speed = 300;
  made.turns = 1;
  return made;
}

ForceTick exact(const SphereSlide& of) {
  return [of](const Vector3d& hip) -> Vector3d {
    const Vector3d arm = hip - of.centre;
    return of.stiffness * std::max(0.0, of.radius - arm.norm()) * arm.normalized();
  };
}

TEST(ForceError, TheExactAnswerHasNone) {
  const ForceError error = force_error(slide_on_sphere(slide(), exact(slide())));
  EXPECT_GT(error.ticks, 500U);
  EXPECT_LT(error.magnitude_rms_pct, 1e-9);
  EXPECT_LT(error.direction_max_deg, 1e-5);
}

TEST(ForceError, SeesAKnownErrorOfEachKind) {
  const auto longer = [&](const Vector3d& hip) -> Vector3d { return 1.01 * exact(slide())(hip); };
  EXPECT_NEAR(force_error(slide_on_sphere(slide(), longer)).magnitude_rms_pct, 1.0, 1e-6);

  int tick = 0;
  const auto turned_once = [&](const Vector3d& hip) -> Vector3d {
    const Vector3d force = exact(slide())(hip);
    if (++tick != 700) return force;
    const Vector3d aside = force.cross(Vector3d::UnitX()).normalized();
    return force + std::tan(2 * std::numbers::pi / 180) * force.norm() * aside;
  };
  EXPECT_NEAR(force_error(slide_on_sphere(slide(), turned_once)).direction_max_deg, 2.0, 1e-6);

  const auto none = [](const Vector3d&) -> Vector3d { return Vector3d::Zero(); };
  EXPECT_NEAR(force_error(slide_on_sphere(slide(), none)).magnitude_rms_pct, 100, 1e-9);
  EXPECT_NEAR(force_error(slide_on_sphere(slide(), none)).direction_max_deg, 180, 1e-9);
}

TEST(ForceError, TheHandMovesAsStated) {
  std::vector<Vector3d> path;
  slide_on_sphere(slide(), [&](const Vector3d& hip) -> Vector3d { return path.push_back(hip), Vector3d::Zero(); });
  const std::size_t steady = path.size() - 300;
  for (std::size_t i = steady; i < path.size(); ++i) {
    EXPECT_NEAR((path[i] - path[i - 1]).norm() * 1000, 300, 0.1);
    EXPECT_NEAR((path[i] - slide().centre).norm(), slide().radius - slide().depth, 1e-5);
  }
}

TEST(ForceError, NothingComparedIsAFailure) { EXPECT_THROW((void)force_error({}), InputError); }

}  // namespace
}  // namespace isotouch::evaluate
