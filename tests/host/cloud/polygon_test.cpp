#include "host/cloud/polygon.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "host/error.h"

namespace isotouch::cloud {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using Outline = std::vector<Vector2d>;

/// The polygon's faces, with its first corner at `first`. It lies askew in space.
Model cut(const Outline& outline, std::size_t first = 0) {
  const Eigen::Matrix3d turn = Eigen::Quaterniond(0.7, 0.3, -0.5, 0.4).normalized().toRotationMatrix();
  Model model;
  std::vector<std::uint32_t> corners;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    model.positions.push_back(turn * Vector3d(outline[i].x(), outline[i].y(), 5));
    corners.push_back(static_cast<std::uint32_t>((first + i) % outline.size()));
  }
  add_polygon(model, corners, 12, 1);
  cut_polygons(model, "f.obj");
  return model;
}

/// Twice the area of the faces, of each its absolute value.
double covered(const Model& model) {
  double sum = 0;
  for (const auto& [a, b, c] : model.faces)
    sum += (model.positions[b] - model.positions[a]).cross(model.positions[c] - model.positions[a]).norm();
  return sum;
}

double area(const Outline& outline) {
  double sum = 0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vector2d &a = outline[i], &b = outline[(i + 1) % outline.size()];
    sum += a.x() * b.y() - a.y() * b.x();
  }
  return sum;
}

/// Every edge that is run once is one of the polygon's own, in its direction; all others are run as often back.
void expect_rim(const Model& model, const char* what) {
  const std::size_t count = model.positions.size();
  std::vector<int> runs(count * count);
  for (const auto& face : model.faces) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t a = face[i], b = face[(i + 1) % 3];
      ++runs[a * count + b];
      --runs[b * count + a];
    }
  }
  for (std::size_t a = 0; a < count; ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      const int expected = b == (a + 1) % count ? 1 : a == (b + 1) % count ? -1 : 0;
      EXPECT_EQ(runs[a * count + b], expected) << what << ": " << a << " to " << b;
    }
  }
}

const Outline kEll = {{0, 0}, {4, 0}, {4, 1}, {1, 1}, {1, 3}, {0, 3}};

TEST(Polygon, IsCoveredOnceWhereverItBegins) {
  Outline star, comb = {{0, 0}};
  for (int n = 0; n < 14; ++n)
    star.push_back((n % 2 == 0 ? 3.0 : 0.7) * Vector2d(std::cos(n * std::numbers::pi / 7), std::sin(n * std::numbers::pi / 7)));
  for (int n = 0; n < 6; ++n) {
    comb.emplace_back(2 * n + 1, 0);
    comb.emplace_back(2 * n + 1, 5);
    comb.emplace_back(2 * n + 2, 5);
    comb.emplace_back(2 * n + 2, 0);
  }
  comb.emplace_back(13, 0);
  comb.emplace_back(13, 6);
  comb.emplace_back(0, 6);
  const Outline dart = {{0, 0}, {2, 1}, {4, 0}, {2, 4}};
  const Outline midpoints = {{0, 0}, {2, 0}, {4, 0}, {4, 1}, {2, 1}, {1, 1}, {1, 2}, {1, 3}, {0, 3}, {0, 1}};
  const Outline frame = {{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0},
                         {1, 1}, {1, 3}, {3, 3}, {3, 1}, {1, 1}};  // its hole is reached along a seam
  const std::pair<const char*, const Outline*> outlines[] = {{"L", &kEll},    {"star", &star},           {"comb", &comb},
                                                             {"dart", &dart}, {"midpoints", &midpoints}, {"frame", &frame}};
  for (const auto& [what, outline] : outlines) {
    for (std::size_t first = 0; first < outline->size(); ++first) {
      const Model model = cut(*outline, first);
      ASSERT_EQ(model.faces.size(), outline->size() - 2);
      EXPECT_NEAR(covered(model), area(*outline), 1e-9) << what << " from " << first;
      expect_rim(model, what);
    }
  }
}

TEST(Polygon, KeepsItsFanWhereThatCoversIt) {
  const Model square = cut({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, 2);
  EXPECT_EQ(square.faces, (std::vector<std::array<std::uint32_t, 3>>{{2, 3, 0}, {2, 0, 1}}));
  const Model ell = cut(kEll, 3);
  EXPECT_EQ(ell.faces.front(), (std::array<std::uint32_t, 3>{3, 4, 5}));
  EXPECT_EQ(ell.faces.back(), (std::array<std::uint32_t, 3>{3, 1, 2}));
}

std::string cut_refusal(const Outline& outline) {
  try {
    cut(outline);
  } catch (const InputError& e) {
    return e.what();
  }
  return "accepted";
}

TEST(Polygon, OneThatCannotBeCutIsRefusedWithItsPlace) {
  EXPECT_EQ(
      cut_refusal({{0, 0}, {4, 0}, {1, 3}, {3, 4}}),
      "f.obj: line 12: a polygon of 4 corners crosses itself or cannot be cut into triangles; triangulate the faces in a mesh program");
  EXPECT_THAT(cut_refusal({{0, 0}, {4, 0}, {4, 4}, {2, -1}, {0, 4}}), ::testing::HasSubstr("crosses itself"));
}

TEST(Polygon, IsCutHoweverItIsTurnedAndWarped) {
  const Outline clamp = {{0, 0}, {40, 0}, {40, 19.8}, {5, 19.8}, {5, 20.2}, {40, 20.2}, {40, 40}, {0, 40}};
  for (int turn = 0; turn < 60; ++turn) {
    const Eigen::Matrix3d axes =
        (Eigen::AngleAxisd(0.7 * turn, Vector3d::UnitZ()) * Eigen::AngleAxisd(0.31 * turn, Vector3d(1, 1, 0).normalized()) *
         Eigen::AngleAxisd(1.3 * turn, Vector3d::UnitZ()))
            .toRotationMatrix();
    Model model;
    std::vector<std::uint32_t> corners;
    for (std::size_t i = 0; i < clamp.size(); ++i) {
      const double warp = std::sin(7.0 * static_cast<double>(i) + turn);  // up and down by more than the slot is wide
      model.positions.push_back(axes * Vector3d(clamp[i].x(), clamp[i].y(), warp));
      corners.push_back(static_cast<std::uint32_t>(i));
    }
    add_polygon(model, corners, 12, 1);
    ASSERT_NO_THROW(cut_polygons(model, "f.obj")) << turn;
    EXPECT_NEAR(covered(model), area(clamp), 0.02 * area(clamp)) << turn;
  }
}

TEST(Polygon, AHugeOneIsCutOrRefusedInTime) {
  // A spiral of two arms of corners: most ears are far from each other.
  Outline spiral;
  const int half = 5000;
  for (int n = 0; n < half; ++n) spiral.push_back((10 + 0.05 * n) * Vector2d(std::cos(0.05 * n), std::sin(0.05 * n)));
  for (int n = half; n-- > 0;) spiral.push_back((9 + 0.05 * n) * Vector2d(std::cos(0.05 * n), std::sin(0.05 * n)));
  const std::string said = cut_refusal(spiral);
  EXPECT_TRUE(said == "accepted" || said.find("takes too long") != std::string::npos) << said;
}

}  // namespace
}  // namespace isotouch::cloud
