#include "host/view/surface_mesh.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <utility>

#include "tests/host/view/sphere_field.h"

namespace isotouch::view {
namespace {

double volume(const SurfaceMesh& mesh) {
  double sum = 0;
  for (const auto& [a, b, c] : mesh.faces)
    sum += mesh.positions[a].cast<double>().dot(mesh.positions[b].cast<double>().cross(mesh.positions[c].cast<double>())) / 6;
  return sum;
}

/// Each edge belongs to two faces, once in each direction.
bool is_closed(const SurfaceMesh& mesh) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (const auto& face : mesh.faces) {
    for (std::size_t i = 0; i < 3; ++i) ++edges[{face[i], face[(i + 1) % 3]}];
  }
  return std::all_of(edges.begin(), edges.end(), [&](const auto& edge) {
    const auto back = edges.find({edge.first.second, edge.first.first});
    return back != edges.end() && back->second == edge.second;
  });
}

class EveryStep : public testing::TestWithParam<std::pair<int, std::size_t>> {};

TEST_P(EveryStep, ASphereIsClosedAndWhereItIs) {
  const auto [step, vertices] = GetParam();
  const SphereField field;
  const SurfaceMesh mesh = surface_mesh(field.view, {}, vertices);
  EXPECT_EQ(mesh.step, step);
  EXPECT_TRUE(is_closed(mesh));
  const double exact = 4.0 / 3 * M_PI * kTestRadius * kTestRadius * kTestRadius;
  EXPECT_NEAR(volume(mesh) / exact, 1, 0.01 * step * step);
  EXPECT_GT(volume(mesh), 0) << "faces outward";
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    ASSERT_NEAR(mesh.positions[i].norm(), kTestRadius, 0.01 * kTestEdge);
    ASSERT_GT(mesh.normals[i].dot(mesh.positions[i].normalized()), 0.999F);
    ASSERT_EQ(mesh.invented[i], 0);
  }
}

INSTANTIATE_TEST_SUITE_P(SurfaceMesh, EveryStep,
                         testing::Values(std::pair(1, std::size_t{1'000'000}), std::pair(2, std::size_t{3'000}),
                                         std::pair(4, std::size_t{10})));

TEST(SurfaceMesh, MarksWhatWasInvented) {
  const SphereField field;
  field_file::Marks marks;
  for (int k = 0; k < 48; k += 4) {
    for (int j = 0; j < 48; j += 4) {
      for (int i = 0; i < 24; i += 4) marks.mark(field.view, i, j, k);
    }
  }
  const SurfaceMesh mesh = surface_mesh(field.view, marks, 1'000'000);
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const double x = static_cast<double>(mesh.positions[i].x());
    if (std::abs(x) > kTestEdge) {
      ASSERT_EQ(mesh.invented[i], x < 0 ? 1 : 0) << x;
    }
  }
}

}  // namespace
}  // namespace isotouch::view
