#include "host/encoding/certificate.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "host/encoding/write_image.h"
#include "host/field/sample_distance.h"

namespace isotouch::encoding {
namespace {

using Eigen::Vector3d;

template <class Distance>
field_file::Image image_of(const Distance& distance) {
  field::Grid grid;
  grid.origin = Vector3d::Constant(-20);
  grid.size = Eigen::Vector3i::Constant(41);
  return write_image(field::sample_distance(distance, grid, 4.0), {});
}

Certificate certificate(const field_file::Image& image) { return certificate_of(FieldView::parse(image.bytes()).value()); }

double plate(const Vector3d& p, double half) {
  const Vector3d q = p.cwiseAbs() - Vector3d(11.3, 10.6, half);
  return std::min(q.maxCoeff(), 0.0) + q.cwiseMax(0.0).norm();
}

TEST(Certificate, ASphereIsNoSteeperThanItsDistanceAndHasNoWall) {
  const auto found = certificate(image_of([](const Vector3d& p) { return p.norm() - 12.2; }));
  EXPECT_GT(found.largest_slope, 1.0);
  EXPECT_LT(found.largest_slope, 1.25);
  EXPECT_EQ(found.thinnest_wall_voxel, 0.0);
}

TEST(Certificate, FindsTheThinnestWallWhereverItLiesInTheGrid) {
  for (const double half : {1.2, 1.5, 2.7, 3.4}) {
    for (const double shift : {0.0, 0.3, 0.5}) {
      const auto found = certificate(image_of([=](const Vector3d& p) { return plate(p + Vector3d(0, 0, shift), half); }));
      EXPECT_NEAR(found.thinnest_wall_voxel, 2.0 * half, 0.35) << half << " at " << shift;
    }
  }
  const Eigen::Matrix3d turn = Eigen::Quaterniond(0.9, 0.3, -0.2, 0.25).normalized().toRotationMatrix();
  EXPECT_NEAR(certificate(image_of([&](const Vector3d& p) { return plate(turn * p, 2.0); })).thinnest_wall_voxel, 4.0, 0.25);
}

TEST(Certificate, TheEdgesOfABoxAreNoWalls) {
  EXPECT_EQ(certificate(image_of([](const Vector3d& p) { return plate(p, 9.0); })).thinnest_wall_voxel, 0.0);
}

TEST(Certificate, TheSlopeIsABoundOfTheSpline) {
  const auto distance = [](const Vector3d& p) { return plate(p, 1.5); };
  const field_file::Image image = image_of(distance);
  const double bound = certificate(image).largest_slope;
  // Between neighbouring samples the spline rises at most by the bound; the samples of its own distances are 2^-13 from these.
  double most = 0.0;
  for (double x = -18.0; x < 18.0; x += 0.37) {
    for (double z = -8.0; z < 8.0; z += 0.5) {
      const Vector3d p(x, 0.21 * x, z);
      const Vector3d ahead(1e-3, 0, 0), up(0, 0, 1e-3);
      most = std::max(most, std::hypot(distance(p + ahead) - distance(p), distance(p + up) - distance(p)) / 1e-3);
    }
  }
  EXPECT_GE(bound, most);
  EXPECT_LT(bound, 3.0);
}

TEST(Certificate, TheAdvisedStiffnessIsThatOfTheFormula) {
  EXPECT_NEAR(advisable_stiffness(0.003, 0, 1'000'000), 6.0, 1e-12);
  EXPECT_NEAR(advisable_stiffness(0.003, 1, 1'000'000), 2.0, 1e-12);
  EXPECT_NEAR(advisable_stiffness(0.003, 3, 1'000'000), 6.0 / 7.0, 1e-12);
  EXPECT_NEAR(advisable_stiffness(0.003, 1, 250'000), 8.0, 1e-12);
}

}  // namespace
}  // namespace isotouch::encoding
