#include "host/field/line_of_sight.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "host/cloud/random.h"
#include "host/cloud/shapes.h"
#include "host/field/orientation.h"

namespace isotouch::field {
namespace {

using cloud::OrientedPoints;
using Eigen::Vector3d;

const Vector3d kEye = Vector3d(2, 3, 6) / 7;
const double kFourDegrees = std::cos(0.0698), kEightDegrees = std::cos(0.1396);

/// What of a shape looks at an eye far away; most of its normals look elsewhere.
OrientedPoints half_of(const char* shape, const Vector3d& eye) {
  const OrientedPoints whole = cloud::sample_shape(cloud::shape(shape), 4000);
  OrientedPoints seen;
  for (std::size_t i = 0; i < whole.size(); ++i) {
    if (whole.normals[i].dot(eye) < 0.1) continue;
    seen.positions.push_back(whole.positions[i]);
    seen.normals.push_back(whole.normals[i]);
  }
  return seen;
}

TEST(LineOfSight, IsWhereAllNormalsLook) {
  for (const char* name : {"sphere", "torus", "hydrant", "jaguar", "owl"}) {
    const Scan scan(half_of(name, kEye));
    EXPECT_GT(line_of_sight(scan, facing(scan).front).dot(kEye), kFourDegrees) << name;
  }
  const Scan torus(half_of("torus", kEye));
  EXPECT_LT(facing(torus).front.dot(kEye), kEightDegrees);  // the mean normal is elsewhere
}

TEST(LineOfSight, GoesToASensorThatIsKnown) {
  OrientedPoints points = half_of("torus", kEye);
  for (Vector3d& p : points.positions) p += Vector3d(10, 0, 0);
  Eigen::AlignedBox3d box;
  for (const Vector3d& p : points.positions) box.extend(p);
  const Vector3d way = Vector3d(1, 2, 2) / 3;
  EXPECT_GT(line_of_sight(Scan(points), kEye, box.center() + 500 * way).dot(way), 1.0 - 1e-12);
  EXPECT_EQ(line_of_sight(Scan(points), kEye, box.center()), kEye);
}

TEST(LineOfSight, HardlyHearsFewWrongNormals) {
  OrientedPoints points = half_of("torus", kEye);
  for (std::size_t i = 0; i < points.size(); i += 250) points.normals[i] = -points.normals[i];
  const Scan scan(points);
  EXPECT_GT(line_of_sight(scan, facing(scan).front).dot(kEye), kFourDegrees);
}

TEST(LineOfSight, StaysWhereNormalsLeaveAChoice) {
  OrientedPoints sheet;
  cloud::Random random(1);
  for (int i = 0; i < 500; ++i) {
    sheet.positions.emplace_back(random.uniform(-20, 20), random.uniform(-20, 20), 0.0);
    sheet.normals.push_back(Vector3d::UnitZ());
  }
  EXPECT_EQ(line_of_sight(Scan(sheet), Vector3d::UnitZ()), Vector3d::UnitZ());
}

}  // namespace
}  // namespace isotouch::field
