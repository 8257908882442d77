/// A hand on a surface that patches move: what it feels, and that it stays on its side.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <deque>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

#include "firmware/core/lag.h"
#include "firmware/core/moved_surface.h"
#include "firmware/core/render.h"
#include "firmware/core/tick.h"
#include "shared/trace.h"
#include "tests/support/alloc_guard.h"
#include "tests/support/field_image.h"
#include "tests/support/field_patch.h"
#include "tests/support/random.h"

namespace isotouch::core {
namespace {

using test::DistanceFunction;
using test::FieldImage;
using test::Point;

constexpr double kEdge = 0.5, kStiffness = 0.8;
constexpr std::uint32_t kSize = 48;
constexpr double kMostChange = 0.05;

FieldImage field_of(const DistanceFunction& distance) {
  return FieldImage({kSize, kSize, kSize}, distance,
                    {.edge_mm = kEdge,
                     .band = 4.0,
                     .stiffness = kStiffness,
                     .origin_mm = {0, 0, 0},
                     .prefilter = false,
                     .interpolation = Interpolation::kTrilinear});
}

/// A block whose top is at z = height, voxels.
DistanceFunction block(double height) {
  return [height](const Point& at) { return std::max({at.z - height, 6 - at.z, 7 - at.x, at.x - 40, 7 - at.y, at.y - 40}); };
}
DistanceFunction plate(double middle, double half = 1.5) {
  return [=](const Point& at) { return std::max({std::abs(at.z - middle) - half, 7 - at.x, at.x - 40, 7 - at.y, at.y - 40}); };
}
DistanceFunction ball(const Point& centre, double radius) {
  return [=](const Point& at) { return length(at - centre) - radius; };
}
DistanceFunction nothing() {
  return [](const Point&) { return 100.0; };
}

double newton(Newton n) { return n.raw() / 65536.0; }
Point newton(const Vec3<Newton>& f) { return {newton(f.x), newton(f.y), newton(f.z)}; }
Point millimetres(const Vec3<Mm>& p) { return {p.x.raw() / 1048576.0, p.y.raw() / 1048576.0, p.z.raw() / 1048576.0}; }
Mm mm(double v) { return Mm::from_raw(static_cast<std::int32_t>(std::lround(v * 1048576))); }
/// Of a place in voxels.
Vec3<Mm> at_voxel(const Point& p) { return {mm(p.x * kEdge), mm(p.y * kEdge), mm(p.z * kEdge)}; }

/// A hand that is led, place by place.
class Hand {
 public:
  explicit Hand(const FieldImage& field, const TickSettings& settings = {})
      : field_(&field), model_(make_position_model(libnifalcon_model(), settings, 1'000'000, field.view())) {}

  const Output& go_to(const Point& voxel) {
    Input in = position_input(at_voxel(voxel));
    if (moved_) in.requests = kRequestMoved;
    moved_ = false;
    before_ = out_;
    out_ = render_position(in, field_->view(), model_, state_);
    return out_;
  }
  void patch(const FieldImage& field) { field_ = &field, moved_ = true; }
  void lead(Point from, const Point& to, int ticks) {
    for (int t = 1; t <= ticks; ++t) go_to(from + (to - from) * (static_cast<double>(t) / ticks));
  }

  Point force() const { return newton(out_.force); }
  double change() const { return length(newton(out_.force) - newton(before_.force)); }
  bool touches() const { return (out_.status & kContact) != 0; }
  bool is_inside() const { return (out_.status & kHeldInside) != 0; }
  bool lags() const { return (out_.status & kLagging) != 0; }
  Point proxy() const { return millimetres(out_.proxy) * (1 / kEdge); }
  PositionState& state() { return state_; }

 private:
  const FieldImage* field_;
  PositionModel model_;
  PositionState state_;
  Output out_, before_;
  bool moved_ = false;
};

constexpr Point kAbove = {24, 24, 30};

/// On a block of height 20, pressed to `z`, after the hand came from above.
Hand pressed(const FieldImage& field, double z, const TickSettings& settings = {}) {
  Hand hand(field, settings);
  hand.lead(kAbove, {24, 24, z}, 400);
  for (int t = 0; t < 100; ++t) hand.go_to({24, 24, z});
  return hand;
}

double spring(double voxels) { return voxels * kEdge * kStiffness; }

TEST(MovingSurface, OneThatRisesOrSinksUnderARestingHandChangesTheForceGently) {
  for (const double step : {0.05, 0.3, 1.0, 2.0, 2.9, -0.05, -0.3, -1.0, -2.0, -2.9}) {
    std::deque<FieldImage> fields;
    for (int n = 0; n <= 4; ++n) fields.push_back(field_of(block(20 + n * step * 0.5)));
    const double z = 14;
    Hand hand = pressed(fields[0], z);
    ASSERT_NEAR(hand.force().z, spring(6), 0.03);
    double most = 0;
    for (std::size_t n = 2; n <= 4; n += 2) {
      double largest = std::max(hand.force().z, spring(20 + static_cast<double>(n) * step * 0.5 - z));
      hand.patch(fields[n]);
      for (int t = 0; t < 200; ++t) {
        hand.go_to({24, 24, z});
        most = std::max(most, hand.change());
        ASSERT_LE(hand.force().z, largest + 0.03) << step;
        ASSERT_GE(hand.force().z, -1e-3) << step;
      }
      EXPECT_NEAR(hand.force().z, spring(20 + static_cast<double>(n) * step * 0.5 - z), 0.05) << step;
      EXPECT_FALSE(hand.lags()) << step;
      EXPECT_TRUE(hand.touches());
    }
    EXPECT_LE(most, kMostChange) << step;
    EXPECT_GT(most, std::abs(step) >= 0.3 ? 0.9 * kMostChange : 0.0) << step;
  }
}

TEST(MovingSurface, OneThatIsGoneLetsTheForceGoByARamp) {
  const FieldImage before = field_of(block(20)), after = field_of(nothing());
  Hand hand = pressed(before, 14);
  const double given = hand.force().z;
  hand.patch(after);
  double last = given;
  int ticks = 0;
  for (; ticks < 1000; ++ticks) {
    hand.go_to({24, 24, 14});
    ASSERT_LE(hand.change(), kMostChange);
    ASSERT_LE(hand.force().z, last);
    ASSERT_FALSE(hand.touches());
    last = hand.force().z;
    if (last == 0) break;
  }
  EXPECT_NEAR(ticks, given / kMostChange, 3);
  hand.go_to({24, 24, 14});
  EXPECT_FALSE(hand.lags());
}

/// The spring that is gone gives no more than it held.
TEST(MovingSurface, AHandThatGoesWithAForceThatIsLetGoUsesItUp) {
  const FieldImage before = field_of(block(20)), after = field_of(nothing());
  for (const double speed : {0.02, 0.1, 0.5}) {  // voxels a tick
    Hand hand = pressed(before, 14);
    const double held = 0.5 * kStiffness * 9;  // mJ
    hand.patch(after);
    double work = 0, z = 14;
    for (int t = 0; t < 400; ++t) {
      work += hand.force().z * speed * kEdge;
      z += speed;
      hand.go_to({24, 24, z});
    }
    EXPECT_LE(work, held * 1.02 + spring(6) * speed * kEdge) << speed;
    EXPECT_GT(work, 0.01 * held) << speed;
  }
}

TEST(MovingSurface, AHandThatPushesAgainstAForceThatIsLetGoDoesNotMakeItGrow) {
  const FieldImage before = field_of(block(20)), after = field_of(nothing());
  Hand hand = pressed(before, 14);
  hand.patch(after);
  double last = hand.force().z, z = 14;
  for (int t = 0; t < 100; ++t) {
    hand.go_to({24, 24, z -= 0.05});
    ASSERT_LE(hand.force().z, last);
    last = hand.force().z;
  }
}

TEST(MovingSurface, ABodyThatAppearsRoundTheHandGivesNoForceUntilItHasLeft) {
  const FieldImage before = field_of(nothing()), after = field_of(ball({24, 24, 24}, 12));
  Hand hand(before);
  hand.lead({24, 24, 24}, {24, 24, 25}, 20);
  hand.patch(after);
  for (int t = 0; t < 100; ++t) {
    hand.go_to({24, 24, 25 + 0.05 * t});
    ASSERT_EQ(length(hand.force()), 0) << t;
    ASSERT_TRUE(hand.is_inside());
  }
  hand.lead({24, 24, 30}, {24, 24, 38}, 200);
  EXPECT_FALSE(hand.is_inside());
  hand.lead({24, 24, 38}, {24, 24, 34}, 200);
  EXPECT_TRUE(hand.touches());
  EXPECT_NEAR(hand.force().z, spring(2), 0.05);
}

TEST(MovingSurface, ABodyThatAppearsRoundATouchingHandLetsItsForceGo) {
  const FieldImage before = field_of(block(20)), after = field_of(ball({24, 24, 20}, 13));
  Hand hand = pressed(before, 14);
  hand.patch(after);
  for (int t = 0; t < 200; ++t) {
    hand.go_to({24, 24, 14});
    ASSERT_LE(hand.change(), kMostChange);
    ASSERT_TRUE(hand.is_inside());
  }
  EXPECT_EQ(length(hand.force()), 0);
}

/// What a scan's noise does: a free hand just in front of the surface must not fall through it.
TEST(MovingSurface, ASurfaceThatRisesALittleOverAFreeHandIsFelt) {
  for (const double rise : {0.3, 1.0, 2.5}) {
    const FieldImage before = field_of(block(20)), after = field_of(block(20 + rise));
    Hand hand(before);
    hand.lead(kAbove, {24, 24, 20.2}, 400);
    ASSERT_FALSE(hand.touches());
    hand.patch(after);
    hand.go_to({24, 24, 20.2});
    EXPECT_TRUE(hand.touches()) << rise;
    EXPECT_LE(length(hand.force()), kMostChange) << "no blow";
    for (int t = 0; t < 100; ++t) {
      hand.go_to({24, 24, 20.2});
      ASSERT_LE(hand.change(), kMostChange);
    }
    EXPECT_NEAR(hand.force().z, spring(rise - 0.2), 0.05) << rise;
    hand.lead({24, 24, 20.2}, {24, 24, 10}, 400);
    EXPECT_TRUE(hand.touches()) << "it does not let the hand through";
  }
}

TEST(MovingSurface, APlateIsNeverLeftByItsBack) {
  for (const double step : {-2.9, -2.0, -1.0, -0.4, 0.4, 1.0, 2.0, 2.9}) {
    const FieldImage before = field_of(plate(22)), after = field_of(plate(22 + step));
    for (const double z : {23.0, 22.0, 20.0, 15.0}) {  // in the plate, and beyond it
      Hand hand = pressed(before, z);
      ASSERT_TRUE(hand.touches());
      hand.patch(after);
      for (int t = 0; t < 100; ++t) {
        hand.go_to({24, 24, z});
        ASSERT_LE(hand.change(), kMostChange) << step << " " << z;
        ASSERT_GT(hand.proxy().z, std::min(23.5 + step - 0.2, z)) << step << " " << z << " tick " << t;
      }
      EXPECT_TRUE(hand.touches() || z > 23.5 + step - 0.1) << step << " " << z;
    }
  }
}

TEST(MovingSurface, AHandFeelsItsOwnWayAtOnce) {
  const FieldImage before = field_of(block(20)), after = field_of(block(22));
  Hand hand = pressed(before, 14);
  hand.patch(after);
  for (int t = 0; t < 8; ++t) hand.go_to({24, 24, 14});
  const double force = hand.force().z;
  ASSERT_TRUE(hand.lags());
  hand.go_to({24, 24, 14.5});
  EXPECT_NEAR(hand.force().z, force - spring(0.5), kMostChange + 0.01);
}

/// A patch somewhere else is not felt: after it the forces are those that they would have been.
TEST(MovingSurface, APatchElsewhereIsNotFelt) {
  const auto with_lump = [](double x) {
    return field_of([=](const Point& at) { return std::min(block(20)(at), length(at - Point{x, 12, 21}) - 3); });
  };
  const FieldImage before = with_lump(12), after = with_lump(14);
  TickSettings rough;
  rough.friction = Ratio::of(0.4);
  for (const TickSettings& settings : {TickSettings{}, rough}) {
    Hand patched = pressed(before, 16, settings), alone = pressed(before, 16, settings);
    double most = 0;
    for (int t = 0; t < 300; ++t) {
      if (t == 50) patched.patch(after);
      const Point at = {24 + 0.02 * t, 24, 16};
      patched.go_to(at), alone.go_to(at);
      most = std::max(most, length(patched.force() - alone.force()));
    }
    EXPECT_LE(most, 0.01);
    EXPECT_LE(length(patched.force() - alone.force()), 0.01);
  }
}

TEST(MovingSurface, DampersDoNotTakeAPatchForSpeed) {
  const FieldImage before = field_of(block(20)), after = field_of(block(22.5));
  TickSettings damped;
  damped.damping = Damping::of(0.01);
  damped.hand_damping = Damping::of(0.005);
  damped.passivity = Damping::of(0.012);
  damped.friction = Ratio::of(0.5);
  Hand hand = pressed(before, 14, damped);
  hand.patch(after);
  for (int t = 0; t < 300; ++t) {
    hand.go_to({24, 24, 14});
    ASSERT_LE(hand.change(), kMostChange) << t;
  }
}

TEST(MovingSurface, ASphereThatRollsUnderARestingHandChangesTheForceGently) {
  std::deque<FieldImage> fields;
  for (int n = 0; n < 24; ++n) fields.push_back(field_of(ball({18 + 0.5 * n, 24, 20}, 9)));
  Hand hand(fields[0]);
  hand.lead({22, 24, 34}, {22, 24, 26}, 400);
  for (int t = 0; t < 100; ++t) hand.go_to({22, 24, 26});
  ASSERT_TRUE(hand.touches());
  for (std::size_t n = 1; n < fields.size(); ++n) {
    hand.patch(fields[n]);
    for (int t = 0; t < 33; ++t) {
      hand.go_to({22, 24, 26});
      ASSERT_LE(hand.change(), kMostChange) << n;
      ASSERT_LE(length(hand.force()), spring(6)) << n;
    }
  }
}

/// A hand of 0.3 kg that rests against a spring and a damper of an arm, as the surface comes and goes: the work that it is given.
TEST(MovingSurface, TheWorkThatAHandIsGivenIsBounded) {
  for (const double speed : {10.0, 40.0, -10.0, -40.0}) {  // mm/s, by 30 patches a second
    std::deque<FieldImage> fields;
    const double step = speed / 30 / kEdge;
    const int patches = static_cast<int>(10 / std::abs(speed) * 30);
    for (int n = 0; n <= patches; ++n) fields.push_back(field_of(block((speed > 0 ? 14 : 24) + n * step)));
    const double rest = speed > 0 ? 14 * kEdge - 1 : 24 * kEdge - 1;
    Hand hand(fields[0]);
    hand.lead(kAbove, {24, 24, rest / kEdge}, 400);
    const double push = hand.force().z;  // what the arm holds against
    double z = rest, v = 0, work = 0, fastest = 0, most_force = 0;
    std::size_t next = 1;
    for (int t = 0; t < patches * 33 + 300; ++t) {
      if (t % 33 == 0 && next < fields.size()) hand.patch(fields[next++]);
      const double force = hand.force().z;
      v += (force - push - 0.3 * (z - rest) - 0.01 * v) / 0.3;  // mm/ms² per kg: N/kg = 1e-3 mm/ms²
      const double way = v * 1e-3;
      work += force * way;
      z += way;
      fastest = std::max(fastest, std::abs(v));
      most_force = std::max(most_force, force);
      hand.go_to({24, 24, z / kEdge});
    }
    RecordProperty("work_mj_per_cm_at_" + std::to_string(static_cast<int>(speed)), std::to_string(work / std::abs(10.0)));
    std::printf("%+.0f mm/s: %.2f mJ over 10 mm of motion, hand moved %.2f mm, fastest %.1f mm/s, largest force %.2f N\n", speed, work,
                z - rest, fastest, most_force);
    EXPECT_LT(most_force, 8.01);
    EXPECT_LT(std::abs(work), 40);
  }
}

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

/// How tests/golden/positions_patches and field_1_3 were made: into the folder that ISOTOUCH_GOLDEN_OUT names.
TEST(MovingSurface, DISABLED_WritesTheGoldenRecording) {
  const char* folder = std::getenv("ISOTOUCH_GOLDEN_OUT");
  ASSERT_NE(folder, nullptr);
  std::deque<FieldImage> fields;
  for (int n = 0; n <= 14; ++n) {
    const Point centre = {12 + 0.3 * n, 12, 11 + std::sin(0.8 * n)};
    fields.push_back(FieldImage({26, 24, 24},
                                [=](const Point& at) {
                                  return n == 9 ? 100.0 : length(at - centre) - 5 - 0.1 * n;  // once it is gone
                                },
                                {.edge_mm = 1.0,
                                 .band = 2.0,
                                 .stiffness = kStiffness,
                                 .origin_mm = {0, 0, 0},
                                 .prefilter = false,
                                 .interpolation = Interpolation::kTrilinear}));
  }
  const auto write = [&](const std::string& name, const auto& bytes) {
    std::ofstream file(std::string(folder) + "/" + name, std::ios::binary | std::ios::app);
    file.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  };
  TraceHeader header;
  header.field_hash = fields[0].view().hash();
  header.has_outputs = true;
  header.record_count = 1000;
  header.settings.friction = Ratio::of(0.3);
  header.settings.hand_damping = Damping::of(0.001);
  write("field_1_3.itf", fields[0].bytes());
  write("positions_patches.trace", encode(header));
  const PositionModel model = make_position_model(header.device, header.settings, header.period_ns, fields[0].view());
  PositionState state;
  Chain chain(header);
  std::size_t now = 0;
  for (int t = 0; t < 1000; ++t) {
    Input in = position_input({mm(13 + 2 * std::sin(0.011 * t)), mm(12 + std::cos(0.017 * t)), mm(std::max(14.0, 21 - 0.03 * t))});
    if (t % 66 == 65 && now + 1 < fields.size()) {
      write("positions_patches.patches", test::make_patch(fields[now].view(), fields[now + 1].view()));
      ++now;
      in.requests = kRequestMoved;
      in.moved_to = static_cast<std::uint32_t>(fields[now].view().hash());
    }
    in.field_generation = static_cast<std::uint32_t>(now + 1);
    const Output out = render_position(in, fields[now].view(), model, state);
    write("positions_patches.trace", encode(TraceRecord{in, out, chain.extend(in, out), static_cast<std::uint64_t>(t) * 1'000'000}));
  }
}

TEST(MovingSurface, CostsNoAllocation) {
  const FieldImage before = field_of(block(20)), after = field_of(block(21));
  Hand hand = pressed(before, 14);
  const test::AllocGuard guard;
  hand.patch(after);
  for (int t = 0; t < 50; ++t) hand.go_to({24, 24, 14});
  EXPECT_EQ(guard.count(), 0U);
}

}  // namespace
}  // namespace isotouch::core
