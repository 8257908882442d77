#include "host/evaluate/felt_hands.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <vector>

#include "host/evaluate/recorded_hand.h"
#include "host/field/line_crossings.h"
#include "host/field/parallel.h"
#include "host/to_double.h"
#include "shared/trace.h"
#include "tests/host/evaluate/ball_mesh.h"
#include "tests/host/evaluate/box_mesh.h"

namespace isotouch::evaluate {
namespace {

using Eigen::Vector3d;

using Corners = std::vector<Vector3d>;
using Faces = std::vector<std::array<std::uint32_t, 3>>;

/// profile   in x and z, counter-clockwise seen from -y
cloud::TriangleMesh extruded(const Corners& profile, const Faces& front) {
  cloud::TriangleMesh mesh;
  const auto corners = static_cast<std::uint32_t>(profile.size());
  for (const double y : {0.0, 25.0}) {
    for (const Vector3d& corner : profile) mesh.vertices.emplace_back(corner.x(), y, corner.z());
  }
  for (const auto& [a, b, c] : front) {
    mesh.faces.push_back({a, b, c});
    mesh.faces.push_back({a + corners, c + corners, b + corners});
  }
  for (std::uint32_t i = 0; i < corners; ++i) {
    const std::uint32_t next = (i + 1) % corners;
    mesh.faces.push_back({i, i + corners, next + corners});
    mesh.faces.push_back({i, next + corners, next});
  }
  cloud::require_closed(mesh, "extruded");
  return mesh;
}

/// A block with an L-shaped profile, and a thin wing on it: every kind of motion finds a place.
cloud::TriangleMesh everything() {
  return extruded({{0, 0, 0}, {30, 0, 0}, {30, 0, 10}, {20, 0, 10}, {20, 0, 30}, {18.5, 0, 30}, {18.5, 0, 10}, {0, 0, 10}},
                  {{0, 1, 7}, {1, 3, 6}, {1, 6, 7}, {1, 2, 3}, {3, 4, 6}, {4, 5, 6}});
}

RecordedHand circling(std::size_t ticks) {
  RecordedHand hand{"circle.trace", {}};
  for (std::size_t i = 0; i < ticks; ++i) {
    const double t = static_cast<double>(i) / 1000;
    hand.positions.emplace_back(100 + 8 * std::cos(5 * t), 8 * std::sin(5 * t), 300 + 0.2 * std::sin(60 * t));
  }
  return hand;
}

TEST(FeltHands, EveryKindTouchesTheSurfaceAtTheDepthsThatAreCompared) {
  const auto mesh = everything();
  const field::TriangleTree tree(mesh);
  struct Seen {
    std::size_t ticks = 0, touching = 0, compared = 0;
    double fastest = 0;
  };
  std::map<FeltKind, Seen> seen;
  for (const FeltHand& hand : felt_hands(tree, {circling(5000)}, {})) {
    Seen& of = seen[hand.kind];
    ASSERT_FALSE(hand.ticks.empty());
    EXPECT_FALSE(field::is_inside(tree, to_double(hand.ticks.front().hip))) << "it begins outside";
    for (std::size_t i = 0; i < hand.ticks.size(); ++i) {
      const double depth = (hand.ticks[i].god - to_double(hand.ticks[i].hip)).norm();
      ++of.ticks;
      of.touching += hand.ticks[i].touching ? 1U : 0U;
      of.compared += hand.ticks[i].touching && depth >= 0.1 && depth <= 1 ? 1U : 0U;
      if (i > 0) of.fastest = std::max(of.fastest, (to_double(hand.ticks[i].hip) - to_double(hand.ticks[i - 1].hip)).norm());
      EXPECT_FALSE(field::is_inside(tree, hand.ticks[i].god));
    }
  }
  ASSERT_EQ(seen.size(), kFeltKindNames.size());
  for (const auto& [kind, of] : seen) {
    const std::string name(name_of(kind));
    EXPECT_GT(of.compared, kind == FeltKind::kThin ? 300U : 4000U) << name;
    EXPECT_GT(of.touching, of.ticks / 3) << name;
    EXPECT_LT(of.fastest, 1.001) << name << ": no hand is faster than 1 m/s";
  }
  EXPECT_NEAR(seen[FeltKind::kStab].fastest, 1, 1e-3);
  EXPECT_NEAR(seen[FeltKind::kSlide300].fastest, 0.3, 0.05);
  EXPECT_GT(seen[FeltKind::kRecorded].touching, 4800U) << "a recorded hand touches";
}

TEST(FeltHands, ThoseInCreasesRestThereAndOnBothWalls) {
  const auto mesh = everything();
  const field::TriangleTree tree(mesh);
  std::size_t touching = 0, in_crease = 0, on_floor = 0, on_wall = 0;
  for (const FeltHand& hand : felt_hands(tree, {}, {})) {
    if (hand.kind != FeltKind::kCrease) continue;
    for (const FeltTick& tick : hand.ticks) {
      if (!tick.touching) continue;
      const double to_floor = std::fabs(tick.god.z() - 10);
      const double to_wall = std::min(std::fabs(tick.god.x() - 20), std::fabs(tick.god.x() - 18.5));
      ++touching;
      in_crease += std::max(to_floor, to_wall) < 0.01 ? 1U : 0U;
      on_floor += to_floor < 0.01 && to_wall > 0.05 ? 1U : 0U;
      on_wall += to_wall < 0.01 && to_floor > 0.05 ? 1U : 0U;
    }
  }
  EXPECT_GT(touching, 15'000U);
  EXPECT_GT(in_crease, touching / 2);
  EXPECT_GT(on_floor, touching / 20);
  EXPECT_GT(on_wall, touching / 20);
}

TEST(FeltHands, ThoseInCreasesStayInThinParts) {
  constexpr double kWall = 0.3;         // mm
  constexpr std::size_t kSinking = 30;  // ticks, 3 mm: as far as one sinks
  const auto mesh = extruded({{0, 0, 0}, {20, 0, 0}, {20, 0, kWall}, {kWall, 0, kWall}, {kWall, 0, 20}, {0, 0, 20}},
                             {{0, 1, 3}, {1, 2, 3}, {0, 3, 5}, {3, 4, 5}});
  const field::TriangleTree tree(mesh);
  std::size_t hands = 0;
  for (const FeltHand& hand : felt_hands(tree, {}, {})) {
    if (hand.kind != FeltKind::kCrease) continue;
    ++hands;
    for (std::size_t i = 0; i < kSinking; ++i) ASSERT_LT((hand.ticks[i].god - to_double(hand.ticks[i].hip)).norm(), 1.5 * kWall);
  }
  EXPECT_GT(hands, 10U);
}

TEST(FeltHands, TheSeedDecidesAndThreadsDoNot) {
  const auto mesh = everything();
  const field::TriangleTree tree(mesh);
  const auto hash = [&](std::uint64_t seed, unsigned threads) {
    const field::ThreadLimit limit(threads);
    std::uint64_t sum = 0;
    for (const FeltHand& hand : felt_hands(tree, {circling(2500)}, {.seed = seed, .share = 0.1})) {
      for (const FeltTick& tick : hand.ticks) sum = sum * 31 + static_cast<std::uint32_t>(tick.hip.x.raw() ^ tick.hip.z.raw());
    }
    return sum;
  };
  EXPECT_EQ(hash(1, 1), hash(1, 2));
  EXPECT_NE(hash(1, 1), hash(2, 1));
}

TEST(FeltHands, AnObjectWithoutEdgesHasNoSuchHands) {
  const auto mesh = ball(15, 4);
  const field::TriangleTree tree(mesh);
  for (const FeltHand& hand : felt_hands(tree, {}, {.share = 0.1})) {
    EXPECT_TRUE(hand.kind != FeltKind::kEdge && hand.kind != FeltKind::kCrease && hand.kind != FeltKind::kThin &&
                hand.kind != FeltKind::kRecorded);
  }
}

trace::Trace trace_of(std::uint32_t period_ns, std::size_t ticks) {
  TraceHeader header;
  header.period_ns = period_ns;
  std::vector<TraceRecord> records;
  for (std::size_t i = 0; i < ticks; ++i)
    records.push_back({position_input(to_fixed<Mm>(Vector3d(static_cast<double>(i), 0, 1))), {}, 0, 0});
  return {"some.trace", header, records};
}

TEST(RecordedHand, HasOnePositionAMillisecond) {
  EXPECT_EQ(recorded_hand(trace_of(1'000'000, 5)).positions.size(), 5U);
  const RecordedHand slow = recorded_hand(trace_of(2'000'000, 4));
  ASSERT_EQ(slow.positions.size(), 7U);
  EXPECT_EQ(slow.positions[3], Vector3d(1.5, 0, 1));
  EXPECT_EQ(slow.name, "some.trace");
  const RecordedHand fast = recorded_hand(trace_of(500'000, 5));
  ASSERT_EQ(fast.positions.size(), 3U);
  EXPECT_EQ(fast.positions[2], Vector3d(4, 0, 1));
  EXPECT_THROW(recorded_hand(trace_of(1'000'000, 1)), std::exception);
}

}  // namespace
}  // namespace isotouch::evaluate
