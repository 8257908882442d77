#include "host/live/face_sensor.h"

#include <gtest/gtest.h>

#include <vector>

namespace isotouch::live {
namespace {

using Eigen::Vector3d;

/// The normal of a point in the origin, which points upwards.
Vector3d faced(const SensorPlace& sensor) {
  const std::vector<Vector3d> positions = {Vector3d::Zero()};
  std::vector<Vector3d> normals = {Vector3d(0, 0, 1)};
  face_sensor(sensor, positions, normals);
  return normals[0];
}

const Vector3d kAbove(1, 2, 3), kBelow(1, 2, -3);

TEST(FaceSensor, APlaceThatAPersonGivesCountsForEveryNormal) {
  EXPECT_EQ(faced({kBelow, kAbove, true}).z(), -1);
  EXPECT_EQ(faced({kBelow, {}, false}).z(), -1);
  EXPECT_EQ(faced({kAbove, kBelow, true}).z(), 1);
}

TEST(FaceSensor, APlaceInTheFileCountsForNormalsOfItsImage) {
  EXPECT_EQ(faced({{}, kBelow, true}).z(), -1);
  EXPECT_EQ(faced({{}, kBelow, false}).z(), 1);
}

TEST(FaceSensor, WithoutAPlaceOrWithoutNormalsNothingIsTurned) {
  EXPECT_EQ(faced({{}, {}, true}).z(), 1);
  const std::vector<Vector3d> positions = {Vector3d::Zero()};
  face_sensor({kBelow, {}, false}, positions, {});
}

}  // namespace
}  // namespace isotouch::live
