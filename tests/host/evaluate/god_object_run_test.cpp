#include "host/evaluate/god_object_run.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "host/encoding/write_image.h"
#include "host/field/make_grid.h"
#include "host/field/sample_distance.h"
#include "host/field_file/open_field.h"
#include "host/motion/device_in_hand.h"
#include "host/motion/motion.h"
#include "host/to_double.h"
#include "host/trace/rendering_difference.h"
#include "tests/host/evaluate/ball_mesh.h"
#include "tests/host/evaluate/box_mesh.h"

namespace isotouch::evaluate {
namespace {

using Eigen::Vector3d;
using trace::RenderingFigures;

constexpr double kRadius = 15;
constexpr double kEdge = 0.4;

field_file::OpenField field_of(const std::function<double(const Vector3d&)>& distance, double half) {
  const field::Grid grid = field::make_grid(Vector3d::Constant(-half), Vector3d::Constant(half), kEdge, 7);
  return field_file::open_field(encoding::write_image(field::sample_distance(distance, grid, 3), {}), "made");
}

std::vector<Input> motion_on(const FieldView& field, const std::string& kind, std::uint64_t ticks) {
  std::vector<Input> inputs;
  motion::make_motion(&field, {.kind = kind, .ticks = ticks}, [&](const Input& in) { inputs.push_back(in); });
  return inputs;
}

/// The controller's answers beside those of a god-object on the mesh.
RenderingFigures compare(const FieldView& field, const cloud::TriangleMesh& mesh, const std::vector<Input>& inputs,
                         const TraceHeader& header = {}) {
  const field::TriangleTree tree(mesh);
  trace::Run run(field, header);
  GodObjectRun god_object(field, tree, header);
  trace::RenderingDifference difference;
  for (const Input& input : inputs) difference.add(input.kind, run.step(input).output, god_object.step(input).output);
  return difference.figures();
}

/// An exact field of a ball, and the ball of triangles.
struct Ball {
  field_file::OpenField field = field_of([](const Vector3d& p) { return p.norm() - kRadius; }, kRadius + 0.5);
  cloud::TriangleMesh mesh = ball(kRadius, 6);
  std::vector<Input> tour = motion_on(field.view, "tour", 12'000);
};
const Ball& the_ball() {
  static const Ball ball;
  return ball;
}

cloud::TriangleMesh shifted(cloud::TriangleMesh mesh, const Vector3d& by) {
  for (Vector3d& vertex : mesh.vertices) vertex += by;
  return mesh;
}

// The mesh is off by half the angle between its faces, 0.6 degrees of 1.2, and by up to a thousandth of a millimetre in depth.
TEST(GodObjectRun, OnABallItFeelsWhatAnExactFieldFeels) {
  const RenderingFigures figures = compare(the_ball().field.view, the_ball().mesh, the_ball().tour);
  EXPECT_GT(figures.all.direction_deg.count, 5'000U);
  EXPECT_GT(figures.all.direction_deg.p95, 0.5);
  EXPECT_LT(figures.all.direction_deg.p95, 1.1);
  EXPECT_GT(figures.shallow.direction_deg.count, 500U);
  EXPECT_GT(figures.shallow.force_n.p95, 0.004);
  EXPECT_LT(figures.shallow.force_n.p95, 0.012);
  EXPECT_GT(figures.shallow.proxy_mm.p95, 0.005);
  EXPECT_LT(figures.shallow.proxy_mm.p95, 0.015);
  EXPECT_LT(figures.contact_differs, figures.touching / 100);
}

TEST(GodObjectRun, AMeshThatIsMovedByThreeTenthsOfAMillimetreIsFound) {
  const RenderingFigures sound = compare(the_ball().field.view, the_ball().mesh, the_ball().tour);
  const RenderingFigures moved = compare(the_ball().field.view, shifted(the_ball().mesh, {0.3, 0, 0}), the_ball().tour);
  EXPECT_GT(moved.all.force_n.median, 4 * sound.all.force_n.median);
  EXPECT_GT(moved.all.force_n.max, 0.2) << "0.8 N/mm times 0.3 mm";
  EXPECT_GT(moved.contact_differs, 3 * sound.contact_differs);
}

/// A turned slab, its exact field, and a hand that slides on it and presses.
struct Slab {
  Vector3d middle{0, 0, -3};
  Eigen::Matrix3d turn = Eigen::AngleAxisd(0.4, Vector3d(2, 1, 3).normalized()).toRotationMatrix();  // no axis of the grid
  cloud::TriangleMesh mesh = box({-20, -20, -3}, {20, 20, 3});
  field_file::OpenField field = field_of(
      [this](const Vector3d& p) {
        const Vector3d out = (turn.transpose() * (p - middle)).cwiseAbs() - Vector3d(20, 20, 3);
        return out.cwiseMax(0).norm() + std::min(out.maxCoeff(), 0.0);
      },
      34);
  std::vector<Input> hand;

  Slab() {
    for (Vector3d& vertex : mesh.vertices) vertex = turn * vertex + middle;
    for (int i = 0; i < 1500; ++i) {
      const double height = 4 + 1.5 * std::cos(i / 60.0);  // 1.5 mm deep to 2.5 mm above
      hand.push_back(position_input(to_fixed<Mm>(turn * Vector3d(8 * std::sin(i / 90.0), 7 * std::cos(i / 70.0), height) + middle)));
    }
  }
};

TEST(GodObjectRun, OnAPlaneItFeelsTheSameToAHundredthOfADegree) {
  const Slab slab;
  const RenderingFigures figures = compare(slab.field.view, slab.mesh, slab.hand);
  EXPECT_GT(figures.all.direction_deg.count, 300U);
  EXPECT_LT(figures.all.direction_deg.p95, 0.02);
  EXPECT_GT(figures.all.direction_deg.p95, 0.002) << "the field's numbers are rounded";
  EXPECT_LT(figures.all.force_n.p95, 0.0001);
  EXPECT_GT(figures.all.force_n.p95, 0.00001);
  EXPECT_LE(figures.contact_differs, 10U);
}

TEST(GodObjectRun, FrictionDampingLimitAndRampAreThoseOfTheRecording) {
  const Slab slab;
  TraceHeader header;
  header.settings.friction = Ratio::of(0.4);
  header.settings.damping = Damping::of(0.0005);
  header.settings.hand_damping = Damping::of(0.002);
  header.settings.force_limit = Newton::of(0.6);
  const RenderingFigures figures = compare(slab.field.view, slab.mesh, slab.hand, header);
  EXPECT_GT(figures.all.force_n.count, 300U);
  EXPECT_LT(figures.all.force_n.p95, 0.0001);
  EXPECT_GT(figures.all.force_n.p95, 0.00001);
  const field::TriangleTree tree(slab.mesh);
  TraceHeader rough;
  rough.settings = header.settings;
  rough.settings.friction = Ratio{};
  trace::Run run(slab.field.view, header);
  GodObjectRun smooth(slab.field.view, tree, rough);
  trace::RenderingDifference difference;
  for (const Input& input : slab.hand) difference.add(input.kind, run.step(input).output, smooth.step(input).output);
  EXPECT_GT(difference.figures().all.force_n.p95, 0.05) << "without friction it feels something else";
}

TEST(GodObjectRun, WhereTheStiffnessVariesItLeansAsTheFieldsProxyDoes) {
  const field::Grid grid = field::make_grid(Vector3d::Constant(-kRadius), Vector3d::Constant(kRadius), kEdge, 7);
  field::BandField made = field::sample_distance([](const Vector3d& p) { return p.norm() - kRadius; }, grid, 3);
  for (const field::Brick& brick : made.bricks)
    made.stiffness.push_back(0.8 + 0.04 * made.grid.position(4 * brick.cell + Eigen::Vector3i::Constant(2)).x());
  encoding::FieldInfo info;
  info.stiffness_n_per_mm = 1.4;
  const field_file::OpenField field = field_file::open_field(encoding::write_image(made, info), "made");
  const RenderingFigures figures = compare(field.view, the_ball().mesh, the_ball().tour);
  EXPECT_GT(figures.shallow.force_n.p95, 0.004);
  EXPECT_LT(figures.shallow.force_n.p95, 0.015);
  EXPECT_LT(figures.all.direction_deg.p95, 1) << "deep hands lean by how the surface bends, which the field says";
  EXPECT_GT(figures.all.direction_deg.p95, 0.5);
  EXPECT_LT(figures.all.proxy_mm.p95, 0.026);
}

TEST(GodObjectRun, AHandThatBeginsInsideFeelsNothingUntilItHasLeft) {
  const field::TriangleTree tree(the_ball().mesh);
  GodObjectRun god_object(the_ball().field.view, tree, {});
  const auto at = [&](double z) { return god_object.step(position_input({Mm{}, Mm{}, to_fixed<Mm>(z)})).output; };
  EXPECT_EQ(at(13).status & (kContact | kHeldInside), std::uint32_t{kHeldInside});
  EXPECT_EQ(at(14).force, Vec3<Newton>{});
  EXPECT_EQ(at(15.5).status & (kContact | kHeldInside), 0U);
  const Output back = at(14);
  EXPECT_EQ(back.status & (kContact | kHeldInside), std::uint32_t{kContact});
  EXPECT_NEAR(to_double(back.proxy.z), kRadius, 0.01);
}

TEST(GodObjectRun, OfADevicesPacketsTheCoreFindsTheHand) {
  TraceHeader header;
  header.settings.weight = Newton::of(0.5);
  motion::DeviceInHand device(header.device);
  std::vector<Input> packets;
  for (const Input& input : the_ball().tour) packets.push_back(device(input));
  const RenderingFigures figures = compare(the_ball().field.view, the_ball().mesh, packets, header);
  EXPECT_GT(figures.all.force_n.count, 1'000U);
  EXPECT_LT(figures.shallow.force_n.p95, 0.03);
  EXPECT_GT(figures.shallow.force_n.p95, 0.002);
}

TEST(GodObjectRun, ARestartForgetsWhereItWas) {
  const field::TriangleTree tree(the_ball().mesh);
  GodObjectRun god_object(the_ball().field.view, tree, {});
  const auto at = [&](double z, std::uint32_t generation) {
    Input input = position_input({Mm{}, Mm{}, to_fixed<Mm>(z)});
    input.field_generation = generation;
    return god_object.step(input).output;
  };
  at(16, 1);
  EXPECT_NE(at(14, 1).status & kContact, 0U);
  EXPECT_EQ(at(14, 2).status & (kContact | kHeldInside), std::uint32_t{kHeldInside}) << "another field";
}

}  // namespace
}  // namespace isotouch::evaluate
