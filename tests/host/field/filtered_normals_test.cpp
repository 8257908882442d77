#include "host/field/filtered_normals.h"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>
#include <numbers>
#include <utility>

#include "host/cloud/random.h"
#include "host/cloud/shapes.h"
#include "tests/host/field/random_places.h"

namespace isotouch::field {
namespace {

using cloud::OrientedPoints;
using Eigen::Vector3d;

constexpr double kNoise = 0.37;  // 15 degrees in each of two directions

/// Root of the mean square of the differences.
double off(const std::vector<Vector3d>& normals, const OrientedPoints& truth) {
  double squares = 0.0;
  for (std::size_t i = 0; i < normals.size(); ++i) squares += (normals[i] - truth.normals[i]).squaredNorm();
  return std::sqrt(squares / static_cast<double>(normals.size()));
}

OrientedPoints tilted(OrientedPoints points) {
  cloud::Random random(2);
  for (Vector3d& n : points.normals) n = (n + kNoise / std::sqrt(2.0) * scatter(random)).normalized();
  return points;
}

TEST(FilteredNormals, AreNearerToTheTruthOnRoundAndSharpBodies) {
  for (const auto& [name, most] : {std::pair("torus", 0.3), std::pair("box", 0.45), std::pair("hydrant", 0.8)}) {
    const OrientedPoints truth = cloud::sample_shape(cloud::shape(name), 3756);
    const OrientedPoints noisy = tilted(truth);
    EXPECT_LT(off(filtered_normals(Scan(noisy), kNoise), truth), most * off(noisy.normals, truth)) << name;
  }
}

TEST(FilteredNormals, KeepTheFacesOfABoxApart) {
  const OrientedPoints truth = cloud::sample_shape(cloud::shape("box"), 3756);
  const std::vector<Vector3d> normals = filtered_normals(Scan(tilted(truth)), kNoise);
  std::size_t blurred = 0;
  for (std::size_t i = 0; i < normals.size(); ++i) blurred += normals[i].dot(truth.normals[i]) < 0.9 ? 1U : 0U;
  EXPECT_LT(blurred, normals.size() / 50);
}

/// Eight samples round a rod of radius 1.
TEST(FilteredNormals, FollowTheSurfaceRoundAThinRod) {
  cloud::Random random(3);
  OrientedPoints truth;
  for (int i = 0; i < 600; ++i) {
    const double angle = random.uniform(0.0, 2.0 * std::numbers::pi);
    truth.normals.emplace_back(std::cos(angle), std::sin(angle), 0.0);
    truth.positions.emplace_back(truth.normals.back() + Vector3d(0.0, 0.0, random.uniform(0.0, 60.0)));
  }
  const OrientedPoints noisy = tilted(truth);
  EXPECT_LT(off(filtered_normals(Scan(noisy), kNoise), truth), 0.3 * off(noisy.normals, truth));
}

TEST(FilteredNormals, TwinSamplesKeepTheirNormals) {
  const OrientedPoints twins{std::vector<Vector3d>(20, Vector3d::Zero()), std::vector<Vector3d>(20, Vector3d::UnitX()), {}};
  EXPECT_EQ(filtered_normals(Scan(twins), kNoise), twins.normals);
}

}  // namespace
}  // namespace isotouch::field
