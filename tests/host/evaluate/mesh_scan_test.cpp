#include "host/evaluate/mesh_scan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "host/evaluate/zero_surface.h"
#include "host/field/line_crossings.h"
#include "host/to_double.h"
#include "tests/support/field_image.h"

namespace isotouch::evaluate {
namespace {

using Eigen::Vector3d;

struct Tick {
  Input input;
  Output output;
};

/// Two balls that run into each other, with a crease between them; in the middle of the workspace.
const cloud::TriangleMesh& body() {
  static const cloud::TriangleMesh mesh =
      zero_surface(test::FieldImage({60, 40, 40}, [](const test::Point& p) {
                     return std::min(test::length(p - test::Point{20, 20, 20}) - 12, test::length(p - test::Point{38, 21, 19}) - 10);
                   }).view());
  return mesh;
}

MeshScanReport scan(const MeshScanOptions& options, std::vector<Tick>& ticks) {
  const field::TriangleTree tree(body());
  ticks.clear();
  return scan_mesh(tree, options, [&](const Input& input, const Output& output) { ticks.push_back({input, output}); });
}

TEST(MeshScan, TheHandIsAHandAndTheGodObjectStaysOutside) {
  std::vector<Tick> ticks;
  const MeshScanReport report = scan({.seconds = 12, .seed = 3}, ticks);
  const field::TriangleTree tree(body());
  ASSERT_EQ(report.ticks, ticks.size());
  EXPECT_GT(report.ticks, 5000U);
  EXPECT_GT(report.touching, report.ticks / 2);
  EXPECT_LT(report.touching, report.ticks);
  EXPECT_GE(report.strokes, 2U);
  EXPECT_GT(report.reached, report.targets * 7 / 10);
  for (std::size_t i = 0; i < ticks.size(); ++i) {
    const auto& [input, output] = ticks[i];
    const Vector3d hip = to_double(input.hip), proxy = to_double(output.proxy), force = to_double(output.force);
    const Vector3d before = to_double(ticks[i == 0 ? 0 : i - 1].input.hip);
    ASSERT_LT((hip - before).norm(), 0.41) << "faster than a hand";
    ASSERT_LT((force - 0.8 * (proxy - hip)).norm(), 1e-4);
    ASSERT_EQ((output.status & kContact) != 0, force.norm() > 0);
    ASSERT_FALSE(i % 10 == 0 && tree.nearest(proxy).distance > 1e-5 && field::is_inside(tree, proxy));  // a trace rounds to 1e-6 mm
  }
}

TEST(MeshScan, IsTheSameForASeedAndAnotherForAnother) {
  std::vector<Tick> a, b, c;
  scan({.seconds = 3, .seed = 1}, a);
  scan({.seconds = 3, .seed = 1}, b);
  scan({.seconds = 3, .seed = 2}, c);
  ASSERT_EQ(a.size(), b.size());
  std::size_t same = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].input.hip, b[i].input.hip);
    EXPECT_EQ(a[i].output, b[i].output);
    same += i < c.size() && a[i].input.hip == c[i].input.hip ? 1U : 0U;
  }
  EXPECT_LT(same, a.size() / 2);
}

}  // namespace
}  // namespace isotouch::evaluate
