#include "host/evaluate/felt_comparison.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <functional>
#include <optional>

#include "host/encoding/write_image.h"
#include "host/error.h"
#include "host/evaluate/truth_comparison.h"
#include "host/field/make_grid.h"
#include "host/field/parallel.h"
#include "host/field/sample_distance.h"
#include "host/field_file/open_field.h"
#include "tests/host/evaluate/ball_mesh.h"
#include "tests/host/evaluate/box_mesh.h"

namespace isotouch::evaluate {
namespace {

using Eigen::Vector3d;

constexpr double kRadius = 15;
constexpr double kEdge = 0.4;
constexpr double kShare = 0.25;  // of the usual number of hands

using DistanceTo = std::function<double(const Vector3d&)>;

double to_ball(const Vector3d& p) { return p.norm() - kRadius; }

field_file::OpenField field_of(const DistanceTo& distance, double half, Interpolation interpolation = Interpolation::kSpline,
                               double n_per_mm = 0.8) {
  const field::Grid grid = field::make_grid(Vector3d::Constant(-half), Vector3d::Constant(half), kEdge, 7);
  encoding::FieldInfo info;
  info.interpolation = interpolation;
  info.stiffness_n_per_mm = n_per_mm;
  return field_file::open_field(encoding::write_image(field::sample_distance(distance, grid, 3), info), "made");
}

/// A fine ball, and hands on it.
struct Ball {
  cloud::TriangleMesh mesh = ball(kRadius, 6);
  field::TriangleTree tree{mesh};
  std::vector<FeltHand> hands = felt_hands(tree, {}, {.seed = 3, .share = kShare});

  FeltComparison compare(const DistanceTo& distance, Interpolation interpolation = Interpolation::kSpline) const {
    const field_file::OpenField field = field_of(distance, kRadius + 0.5, interpolation);
    return compare_felt(field.view, tree, hands);
  }
};
const Ball& the_ball() {
  static const Ball ball;
  return ball;
}

TEST(FeltComparison, QuantilesAreRanks) {
  std::vector<double> values;
  for (int i = 100; i > 0; --i) values.push_back(i);
  const Quantiles of = quantiles(values);
  EXPECT_EQ(of.count, 100U);
  EXPECT_EQ(of.median, 50);
  EXPECT_EQ(of.p95, 95);
  EXPECT_EQ(of.p99, 99);
  EXPECT_EQ(of.max, 100);
  EXPECT_EQ(quantiles({}).count, 0U);
  EXPECT_EQ(quantiles({7}).median, 7);
}

// The mesh itself is off by half the angle between its faces, 0.6 degrees of 1.2, and the god-object stays on a face a little longer.
TEST(FeltComparison, AnExactBallIsFeltExactly) {
  for (const Interpolation interpolation : {Interpolation::kSpline, Interpolation::kTrilinear}) {
    const FeltFigures all = the_ball().compare(to_ball, interpolation).all;
    EXPECT_GT(all.errors.direction_deg.count, 10'000U);
    EXPECT_LT(all.errors.direction_deg.p95, 0.9);
    EXPECT_GT(all.errors.direction_deg.p95, 0.3);
    EXPECT_LT(all.errors.force_n.p95, 0.012);
    EXPECT_GT(all.errors.force_n.p95, 0.004);
    EXPECT_EQ(all.jumps, 0U);
    EXPECT_EQ(all.wrong_side, 0U);
    EXPECT_EQ(all.force_without_contact, 0U);
    EXPECT_LT(all.contact_differs, all.touching / 200);
  }
}

TEST(FeltComparison, AnExactPlaneIsFeltExactly) {
  const Vector3d middle(0, 0, -3);
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.4, Vector3d(2, 1, 3).normalized()).toRotationMatrix();  // no axis of the grid
  cloud::TriangleMesh mesh = box({-20, -20, -3}, {20, 20, 3});
  for (Vector3d& vertex : mesh.vertices) vertex = turn * vertex + middle;
  const auto to_slab = [&](const Vector3d& p) {
    const Vector3d out = (turn.transpose() * (p - middle)).cwiseAbs() - Vector3d(20, 20, 3);
    return out.cwiseMax(0).norm() + std::min(out.maxCoeff(), 0.0);
  };
  const field::TriangleTree tree(mesh);
  FeltHand hand{FeltKind::kSlide100, 0, {}, {}};
  FeltPath path(tree, turn * Vector3d(-8, -8, 5) + middle);
  SteeredHand steered(tree, path, turn.col(2), turn.col(0) + 0.7 * turn.col(1));
  for (const double depth : {0.15, 0.4, 0.9}) {
    steered.sink(depth);
    for (int tick = 0; tick < 60; ++tick) steered.step(0.1, 0, depth);
  }
  hand.ticks = path.take();
  const FeltFigures all = compare_felt(field_of(to_slab, 34).view, tree, {hand}).all;
  EXPECT_GT(all.errors.direction_deg.count, 170U);
  EXPECT_LT(all.errors.direction_deg.p95, 0.03);
  EXPECT_GT(all.errors.direction_deg.p95, 0.0003) << "the field's numbers are rounded";
  EXPECT_LT(all.errors.force_n.p95, 0.0005);
  EXPECT_GT(all.errors.force_n.p95, 0.000005);
  for (const FeltErrors& range : all.by_depth) EXPECT_GT(range.direction_deg.count, 50U);
  EXPECT_EQ(all.jumps + all.wrong_side + all.force_without_contact + all.equal_answers, 0U);
}

TEST(FeltComparison, AShiftedFieldIsFound) {
  const FeltFigures sound = the_ball().compare(to_ball).all;
  const FeltFigures shifted = the_ball().compare([](const Vector3d& p) { return to_ball(p - Vector3d(0.3, 0, 0)); }).all;
  EXPECT_GT(shifted.errors.force_n.median, 10 * sound.errors.force_n.median);
  EXPECT_GT(shifted.errors.force_n.max, 0.2) << "0.8 N/mm times 0.3 mm";
  EXPECT_LT(shifted.errors.force_n.max, 0.3);
  EXPECT_GT(shifted.contact_differs, 3 * sound.contact_differs);
  EXPECT_GT(shifted.force_without_contact, 20U);
  EXPECT_GT(shifted.wrong_side, 1000U) << "0.3 mm are more than half a voxel";
}

// A ball a millimetre too large, of which and beside which up to 2 mm are felt.
TEST(FeltComparison, NoForceIsTooLarge) {
  constexpr double kTooLarge = 1, kStiff = 100;  // mm, N/mm
  const field_file::OpenField field =
      field_of([](const Vector3d& p) { return to_ball(p) - kTooLarge; }, kRadius + kTooLarge + 0.5, Interpolation::kSpline, kStiff);
  cloud::TriangleMesh mesh = the_ball().mesh;
  for (Vector3d& corner : mesh.vertices) corner *= 1 + kTooLarge / kRadius;
  const field::TriangleTree larger(mesh);
  for (const FeltFigures& all : {compare_felt(field.view, the_ball().tree, the_ball().hands).all,
                                 compare_felt(field.view, larger, the_ball().tree, the_ball().hands).all}) {
    EXPECT_NEAR(all.errors.force_n.median, kTooLarge * kStiff, 3);
    EXPECT_NEAR(all.by_depth[2].force_n.median, kTooLarge * kStiff, 3);
  }
}

TEST(FeltComparison, TurnedNormalsAreFound) {
  const auto rippled = [](const Vector3d& p) {
    return to_ball(p) + 0.03 * std::sin(3 * p.x()) * std::sin(3 * p.y()) * std::sin(3 * p.z());
  };
  const FeltFigures sound = the_ball().compare(to_ball).all;
  const FeltFigures turned = the_ball().compare(rippled).all;
  EXPECT_GT(turned.errors.direction_deg.median, 3 * sound.errors.direction_deg.median);
  EXPECT_GT(turned.errors.direction_deg.p95, 3);
  EXPECT_LT(turned.errors.direction_deg.p95, 10);
  EXPECT_GT(turned.errors.force_n.p95, 4 * sound.errors.force_n.p95);
}

TEST(FeltComparison, GroovesInWhichTheProxyIsCaughtAreJumps) {
  const auto grooved = [](const Vector3d& p) { return to_ball(p) + 0.5 * std::sin(2.5 * p.x()); };
  const FeltFigures all = the_ball().compare(grooved).all;
  EXPECT_GT(all.jumps, 30U);
  EXPECT_GT(all.errors.direction_deg.p95, 20);
}

TEST(FeltComparison, AMissingWallIsFound) {
  const auto open = [](const Vector3d& p) { return std::max(to_ball(p), p.z() - 12); };
  const FeltFigures sound = the_ball().compare(to_ball).all;
  const FeltFigures all = the_ball().compare(open).all;
  EXPECT_GT(all.contact_differs, 10 * sound.contact_differs + 500);
  EXPECT_GT(all.wrong_side, 500U);
}

TEST(FeltComparison, APlateThroughWhichTheProxyFallsIsTheWrongSide) {
  const auto mesh = box({-15, -15, -0.5}, {15, 15, 0.5});
  const field::TriangleTree tree(mesh);
  std::vector<FeltHand> hands;
  for (const double x : {8.0, 0.0}) {
    FeltPath path(tree, {x, 0, 3});
    path.move({x, 0, -1.5}, 0.1);
    path.hold(50);
    EXPECT_TRUE(path.touching());
    hands.push_back({FeltKind::kThin, hands.size(), {}, path.take()});
  }
  const auto plate = [](const Vector3d& p) {
    const Vector3d out = p.cwiseAbs() - Vector3d(15, 15, 0.5);
    return out.cwiseMax(0).norm() + std::min(out.maxCoeff(), 0.0);
  };
  EXPECT_EQ(compare_felt(field_of(plate, 15).view, tree, hands).all.wrong_side, 0U);
  const auto holed = [&](const Vector3d& p) { return std::max(plate(p), 4 - std::hypot(p.x(), p.y())); };
  const FeltFigures all = compare_felt(field_of(holed, 15).view, tree, hands).all;
  EXPECT_GT(all.wrong_side, 50U);
  EXPECT_GT(all.contact_differs, 50U);
}

TEST(FeltComparison, RoundedEdgesAreMeasuredAsEdges) {
  const auto mesh = box({-10, -10, -10}, {10, 10, 10});
  const field::TriangleTree tree(mesh);
  const std::vector<FeltHand> hands = felt_hands(tree, {}, {.seed = 3, .share = kShare});
  const auto cube = [](const Vector3d& p) {
    const Vector3d out = p.cwiseAbs() - Vector3d::Constant(10);
    return out.cwiseMax(0).norm() + std::min(out.maxCoeff(), 0.0);
  };
  const FeltComparison felt = compare_felt(field_of(cube, 10).view, tree, hands);
  std::optional<FeltFigures> edge, slide;
  for (const auto& [kind, figures] : felt.kinds) {
    if (kind == FeltKind::kEdge) edge = figures;
    if (kind == FeltKind::kSlide100) slide = figures;
    EXPECT_NE(kind, FeltKind::kCrease) << "a cube has none";
    EXPECT_NE(kind, FeltKind::kThin) << "a cube is not thin";
  }
  ASSERT_TRUE(edge && slide);
  EXPECT_GT(edge->errors.direction_deg.count, 1000U);
  EXPECT_GT(edge->errors.direction_deg.p95, slide->errors.direction_deg.p95);
  EXPECT_GT(edge->equal_answers, 0U);
  EXPECT_LT(slide->errors.direction_deg.median, 0.01);
  EXPECT_EQ(felt.all.wrong_side, 0U);
}

// Proxy and god-object are on perpendicular faces there, and the product of their normals is 0 but for rounding.
TEST(FeltComparison, TheEdgesOfATurnedCubeHaveNoWrongSideEither) {
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.7, Vector3d(1, 3, 2).normalized()).toRotationMatrix();
  cloud::TriangleMesh mesh = box({-10, -10, -10}, {10, 10, 10});
  for (Vector3d& vertex : mesh.vertices) vertex = turn * vertex;
  const field::TriangleTree tree(mesh);
  const auto cube = [&](const Vector3d& p) {
    const Vector3d out = (turn.transpose() * p).cwiseAbs() - Vector3d::Constant(10);
    return out.cwiseMax(0).norm() + std::min(out.maxCoeff(), 0.0);
  };
  const FeltFigures all = compare_felt(field_of(cube, 18).view, tree, felt_hands(tree, {}, {.seed = 3, .share = kShare})).all;
  EXPECT_GT(all.equal_answers, 0U);
  EXPECT_EQ(all.wrong_side, 0U);
}

TEST(FeltComparison, AChamferIsNoAnswerWhereTwoSidesAreEquallyNear) {
  constexpr std::size_t kRest = 50;  // ticks
  const auto mesh = box({-10, -10, -10}, {10, 10, 10});
  const field::TriangleTree tree(mesh);
  FeltPath path(tree, {9.65, 0, 11});
  // Where the chamfer leaves nothing to touch; where it is what the field has; and where only the god-object's side and the chamfer are near.
  for (const Vector3d& place : {Vector3d(9.65, 0, 9.65), Vector3d(9.2, 0, 9.2), Vector3d(8.9, 0, 9.2)}) {
    path.move(place, 0.1);
    path.hold(static_cast<int>(kRest));
  }
  ASSERT_NEAR(path.god().z(), 10, 1e-6);
  const auto chamfered = [](const Vector3d& p) {
    const Vector3d out = p.cwiseAbs();
    return std::max(out.maxCoeff() - 10, (out.x() + out.z() - 19) / std::sqrt(2));
  };
  const FeltFigures all = compare_felt(field_of(chamfered, 10).view, tree, {{FeltKind::kEdge, 0, {}, path.take()}}).all;
  EXPECT_GT(all.contact_differs, kRest);
  EXPECT_GT(all.errors.direction_deg.count, 2 * kRest);
  EXPECT_NEAR(all.errors.direction_deg.median, 45, 1);
  EXPECT_EQ(all.equal_answers, 0U);
}

// So soft that the forces round to none.
TEST(FeltComparison, NoForceIsNoAnswerWhereTwoSidesAreEquallyNear) {
  constexpr double kSoft = 2e-5;  // N/mm
  const auto mesh = box({-10, -10, -10}, {10, 10, 10});
  const field::TriangleTree tree(mesh);
  FeltPath path(tree, {9.65, 0, 11});
  path.move({9.65, 0, 9.65}, 0.1);
  path.hold(50);
  const auto cube = [](const Vector3d& p) {
    const Vector3d out = p.cwiseAbs() - Vector3d::Constant(10);
    return out.cwiseMax(0).norm() + std::min(out.maxCoeff(), 0.0);
  };
  const field_file::OpenField field = field_of(cube, 10, Interpolation::kSpline, kSoft);
  const FeltFigures all = compare_felt(field.view, tree, {{FeltKind::kEdge, 0, {}, path.take()}}).all;
  EXPECT_GT(all.errors.direction_deg.count, 50U);
  EXPECT_EQ(all.errors.direction_deg.median, 180);
  EXPECT_EQ(all.equal_answers, 0U);
}

TEST(FeltComparison, CubesThatMakeUpACubeFeelAsIt) {
  cloud::TriangleMesh cubes;
  for (int n = 0; n < 27; ++n) {
    const Vector3d low(6 * (n % 3) - 9, 6 * (n / 3 % 3) - 9, 6 * (n / 9) - 9);
    const auto first = static_cast<std::uint32_t>(cubes.vertices.size());
    const auto one = box(low, low + Vector3d(6, 6, 6));
    cubes.vertices.insert(cubes.vertices.end(), one.vertices.begin(), one.vertices.end());
    for (const auto& [a, b, c] : one.faces) cubes.faces.push_back({first + a, first + b, first + c});
  }
  const auto whole = box({-9, -9, -9}, {9, 9, 9});
  const auto cube = [](const Vector3d& p) {
    const Vector3d out = p.cwiseAbs() - Vector3d::Constant(9);
    return out.cwiseMax(0).norm() + std::min(out.maxCoeff(), 0.0);
  };
  const field_file::OpenField field = field_of(cube, 10);
  const auto felt_of = [&](const cloud::TriangleMesh& mesh) {
    const TrueSurface truth = true_surface(mesh);
    const field::TriangleTree outer(truth.outer), closed(truth.closed);
    const TrueTrees trees(outer, closed);
    return compare_felt(field.view, trees, felt_hands(trees, {}, {.seed = 3, .share = kShare}));
  };
  const FeltComparison one = felt_of(whole), many = felt_of(cubes);
  EXPECT_EQ(many.kinds.size(), one.kinds.size()) << "no crease where cubes meet";
  EXPECT_NEAR(many.all.errors.direction_deg.p95, one.all.errors.direction_deg.p95, 0.2 * one.all.errors.direction_deg.p95);
  EXPECT_NEAR(static_cast<double>(many.all.touching), static_cast<double>(one.all.touching), 0.05 * static_cast<double>(one.all.touching));
}

TEST(FeltComparison, AnyNumberOfThreadsGivesTheSame) {
  std::vector<FeltComparison> of;
  for (const unsigned threads : {1U, 2U, 7U}) {
    const field::ThreadLimit limit(threads);
    const std::vector<FeltHand> hands = felt_hands(the_ball().tree, {}, {.seed = 9, .share = 0.1});
    of.push_back(compare_felt(field_of(to_ball, kRadius + 0.5).view, the_ball().tree, hands));
  }
  for (const FeltComparison& other : of) {
    ASSERT_EQ(other.kinds.size(), of[0].kinds.size());
    for (std::size_t k = 0; k < other.kinds.size(); ++k) {
      const FeltFigures &a = of[0].kinds[k].figures, &b = other.kinds[k].figures;
      EXPECT_EQ(a.errors.direction_deg.p95, b.errors.direction_deg.p95);
      EXPECT_EQ(a.errors.direction_deg.max, b.errors.direction_deg.max);
      EXPECT_EQ(a.errors.force_n.p99, b.errors.force_n.p99);
      EXPECT_EQ(a.ticks, b.ticks);
      EXPECT_EQ(a.contact_differs, b.contact_differs);
    }
    EXPECT_EQ(other.worst_force.force_n, of[0].worst_force.force_n);
    EXPECT_EQ(other.worst_force.hip, of[0].worst_force.hip);
  }
}

/// The ball with its corners elsewhere.
template <class Move>
FeltFigures beside_ball(const Move& move) {
  cloud::TriangleMesh mesh = the_ball().mesh;
  for (Vector3d& corner : mesh.vertices) corner = move(corner);
  const field_file::OpenField field = field_of(to_ball, kRadius + 0.5);
  return compare_felt(field.view, field::TriangleTree(mesh), the_ball().tree, the_ball().hands).all;
}

TEST(FeltComparison, AGodObjectOnTheSameMeshFeelsTheSame) {
  const FeltFigures all = beside_ball([](const Vector3d& corner) { return corner; });
  EXPECT_GT(all.errors.direction_deg.count, 10'000U);
  EXPECT_LT(all.errors.direction_deg.max, 0.05) << "forces are rounded";
  EXPECT_LT(all.errors.force_n.max, 1e-4);
  EXPECT_EQ(all.contact_differs + all.jumps + all.wrong_side + all.force_without_contact, 0U);
}

TEST(FeltComparison, AGodObjectOnAShiftedMeshFeelsTheShift) {
  const FeltFigures all = beside_ball([](const Vector3d& corner) { return Vector3d(corner + Vector3d(0.3, 0, 0)); });
  EXPECT_GT(all.errors.force_n.max, 0.2) << "0.8 N/mm times 0.3 mm";
  EXPECT_LT(all.errors.force_n.max, 0.3);
  EXPECT_GT(all.contact_differs, 500U);
  EXPECT_GT(all.force_without_contact, 20U);
  EXPECT_GT(all.wrong_side, 1000U) << "0.3 mm are more than half a voxel";
}

// Every hand begins inside the larger ball and never leaves it.
TEST(FeltComparison, AHandThatBeginsInsideTheOtherMeshFeelsNothing) {
  EXPECT_THROW(beside_ball([](const Vector3d& corner) { return Vector3d(2 * corner); }), InputError);
}

TEST(FeltComparison, AFieldThatNobodyTouchesIsRefused) {
  const auto far = [](const Vector3d& p) { return (p - Vector3d::Constant(60)).norm() - 5; };
  const field_file::OpenField field = field_of(far, 70);
  EXPECT_THROW(compare_felt(field.view, the_ball().tree, the_ball().hands), InputError);
  EXPECT_THROW(compare_felt(field.view, the_ball().tree, {}), InputError);
}

}  // namespace
}  // namespace isotouch::evaluate
