#include "firmware/core/spring_energy.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "firmware/core/render.h"
#include "tests/support/field_image.h"
#include "tests/support/reference.h"

namespace isotouch::core {
namespace {

using test::FieldImage;
using test::Point;
using test::Random;

constexpr double kEdge = 0.5;  // mm
constexpr Point kOrigin = {-20, -20, -20};
constexpr Point kMiddle = {40.2, 39.8, 40.3};  // of the body, index coordinates
constexpr int kSoft = 85, kHard = 255;         // 0.4 and 1.2 N/mm

/// A block with rounded edges, 24 x 24 x 12 mm.
double block(const Point& p) {
  const Point q = {std::abs(p.x - kMiddle.x) - 20, std::abs(p.y - kMiddle.y) - 20, std::abs(p.z - kMiddle.z) - 8};
  const Point outside = {std::max(q.x, 0.0), std::max(q.y, 0.0), std::max(q.z, 0.0)};
  return test::length(outside) + std::min(std::max({q.x, q.y, q.z}), 0.0) - 4;
}
double ball(const Point& p) { return test::length(p - kMiddle) - 24; }

using Map = int (*)(const Point&);
int soft(const Point&) { return kSoft; }
int hard(const Point&) { return kHard; }
int step_at_the_middle(const Point& p) { return p.x < kMiddle.x ? kSoft : kHard; }
int gentle(const Point& p) { return kSoft + static_cast<int>(std::clamp((p.x - kMiddle.x + 12) / 24, 0.0, 1.0) * (kHard - kSoft)); }
int checkered(const Point& p) { return (static_cast<int>((p.x + 1) / 4) + static_cast<int>((p.y + 1) / 4)) % 2 == 0 ? kSoft : kHard; }

int wild(const Point& p) {  // any value beside any other
  const auto cell = [](double v) { return static_cast<std::uint64_t>(static_cast<std::int64_t>(std::lround((v - 1.5) / 4))); };
  return 1 + static_cast<int>((cell(p.x) * 2654435761U + cell(p.y) * 40503U + cell(p.z) * 2246822519U) % 4294967291U % 255);
}

FieldImage field(test::DistanceFunction shape, Map map) {
  return FieldImage({81, 81, 81}, std::move(shape), {.edge_mm = kEdge, .stiffness = 1.2, .origin_mm = kOrigin, .stiffness_part = map});
}

Mm mm(double v) { return Mm::from_raw(static_cast<std::int32_t>(std::lround(v * (1 << 20)))); }
Point newton(const Vec3<Newton>& f) { return Point{1.0 * f.x.raw(), 1.0 * f.y.raw(), 1.0 * f.z.raw()} * (1.0 / 65536); }

const std::array<std::pair<const char*, Map>, 4> kMaps = {
    {{"step", step_at_the_middle}, {"gentle", gentle}, {"checkered", checkered}, {"wild", wild}}};

struct Body {
  const char* name;
  test::DistanceFunction shape;
  /// x, y and height above the surface, in voxels from the middle → index coordinates
  Point (*above)(double x, double y, double height);
};
Point above_block(double x, double y, double height) { return kMiddle + Point{x, y, 12 + height}; }
Point above_ball(double x, double y, double height) {
  return kMiddle + test::unit(Point{x, y, std::sqrt(24.0 * 24 - x * x - y * y)}) * (24 + height);
}
const std::array<Body, 2> kBodies = {{{"block", block, above_block}, {"ball", ball, above_ball}}};

/// A hand on a field, in index coordinates.
class Hand {
 public:
  Hand(const FieldImage& image, double friction) : image_(image) {
    TickSettings settings;
    settings.friction = Ratio::from_raw(static_cast<std::int32_t>(friction * (1 << 30)));
    settings.ramp_ticks = 0;
    settings.force_limit = Newton::of(50);
    model_ = make_position_model(libnifalcon_model(), settings, 1'000'000, image.view());
  }
  /// the force in newton
  Point feel(const Point& index) {
    const Point hip = index * kEdge + kOrigin;
    out_ = render_position(position_input({mm(hip.x), mm(hip.y), mm(hip.z)}), image_.view(), model_, state_);
    return newton(out_.force);
  }
  /// index coordinates
  Point proxy() const {
    return (Point{1.0 * out_.proxy.x.raw(), 1.0 * out_.proxy.y.raw(), 1.0 * out_.proxy.z.raw()} * (1.0 / (1 << 20)) - kOrigin) *
           (1 / kEdge);
  }

 private:
  const FieldImage& image_;
  PositionModel model_;
  PositionState state_;
  Output out_;
};

/// The way of a hand that ends where it began: down where it is soft, along, up where it is hard, and back in the air.
std::vector<Point> cycle(const Body& body, double depth_mm, double mm_per_s, Random& random) {
  const double depth = depth_mm / kEdge, from = random.uniform(-11, -6), to = random.uniform(6, 11), y = random.uniform(-6, 6);
  std::vector<Point> way;
  const auto go = [&](double x0, double h0, double x1, double h1) {
    const double length = std::hypot(x1 - x0, h1 - h0) * kEdge;
    const int ticks = std::max(1, static_cast<int>(length / mm_per_s * 1000));
    for (int i = 0; i < ticks; ++i) way.push_back(body.above(x0 + (x1 - x0) * i / ticks, y, h0 + (h1 - h0) * i / ticks));
  };
  go(from, 2, from, -depth);
  go(from, -depth, to, -depth);
  go(to, -depth, to, 2);
  go(to, 2, from, 2);
  return way;
}

struct Depths {
  double least, most;  ///< mm
};

/// The work of the forces on the hand over many cycles, in millijoule a cycle; a force acts in the tick after its own, and `delay` ticks later.
double work_a_cycle(const Body& body, Map map, double friction, std::size_t delay, const Depths& depths, int cycles) {
  const FieldImage image = field(body.shape, map);
  Random random(71);
  double work = 0;
  for (int n = 0; n < cycles; ++n) {
    const std::vector<Point> way = cycle(body, random.uniform(depths.least, depths.most), random.uniform(10, 150), random);
    Hand hand(image, friction);
    std::vector<Point> forces;
    for (const Point& hip : way) forces.push_back(hand.feel(hip));
    for (std::size_t i = delay; i + 1 < way.size(); ++i) work += test::dot(forces[i - delay], (way[i + 1] - way[i]) * kEdge);
  }
  return work / cycles;
}

constexpr Depths kShallow = {0.5, 2}, kDeep = {3, 5};
constexpr int kCycles = 40;

/// What sampling and delay give without a map: the more of that of the softest and of the hardest.
double work_of_one_stiffness(const Body& body, double friction, std::size_t delay, const Depths& depths) {
  return std::max(work_a_cycle(body, soft, friction, delay, depths, kCycles), work_a_cycle(body, hard, friction, delay, depths, kCycles));
}

TEST(SpringEnergyHeavy, AMapOfStiffnessGivesNoMoreThanOneStiffness) {
  for (const Body& body : kBodies) {
    for (const double friction : {0.0, 0.3}) {
      for (const std::size_t delay : {0U, 1U, 2U, 3U}) {
        const double base = work_of_one_stiffness(body, friction, delay, kShallow);
        for (const auto& [name, map] : kMaps) {
          const double work = work_a_cycle(body, map, friction, delay, kShallow, kCycles);
          EXPECT_LE(work, base + 0.05) << body.name << ' ' << name << " friction " << friction << " delay " << delay;
        }
      }
    }
  }
}

TEST(SpringEnergy, NorDoesOneThatIsPressedDeep) {
  for (const Body& body : kBodies) {
    const double base = work_of_one_stiffness(body, 0, 0, kDeep);
    for (const auto& [name, map] : kMaps) EXPECT_LE(work_a_cycle(body, map, 0, 0, kDeep, kCycles), base + 0.05) << body.name << ' ' << name;
  }
}

TEST(SpringEnergy, WhoSlidesToWhereItIsHarderGoesUphill) {
  const FieldImage image = field(block, gentle);
  for (const double depth_mm : {0.5, 1.0, 2.0}) {
    Hand hand(image, 0);
    Point force;
    for (double height = 1; height > -depth_mm / kEdge; height -= 0.02) force = hand.feel(above_block(0, 0, height));
    for (int i = 0; i < 50; ++i) force = hand.feel(above_block(0, 0, -depth_mm / kEdge));
    const double slope = 0.8 / (24 * kEdge);  // N/mm a millimetre
    EXPECT_NEAR(force.x, -0.5 * depth_mm * depth_mm * slope, 0.03 * depth_mm * depth_mm * slope) << depth_mm;
    EXPECT_NEAR(force.y, 0, 0.002);
  }
}

TEST(SpringEnergy, AHandAtRestFeelsNoSwing) {
  Random random(72);
  for (const auto& [name, map] : kMaps) {
    const FieldImage image = field(block, map);
    double worst = 0;
    for (int n = 0; n < 30; ++n) {
      const double x = random.uniform(-10, 10), y = random.uniform(-10, 10), depth = random.uniform(0.5, 4) / kEdge;
      Hand hand(image, 0);
      for (double height = 1; height > -depth; height -= 0.1) hand.feel(above_block(x, y, height));
      for (int i = 0; i < 150; ++i) hand.feel(above_block(x, y, -depth));
      const Point rest = hand.proxy();
      for (int i = 0; i < 50; ++i) {
        hand.feel(above_block(x, y, -depth));
        worst = std::max(worst, test::length(hand.proxy() - rest));
      }
    }
    EXPECT_LT(worst, 0.005) << name;
  }
}

TEST(SpringEnergy, StrokingWearsTheStiffnessNotAway) {
  const FieldImage image = field(block, gentle);
  Hand hand(image, 0);
  Random random(73);
  constexpr double kDepth = 3;  // voxels
  for (double height = 1; height > -kDepth; height -= 0.1) hand.feel(above_block(-10, 0, height));
  Point hip, force;
  for (int i = 0; i < 40'000; ++i) {
    hip = above_block(10 * std::sin(i * 0.01), 0, -kDepth) + random.in_box(0.05);
    force = hand.feel(hip);
  }
  for (int i = 0; i < 300; ++i) force = hand.feel(hip = above_block(10, 0, -kDepth));
  const double part = test::reference_stiffness(image.view(), hand.proxy()).part;
  EXPECT_GT(part, 0.85);
  EXPECT_NEAR(test::length(force), 1.2 * part * test::length(hand.proxy() - hip) * kEdge, 0.02 * test::length(force));
}

}  // namespace
}  // namespace isotouch::core
