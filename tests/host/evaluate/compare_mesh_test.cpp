#include "host/evaluate/compare_mesh.h"

#include <gtest/gtest.h>

#include <Eigen/Core>

#include "host/encoding/write_image.h"
#include "host/field/make_grid.h"
#include "host/field/sample_distance.h"
#include "tests/host/evaluate/ball_mesh.h"

namespace isotouch::evaluate {
namespace {

using Eigen::Vector3d;

constexpr double kBall = 6;   // mm, radius
constexpr double kStiff = 3;  // N/mm

field_file::OpenField stiff_ball(Interpolation interpolation) {
  encoding::FieldInfo info;
  info.stiffness_n_per_mm = kStiff;
  info.interpolation = interpolation;
  const Vector3d corner = Vector3d::Constant(kBall);
  const field::Grid grid = field::make_grid(-corner, corner, 0.4, 7);
  return field_file::open_field(
      encoding::write_image(field::sample_distance([](const Vector3d& p) { return p.norm() - kBall; }, grid, 3), info), "made");
}

TEST(CompareMesh, TheFloorHasTheFieldsStiffnessAndInterpolation) {
  const cloud::TriangleMesh mesh = ball(kBall, 5);
  for (const Interpolation interpolation : {Interpolation::kSpline, Interpolation::kTrilinear}) {
    const field_file::OpenField field = stiff_ball(interpolation);
    const field_file::OpenField floor = floor_of_mesh(field.view, mesh);
    EXPECT_EQ(floor.view.stiffness.raw(), field.view.stiffness.raw());
    EXPECT_EQ(floor.view.interpolation, interpolation);
  }
}

TEST(CompareMesh, AnotherMeshHasTheInterpolationThatIsAskedFor) {
  const cloud::TriangleMesh mesh = ball(kBall, 3);
  for (const Interpolation interpolation : {Interpolation::kSpline, Interpolation::kTrilinear})
    EXPECT_EQ(field_of_mesh(mesh, 0.4, 3, interpolation).view.interpolation, interpolation);
}

}  // namespace
}  // namespace isotouch::evaluate
