#include "host/field/local_model.h"

#include <gtest/gtest.h>

#include <cmath>

#include "host/cloud/shapes.h"

namespace isotouch::field {
namespace {

using Eigen::Vector3d;

std::vector<LocalModel> models_of(const cloud::OrientedPoints& points) { return local_models(Scan(points)); }

std::vector<std::size_t> counts(const std::vector<LocalModel>& models) {
  std::vector<std::size_t> result(kMaxPieces + 1, 0);
  for (const auto& model : models) ++result[model.count];
  return result;
}

TEST(LocalModels, OfASphereAreOnePieceEach) {
  const auto points = cloud::sample_shape(cloud::shape("sphere"), 1000);
  EXPECT_EQ(counts(models_of(points))[1], points.size());
}

TEST(LocalModels, OfARoundBarStayRound) {
  // Radius 12 with neighbours 4.5 apart: the normals turn by 20 degrees from sample to sample.
  const auto shape = cloud::shape("capsules");
  const auto points = cloud::sample_shape(shape, 3756);
  const auto models = models_of(points);
  std::size_t on_bar = 0, split = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double y = std::abs(points.positions[i].y());
    if (y < 32 || y > 50) continue;
    ++on_bar;
    split += models[i].count > 1;
  }
  ASSERT_GT(on_bar, 200U);
  EXPECT_LT(split, on_bar / 50);
}

TEST(LocalModels, AtTheEdgesOfABoxAreItsPlanes) {
  const auto points = cloud::sample_shape(cloud::shape("box"), 3756);
  const auto models = models_of(points);
  std::size_t checked = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    // Nearer to the edge between +x and +y than to its neighbours, away from the corners.
    const Vector3d& p = points.positions[i];
    if (p.x() < 76.5 || p.y() < 56.5 || std::abs(p.z()) > 30) continue;
    ++checked;
    EXPECT_NEAR(models[i].distance({80, 60, p.z()}), 0, 1e-6);
    EXPECT_NEAR(models[i].distance({79, 59, p.z()}), -1, 1e-6);
    EXPECT_NEAR(models[i].distance({81, 58, p.z()}), 1, 1e-6);
  }
  EXPECT_GT(checked, 10U);
}

TEST(LocalModels, KnowBothSidesOfAPlate) {
  const auto points = cloud::sample_shape(cloud::shape("plate"), 3756);
  const auto models = models_of(points);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vector3d& p = points.positions[i];
    if (std::abs(p.x()) > 76 || std::abs(p.y()) > 56) continue;
    EXPECT_NEAR(models[i].distance({p.x(), p.y(), 2.5}), 0.5, 0.1);
    EXPECT_NEAR(models[i].distance({p.x(), p.y(), -2.5}), 0.5, 0.1);
    EXPECT_NEAR(models[i].distance({p.x(), p.y(), 0}), -2, 0.1);
  }
}

TEST(LocalModels, JoinACreaseByUnion) {
  // Two faces of a notch that meet in the y axis, solid below and behind.
  cloud::OrientedPoints points;
  for (int i = 0; i < 6; ++i) {
    for (int j = 0; j < 12; ++j) {
      points.positions.emplace_back(0.4 + i, j + 0.3 * (i % 2), 0);
      points.normals.emplace_back(0, 0, 1);
      points.positions.emplace_back(0, j + 0.3 * (i % 2), 0.7 + i);
      points.normals.emplace_back(1, 0, 0);
    }
  }
  const auto models = models_of(points);
  std::size_t checked = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vector3d& p = points.positions[i];
    if (p.x() + p.z() > 1.0 || p.y() < 3 || p.y() > 8) continue;
    ++checked;
    EXPECT_NEAR(models[i].distance({0.5, p.y(), 0.8}), 0.5, 1e-6);
    EXPECT_NEAR(models[i].distance({-0.5, p.y(), 0.8}), -0.5, 1e-6);
    EXPECT_NEAR(models[i].distance({0.8, p.y(), -0.5}), -0.5, 1e-6);
  }
  EXPECT_GT(checked, 5U);
}

TEST(LocalModels, KeepTheirSignBeyondTheirReach) {
  // A shallow bowl: its torus comes round again far above it, the model must not.
  cloud::OrientedPoints points;
  for (int i = -6; i <= 6; ++i) {
    for (int j = -6; j <= 6; ++j) {
      const Vector3d p(i, j, 10.0 - std::sqrt(100.0 - i * i - j * j));
      points.positions.push_back(p);
      points.normals.push_back((Vector3d(0, 0, 10) - p) / 10.0);
    }
  }
  const auto models = models_of(points);
  const auto& middle = models[6 * 13 + 6];
  for (const double height : {1.0, 5.0, 15.0, 25.0, 60.0}) {
    EXPECT_GT(middle.distance({0, 0, height}), 0.0);
    EXPECT_LT(middle.distance({0, 0, -height}), 0.0);
  }
}

TEST(LocalModels, SurviveCoincidentPointsAndTinySets) {
  const cloud::OrientedPoints same{{{1, 1, 1}, {1, 1, 1}, {1, 1, 1}}, {{0, 0, 1}, {0, 0, -1}, {1, 0, 0}}};
  for (const auto& model : models_of(same)) EXPECT_TRUE(std::isfinite(model.distance({2, 3, 4})));
  const cloud::OrientedPoints two{{{0, 0, 0}, {1, 0, 0}}, {{0, 0, 1}, {0, 0, 1}}};
  for (const auto& model : models_of(two)) EXPECT_NEAR(model.distance({0.5, 0, 1}), 1, 1e-9);
}

}  // namespace
}  // namespace isotouch::field
