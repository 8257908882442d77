#include "host/encoding/certificate.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <vector>

#include "host/cloud/random.h"
#include "host/encoding/write_image.h"
#include "host/field/sample_distance.h"

namespace isotouch::encoding {
namespace {

using Eigen::Vector3d;

template <class Distance>
field_file::Image image_of(const Distance& distance, Interpolation interpolation = Interpolation::kSpline) {
  field::Grid grid;
  grid.origin = Vector3d::Constant(-20);
  grid.size = Eigen::Vector3i::Constant(41);
  FieldInfo info;
  info.interpolation = interpolation;
  return write_image(field::sample_distance(distance, grid, 4.0), info);
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

/// The least value of the written spline on the line along z through the middle, where it does not depend on x and y.
double least_along_z(const field_file::Image& image) {
  const FieldView view = FieldView::parse(image.bytes()).value();
  double least = 1.0;
  for (int k = 2; k < 38; ++k) {
    for (double t = -0.5; t <= 0.5; t += 1.0 / 64) {
      const auto c = [&](int step) { return view.coefficient(20, 20, k + step) / 4096.0; };
      least = std::min(least, (0.5 - t) * (0.5 - t) / 2 * c(-1) + (0.75 - t * t) * c(0) + (0.5 + t) * (0.5 + t) / 2 * c(1));
    }
  }
  return least;
}

TEST(Certificate, FindsTheThinnestWallWhereverItLiesInTheGrid) {
  int found = 0, lost = 0;
  for (const double half : {0.1, 0.3, 0.4, 0.5, 0.6, 0.7, 0.9, 1.2, 1.5, 2.7, 3.4}) {
    for (double shift = 0.0; shift < 1.0; shift += 0.125) {
      const field_file::Image image = image_of([=](const Vector3d& p) { return plate(p + Vector3d(0, 0, shift), half); });
      const double wall = certificate(image).thinnest_wall_voxel;
      const double least = least_along_z(image);
      const bool must_be_found = least < -0.06 || half >= 0.5;
      EXPECT_EQ(wall > 0, must_be_found || (least < 0 && wall > 0)) << half << " at " << shift << ", " << least;
      if (wall > 0) {
        EXPECT_NEAR(wall, 2.0 * half, 0.35) << half << " at " << shift;
      }
      ++(must_be_found ? found : lost);
    }
  }
  EXPECT_GT(found, 60);
  EXPECT_GT(lost, 5) << "no wall so thin that the grid cannot hold it";
  const Eigen::Matrix3d turn = Eigen::Quaterniond(0.9, 0.3, -0.2, 0.25).normalized().toRotationMatrix();
  EXPECT_NEAR(certificate(image_of([&](const Vector3d& p) { return plate(turn * p, 2.0); })).thinnest_wall_voxel, 4.0, 0.25);
  for (const double half : {0.3, 0.5, 0.7}) {
    const double wall = certificate(image_of([&](const Vector3d& p) { return plate(turn * p, half); })).thinnest_wall_voxel;
    EXPECT_GT(wall, 0.0) << half;
    EXPECT_NEAR(wall, 2.0 * half, 0.45) << half;
  }
}

TEST(Certificate, FindsAWallOfAVoxelWhateverItsDirection) {
  // All directions up to what turning the grid does; the first is farthest from those to the 26 neighbours.
  std::vector<Vector3d> normals = {{1, std::sqrt(2.0) - 1, std::sqrt(3.0) - std::sqrt(2.0)}};
  for (int y = 0; y <= 8; ++y) {
    for (int z = 0; z <= y; ++z) normals.emplace_back(1, y / 8.0, z / 8.0);
  }
  for (const Vector3d& normal : normals) {
    for (const double thickness : {1.0, 2.0, 5.0}) {
      const Eigen::Quaterniond turn = Eigen::Quaterniond::FromTwoVectors(normal, Vector3d::UnitZ());
      const double wall =
          certificate(image_of([&](const Vector3d& p) { return plate(turn * p / 0.75, thickness / 1.5) * 0.75; })).thinnest_wall_voxel;
      EXPECT_NEAR(wall, thickness, 0.45) << normal.transpose();
    }
  }
}

TEST(Certificate, APlateOfAnySizeIsNotSaidToBeThickerThanItIs) {
  cloud::Random random(4);
  double worst = 0;
  for (int n = 0; n < 500; ++n) {
    const Vector3d half(random.uniform(3.5, 9), random.uniform(3.5, 9), random.uniform(0.5, 3));
    const Eigen::Matrix3d turn =
        Eigen::Quaterniond(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1))
            .normalized()
            .toRotationMatrix();
    const Vector3d move(random.uniform(0, 1), random.uniform(0, 1), random.uniform(0, 1));
    const auto distance = [&](const Vector3d& p) {
      const Vector3d q = (turn * (p + move)).cwiseAbs() - half;
      return std::min(q.maxCoeff(), 0.0) + q.cwiseMax(0.0).norm();
    };
    const double wall = certificate(image_of(distance)).thinnest_wall_voxel;
    EXPECT_GT(wall, 0.0);
    EXPECT_LE(wall, 2 * half.z() + 1e-3);
    worst = std::max(worst, 2 * half.z() - wall);
  }
  EXPECT_LT(worst, 0.6);
  EXPECT_GT(worst, 0.45) << "better than certificate.h says";
}

TEST(Certificate, AWallHasAnInsideBesideItsMiddle) {
  // Half a voxel up lies a wall of 1.2 voxels, and from x = 2 on one of 0.9, where no coefficient is negative.
  Surroundings distance;
  for (std::size_t n = 0; n < distance.size(); ++n) {
    const int x = static_cast<int>(n % 8) - 2, z = static_cast<int>(n / 64) - 2;
    distance[n] = std::abs(static_cast<float>(z) - 0.5F) - (x < 2 ? 0.6F : 0.45F);
  }
  Samples coefficients{};
  coefficients.fill(0.1F);
  for (std::size_t n = 0; n < coefficients.size(); n += 4) coefficients[n] = -0.1F;
  EXPECT_NEAR(thinnest_wall(distance, coefficients, 8), 1.2, 1e-6);
  coefficients.fill(-0.1F);
  EXPECT_NEAR(thinnest_wall(distance, coefficients, 8), 0.9, 1e-6);
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

TEST(Certificate, TheSlopeIsABoundOfEveryCellOfATrilinearField) {
  const field_file::Image image = image_of([](const Vector3d& p) { return plate(p, 1.5); }, Interpolation::kTrilinear);
  const FieldView view = FieldView::parse(image.bytes()).value();
  const double bound = certificate(image).largest_slope;
  double most = 0.0;  // along each axis a trilinear cell rises as one of its edges does, at most
  for (int k = 2; k < 38; ++k) {
    for (int j = 2; j < 38; ++j) {
      for (int i = 2; i < 38; ++i) {
        const auto number = [&](int x, int y, int z) { return view.coefficient(i + x, j + y, k + z) / 4096.0; };
        Vector3d rise = Vector3d::Zero();
        for (int n = 0; n < 4; ++n) {
          const int a = n & 1, b = n >> 1;
          rise = rise.cwiseMax(Vector3d(std::abs(number(1, a, b) - number(0, a, b)), std::abs(number(a, 1, b) - number(a, 0, b)),
                                        std::abs(number(a, b, 1) - number(a, b, 0))));
        }
        most = std::max(most, rise.norm());
      }
    }
  }
  EXPECT_GE(bound, most - 1e-4);
  EXPECT_LT(bound, 1.6 * most);
}

TEST(Certificate, TheAdvisedStiffnessIsThatOfTheFormula) {
  EXPECT_NEAR(advisable_stiffness(0.003, 0, 1'000'000), 6.0, 1e-12);
  EXPECT_NEAR(advisable_stiffness(0.003, 1, 1'000'000), 2.0, 1e-12);
  EXPECT_NEAR(advisable_stiffness(0.003, 3, 1'000'000), 6.0 / 7.0, 1e-12);
  EXPECT_NEAR(advisable_stiffness(0.003, 1, 250'000), 8.0, 1e-12);
}

}  // namespace
}  // namespace isotouch::encoding
