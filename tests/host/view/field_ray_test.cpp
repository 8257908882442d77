#include "host/view/field_ray.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/host/view/sphere_field.h"

namespace isotouch::view {
namespace {

TEST(FieldRays, MeetTheSphereWhereItIs) {
  const SphereField field;
  const FieldRays rays(field.view);
  int met = 0;
  for (int i = 0; i < 200; ++i) {
    // Parallel rays from all sides, up to 95 % of the radius beside the centre.
    const Eigen::Vector3d direction = Eigen::Vector3d(std::cos(0.7 * i), std::sin(1.3 * i), std::sin(0.37 * i + 1)).normalized();
    const Eigen::Vector3d side = direction.unitOrthogonal() * (0.95 * kTestRadius * i / 200);
    const Ray ray{side - 30 * direction, direction};
    const auto t = rays.hit(ray, 0, 1e4);
    ASSERT_TRUE(t.has_value()) << i;
    const double exact = 30 - std::sqrt(kTestRadius * kTestRadius - side.squaredNorm());
    EXPECT_NEAR(*t, exact, 0.02 * kTestEdge / std::sqrt(1 - side.squaredNorm() / (kTestRadius * kTestRadius))) << i;
    EXPECT_LT((rays.value(ray.at(*t)).gradient.normalized() - ray.at(*t).normalized()).norm(), 0.01);
    ++met;
  }
  EXPECT_EQ(met, 200);
}

TEST(FieldRays, PassBesideTheSphereWithoutAHit) {
  const SphereField field;
  const FieldRays rays(field.view);
  for (const double beside : {1.01, 1.1, 2.0, 50.0}) {
    EXPECT_FALSE(rays.hit({Eigen::Vector3d(beside * kTestRadius, 0, 40), Eigen::Vector3d(0, 0, -1)}, 0, 1e4).has_value()) << beside;
  }
  EXPECT_FALSE(rays.hit({Eigen::Vector3d(0, 0, 40), Eigen::Vector3d(0, 0, 1)}, 0, 1e4).has_value()) << "away from it";
  EXPECT_FALSE(rays.hit({Eigen::Vector3d(0, 0, 40), Eigen::Vector3d(0, 0, -1)}, 0, 31).has_value()) << "ends before it";
}

TEST(FieldRays, ThroughAFieldWithoutABodyComeToAnEnd) {
  field::BandField nothing = SphereField::field();
  nothing.bricks.clear();
  const field_file::Image image = encoding::write_image(nothing, {});
  const FieldView view = *FieldView::parse(image.bytes());
  const FieldRays rays(view);
  for (int i = 0; i < 50; ++i) {
    const Eigen::Vector3d direction = Eigen::Vector3d(std::cos(0.7 * i), std::sin(1.3 * i), std::sin(0.37 * i + 1)).normalized();
    EXPECT_FALSE(rays.hit({-30 * direction, direction}, 0, 1e4).has_value());
  }
}

TEST(FieldRays, ThatBeginInsideHitAtOnce) {
  const SphereField field;
  const FieldRays rays(field.view);
  const auto t = rays.hit({Eigen::Vector3d(0, 0, 40), Eigen::Vector3d(0, 0, -1)}, 38, 1e4);
  ASSERT_TRUE(t.has_value());
  EXPECT_DOUBLE_EQ(*t, 38);
}

TEST(FieldRays, OutlineSurroundsTheSphereWithinABrick) {
  const SphereField field;
  const FieldRays rays(field.view);
  Box box;
  for (const Eigen::Vector3d& p : rays.outline()) box.extend(p);
  EXPECT_NEAR(box.max().maxCoeff(), kTestRadius, 4 * kTestEdge);
  EXPECT_NEAR(box.min().minCoeff(), -kTestRadius, 4 * kTestEdge);
}

}  // namespace
}  // namespace isotouch::view
