#include "host/evaluate/sharp_edges.h"

#include <gtest/gtest.h>

#include <utility>

#include "host/evaluate/truth_comparison.h"
#include "tests/host/evaluate/ball_mesh.h"
#include "tests/host/evaluate/box_mesh.h"
#include "tests/host/field/box_mesh.h"

namespace isotouch::evaluate {
namespace {

using Eigen::Vector3d;

TEST(SharpEdges, ABoxHasTwelveAndTheDiagonalsOfItsSidesAreNone) {
  const auto edges = sharp_edges(box({0, 0, 0}, {1, 2, 3}), 30);
  ASSERT_EQ(edges.size(), 12U);
  double length = 0;
  for (const SharpEdge& edge : edges) {
    EXPECT_NEAR(edge.turn_deg, 90, 1e-9);
    EXPECT_NEAR(edge.normals[0].dot(edge.normals[1]), 0, 1e-12);
    length += (edge.end - edge.begin).norm();
  }
  EXPECT_NEAR(length, 4 * (1 + 2 + 3), 1e-12);
  EXPECT_TRUE(sharp_edges(box({0, 0, 0}, {1, 2, 3}), 91).empty());
}

TEST(SharpEdges, VerticesAtOnePlaceAreOne) {
  cloud::TriangleMesh apart;
  const auto whole = box({0, 0, 0}, {1, 2, 3});
  for (const auto& face : whole.faces) {
    const auto first = static_cast<std::uint32_t>(apart.vertices.size());
    for (const std::uint32_t v : face) apart.vertices.push_back(whole.vertices[v]);
    apart.faces.push_back({first, first + 1, first + 2});
  }
  EXPECT_EQ(sharp_edges(apart, 30).size(), 12U);
}

TEST(SharpEdges, ABallHasNone) { EXPECT_TRUE(sharp_edges(ball(1, 4), 30).empty()); }

TEST(SharpEdges, AnInnerEdgeIsConcave) {
  // A box from whose top a wedge was cut: one edge at the bottom of the cut.
  cloud::TriangleMesh mesh;
  mesh.vertices = {{0, 0, 0}, {4, 0, 0}, {4, 0, 4}, {2, 0, 2}, {0, 0, 4}, {0, 3, 0}, {4, 3, 0}, {4, 3, 4}, {2, 3, 2}, {0, 3, 4}};
  const auto quad = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    mesh.faces.push_back({a, b, c});
    mesh.faces.push_back({a, c, d});
  };
  mesh.faces = {{0, 1, 3}, {1, 2, 3}, {0, 3, 4}, {5, 8, 6}, {6, 8, 7}, {5, 9, 8}};
  quad(0, 5, 6, 1), quad(1, 6, 7, 2), quad(2, 7, 8, 3), quad(3, 8, 9, 4), quad(4, 9, 5, 0);
  cloud::require_closed(mesh, "cut box");
  std::size_t concave = 0;
  for (const SharpEdge& edge : sharp_edges(mesh, 30)) {
    if (edge.turn_deg > 0) continue;
    ++concave;
    EXPECT_NEAR(edge.turn_deg, -90, 1e-9);
    EXPECT_EQ((edge.end - edge.begin).cwiseAbs(), Vector3d(0, 3, 0));
  }
  EXPECT_EQ(concave, 1U);
}

TEST(SharpEdges, OfABodyOfPiecesAreThoseThatCanBeTouched) {
  const auto foot = box({0, 0, 0}, {20, 20, 10});
  const auto lengths = [](const cloud::TriangleMesh& mesh) {
    const TrueSurface surface = true_surface(mesh);
    const field::TriangleTree outer(surface.outer), closed(surface.closed);
    std::pair<double, double> found;
    for (const SharpEdge& edge : bounding_edges({outer, closed}, 30))
      (edge.turn_deg > 0 ? found.first : found.second) += (edge.end - edge.begin).norm();
    return found;
  };
  const auto one = lengths(foot);
  EXPECT_NEAR(one.first, 4 * (20 + 20 + 10), 1e-9);
  // Towers on the middle of it, and on an edge, where 4 of 20 mm are covered.
  const auto on_top = lengths(field::together(foot, box({8, 8, 10}, {12, 12, 30})));
  EXPECT_NEAR(on_top.first, 4 * (20 + 20 + 10) + 4 * 4 + 4 * 20, 1e-9);
  const auto on_edge = lengths(field::together(foot, box({18, 8, 8}, {22, 12, 30})));
  EXPECT_NEAR(on_edge.first, 4 * (20 + 20 + 10) - 4 + 4 * 4 + 2 * 22 + 2 * 20 + 4 + 2 * 2, 2.5);
  // Three boxes that share vertices: an L, where six faces meet in the crease.
  const auto lower = field::joined(box({0, 0, 0}, {20, 10, 10}), box({0, 10, 0}, {20, 20, 10}));
  const auto corner = lengths(field::joined(lower, box({0, 10, 10}, {20, 20, 20})));
  EXPECT_NEAR(corner.first, 5 * 20 + 2 * 80, 1e-9);
  EXPECT_NEAR(corner.second, 20, 1e-9);
}

}  // namespace
}  // namespace isotouch::evaluate
