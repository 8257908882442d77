/// Random patches under a hand that wanders: nothing strikes it, nothing lets it through.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <deque>
#include <string>
#include <vector>

#include "firmware/core/moved_surface.h"
#include "tests/firmware/core/led_hand.h"
#include "tests/support/random.h"

namespace isotouch::core {
namespace {

/// Fields on one grid, and what each of them is in doubles. Every pair is a patch.
struct Pool {
  std::deque<FieldImage> fields;
  std::vector<DistanceFunction> distances;
  void add(const DistanceFunction& distance) { fields.push_back(field_of(distance)), distances.push_back(distance); }
  std::size_t size() const { return fields.size(); }
};

const Pool& plates() {
  static const Pool pool = [] {
    Pool made;
    for (int n = 0; n < 60; ++n) made.add(plate(16 + 0.25 * n, 2));
    return made;
  }();
  return pool;
}

/// A ball and a block that go up and down and sideways by little from one to the next.
const Pool& bodies() {
  static const Pool pool = [] {
    Pool made;
    for (int n = 0; n < 60; ++n) {
      const Point centre = {24 + 6 * std::sin(0.21 * n), 24 + 6 * std::cos(0.13 * n), 22 + 4 * std::sin(0.37 * n)};
      made.add([=, lower = block(16 + 3 * std::sin(0.29 * n)), upper = ball(centre, 7)](const Point& at) {
        return std::min(lower(at), upper(at));
      });
    }
    return made;
  }();
  return pool;
}

/// The hand wanders; nothing that a patch does may strike it or let it through.
void wander(const Pool& pool, bool are_plates, std::uint64_t seed, std::uint64_t ticks) {
  test::Random random(seed);
  std::size_t now = 24;
  const auto middle = [&] { return 16 + 0.25 * static_cast<double>(now); };  // of a plate
  TickSettings settings;
  if (seed % 2 == 0) settings.friction = Ratio::of(0.4);
  Hand hand(pool.fields[now], settings);
  Point at = {24, 24, 36}, way = {0, 0, 0};
  double side = 0;
  bool may_change_side = true;
  std::uint64_t rests = 0, patches = 0, contacts = 0, inside = 0, releases = 0;
  int rested = 0;
  double most = 0, most_resting = 0, deepest = 0, most_alone = 0;  // alone: no patch is being followed
  for (std::uint64_t t = 0; t < ticks; ++t) {
    if (random.bits() % 50 == 0) {  // another way: often none
      way = random.bits() % 2 == 0 ? Point{} : random.in_ball(0.15);
      if (random.bits() % 4 == 0) way = {0, 0, at.z > (are_plates ? middle() : 20) ? -0.1 : 0.1};
    }
    const Point to = at + way;
    const bool rests_now = length(way) == 0 || to.x < 14 || to.x > 33 || to.y < 14 || to.y > 33 || to.z < 9 || to.z > 39;
    if (!rests_now) at = to;
    if (random.bits() % 25 == 0) {
      const double before = middle();
      const long step = static_cast<long>(random.bits() % (are_plates ? 17 : 5)) - (are_plates ? 8 : 2);
      const bool far = random.bits() % 40 == 0;
      now = far ? static_cast<std::size_t>(random.bits() % pool.size())
                : static_cast<std::size_t>(std::clamp<long>(static_cast<long>(now) + step, 0, 59));
      hand.patch(pool.fields[now]);
      ++patches;
      if (std::abs(middle() - before) > kMostRise) may_change_side = true;  // a body may have appeared round the hand, or passed it
    }
    const double before = length(hand.force());
    hand.go_to(at);
    const double force = length(hand.force()), change = hand.change();
    double& largest = hand.lags() ? most : most_alone;
    largest = std::max(largest, change - spring(rests_now ? 0 : length(way)));
    if (rests_now && hand.lags()) most_resting = std::max(most_resting, change);
    rested = rests_now ? rested + 1 : 0;
    if (rested > 20) most_resting = std::max(most_resting, change);  // a proxy arrives some ticks after a fast hand, patch or not
    if (rests_now) ++rests;
    if (hand.is_inside()) may_change_side = true, ++inside;
    contacts += hand.touches() ? 1U : 0U;
    releases += hand.lags() && !hand.touches() ? 1U : 0U;
    const Point proxy = hand.proxy();
    if (hand.touches()) {
      deepest = std::max(deepest, -pool.distances[now](proxy));
      ASSERT_LE(force, std::max(before, spring(length(proxy - at))) + 0.03) << "tick " << t;
    } else {
      ASSERT_LE(force, before + 1e-4) << "tick " << t;
    }
    if (!are_plates || hand.is_inside()) continue;
    const double new_side = proxy.z > middle() ? 1 : -1;
    ASSERT_TRUE(new_side == side || may_change_side) << "through the plate in tick " << t;
    side = new_side;
    may_change_side = false;
  }
  std::printf(
      "%llu ticks, %llu patches, %llu in contact, %llu inside, %llu released, %llu at rest; largest change %.4f N at rest, %.4f N beyond "
      "the "
      "hand's own way (%.4f N where no patch is followed); proxy at most %.3f voxel deep\n",
      static_cast<unsigned long long>(ticks), static_cast<unsigned long long>(patches), static_cast<unsigned long long>(contacts),
      static_cast<unsigned long long>(inside), static_cast<unsigned long long>(releases), static_cast<unsigned long long>(rests),
      most_resting, most, most_alone, deepest);
  EXPECT_LE(most_resting, kMostChange);
  const bool slides = settings.friction == Ratio{};           // else the proxy is shown where friction holds it
  EXPECT_LE(slides ? deepest : 0, are_plates ? 0.15 : 0.35);  // the doubles have edges that the grid rounds
  EXPECT_GT(contacts, ticks / 20);
  EXPECT_GT(releases, 0U);
}

/// Slopes of any height, and nothing at all.
const Pool& slopes() {
  static const Pool pool = [] {
    Pool made;
    test::Random random(3);
    for (int n = 0; n < 40; ++n) {
      const Point normal = unit(Point{0, 0, 2} + random.in_ball(1));
      const Point through = {24, 24, 20 + 4 * random.in_ball(1).z};
      made.add([=](const Point& at) { return n % 10 == 0 ? 100.0 : std::max(dot(at - through, normal), 6 - at.z); });
    }
    return made;
  }();
  return pool;
}

/// A hand of constant velocity: what it gives itself to a damper does not change, so a patch may change the force by no more than without one.
TEST(MovingSurface, WhatDampersGiveChangesByLittleToo) {
  TickSettings spring_damper, all;
  spring_damper.damping = Damping::of(0.01);
  all.damping = Damping::of(0.005);
  all.hand_damping = Damping::of(0.005);
  all.friction = Ratio::of(0.3);
  const Pool& pool = slopes();
  for (const TickSettings& settings : {spring_damper, all}) {
    test::Random random(17);
    double most = 0, fastest = 0;
    int compared = 0;
    for (int trial = 0; trial < 600; ++trial) {
      Hand hand(pool.fields[1], settings);
      hand.lead({24, 24, 40}, {24, 24, 22}, 200);
      const Point way = random.in_ball(0.2);  // 100 mm/s
      Point at = {24, 24, 18};
      hand.lead({24, 24, 22}, at, 60);
      for (int t = 0; t < 20; ++t) hand.go_to(at = at + way);  // the filters have its speed
      bool touched = hand.touches();
      int since = 100;
      for (int t = 0; t < 25; ++t) {
        if (random.bits() % 8 == 0) hand.patch(pool.fields[static_cast<std::size_t>(random.bits() % pool.size())]), since = 0;
        hand.go_to(at = at + way);
        const bool by_hand = touched != hand.touches() && since > 0;  // it touches, or lets go: there the dampers begin and end
        touched = hand.touches();
        ++since;
        if (by_hand || !hand.lags()) continue;
        ++compared;
        most = std::max(most, hand.change() - spring(length(way)));
        fastest = std::max(fastest, length(way) * kEdge);
      }
    }
    std::printf("%d ticks, up to %.0f mm/s: %.4f N beyond the hand's own way\n", compared, fastest * 1000, most);
    EXPECT_LE(most, kMostChange);
    EXPECT_GT(compared, 5000);
  }
}

TEST(MovingSurface, RandomPatchesNeitherStrikeNorLetThrough) {
  wander(plates(), true, 1, 60'000);
  wander(bodies(), false, 1, 60'000);
  wander(bodies(), false, 8, 60'000);
}
TEST(MovingSurface, DISABLED_AMillionTicksOfRandomPatches) {
  for (std::uint64_t seed = 2; seed < 7; ++seed) {
    wander(plates(), true, seed, 100'000);
    wander(bodies(), false, seed, 100'000);
  }
}

}  // namespace
}  // namespace isotouch::core
