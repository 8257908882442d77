#include "host/view/worst_picture.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>
#include <vector>

#include "tests/host/view/sphere_field.h"
#include "tests/support/sanitized.h"

namespace isotouch::view {
namespace {

/// A ball round the origin, appended; turned inside out it bounds a cavity.
void add_ball(cloud::TriangleMesh& mesh, double radius, bool inside_out = false) {
  constexpr std::uint32_t kRows = 24, kColumns = 48;
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  for (std::uint32_t row = 0; row <= kRows; ++row) {
    for (std::uint32_t column = 0; column < kColumns; ++column) {
      const double polar = std::numbers::pi * row / kRows, around = 2 * std::numbers::pi * column / kColumns;
      mesh.vertices.push_back(radius *
                              Eigen::Vector3d(std::sin(polar) * std::cos(around), std::sin(polar) * std::sin(around), std::cos(polar)));
    }
  }
  for (std::uint32_t row = 0; row < kRows; ++row) {
    for (std::uint32_t column = 0; column < kColumns; ++column) {
      const auto at = [&](std::uint32_t r, std::uint32_t c) { return first + r * kColumns + c % kColumns; };
      std::array<std::uint32_t, 4> corner = {at(row, column), at(row + 1, column), at(row + 1, column + 1), at(row, column + 1)};
      if (inside_out) std::swap(corner[1], corner[3]);
      mesh.faces.push_back({corner[0], corner[1], corner[2]});
      mesh.faces.push_back({corner[0], corner[2], corner[3]});
    }
  }
}

cloud::TriangleMesh ball(double radius) {
  cloud::TriangleMesh mesh;
  add_ball(mesh, radius);
  return mesh;
}

/// Pixels of the two panels that are clearly of a colour.
struct Colours {
  int red = 0, blue = 0, cut = 0;
};

Colours colours_of(const Image& image) {
  Colours found;
  for (int y = 30; y < image.height() - 60; ++y) {
    for (int x = 0; x < image.width() * 7 / 10; ++x) {
      const Colour& c = image.at(x, y);
      found.red += c.r > 1.8F * c.b ? 1 : 0;
      found.blue += c.b > 1.8F * c.r ? 1 : 0;
      found.cut += c.r > 1.2F * c.g && c.g > 1.2F * c.b && c.r > 0.5F ? 1 : 0;
    }
  }
  return found;
}

Image picture(const cloud::TriangleMesh& truth, const cloud::TriangleMesh& closed, const WorstPlace& worst) {
  const SphereField field;
  return worst_picture(field.view, ball(kTestRadius), truth, closed, worst, {.width = 480, .height = 320, .title = "ball"}).pixels();
}

Image picture(const cloud::TriangleMesh& truth, const WorstPlace& worst) { return picture(truth, truth, worst); }

TEST(WorstPicture, WhatStandsOutIsBlueAndWhatIsMissingIsRedOnBothSurfaces) {
  const Eigen::Vector3d front(0, 0, 1);
  for (const bool on_truth : test::examples<bool>({true, false})) {
    const auto worst = [&](double truth) {
      return WorstPlace{.place = (on_truth ? truth : kTestRadius) * front, .on_truth = on_truth, .distance_mm = 1, .voxel_mm = kTestEdge};
    };
    const Colours out = colours_of(picture(ball(kTestRadius - 1), worst(kTestRadius - 1)));
    EXPECT_GT(out.blue, 20000);
    EXPECT_LT(out.red, 200);
    const Colours missing = colours_of(picture(ball(kTestRadius + 1), worst(kTestRadius + 1)));
    EXPECT_GT(missing.red, 20000);
    EXPECT_LT(missing.blue, 200);
  }
}

TEST(WorstPicture, SurfacesThatAgreeHaveNoColour) {
  const Colours found = colours_of(
      picture(ball(kTestRadius), {.place = Eigen::Vector3d(0, 0, kTestRadius), .on_truth = true, .distance_mm = 0, .voxel_mm = kTestEdge}));
  EXPECT_EQ(found.blue, 0);
  EXPECT_EQ(found.red, 0);
}

TEST(WorstPicture, WhereTheFacesThatBoundTheTruthAreNotClosedNoColourIsWrong) {
  const cloud::TriangleMesh closed = ball(kTestRadius + 1);
  cloud::TriangleMesh truth = closed;
  std::erase_if(truth.faces, [&](const auto& face) { return truth.vertices[face[0]].x() < -0.9 * kTestRadius; });  // behind it
  const Colours found =
      colours_of(picture(truth, closed, {.place = Eigen::Vector3d(kTestRadius, 0, 0), .distance_mm = 1, .voxel_mm = kTestEdge}));
  EXPECT_GT(found.red, 15000);
  EXPECT_LT(found.blue, 200);
}

TEST(WorstPicture, APlaceThatNoEyeSeesIsCutOpen) {
  cloud::TriangleMesh truth = ball(kTestRadius);
  add_ball(truth, 2, true);
  const Colours found = colours_of(
      picture(truth, {.place = Eigen::Vector3d(0, 0, 2), .on_truth = true, .distance_mm = kTestRadius - 2, .voxel_mm = kTestEdge}));
  EXPECT_GT(found.cut, 2000);
}

}  // namespace
}  // namespace isotouch::view
