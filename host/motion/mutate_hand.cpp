#include "host/motion/mutate_hand.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "host/cloud/random.h"
#include "host/error.h"
#include "host/motion/felt_surface.h"
#include "host/motion/resample.h"
#include "host/to_double.h"

namespace isotouch::motion {

using Eigen::Vector3d;

namespace {

constexpr double kFastestHand = 1000;  // mm/s
constexpr double kBeyondReach = 2500;  // mm/s, on the way to ±512 mm
constexpr double kPressSpeed = 25;     // mm/s
constexpr double kCrossing = 100;      // mm/s
constexpr double kCount = 0.046;       // mm, the largest of either published set within 50 mm of the workspace's middle
constexpr double kNear = 6;            // voxels from the surface: a touch
constexpr std::size_t kPlaces = 12;
constexpr std::size_t kLeavings = 6;

/// A tick whose hand is near the surface.
struct Touch {
  std::size_t tick;
  SurfacePoint at;
  double rank;  // the lower the more wanted
};

/// A hand, an object, and what is drawn.
struct HandMutator {
  HandMutator(const std::vector<Input>& recorded, const FieldView& field, const MutationOptions& options, Hand::Emit emit)
      : ticks(recorded),
        surface(field),
        random(options.seed),
        period_ns(options.period_ns),
        hand({0, options.period_ns * 1e-9, options.kind == "jitter" ? 0.03 : 0.0, ~options.seed}, std::move(emit)) {}

  const std::vector<Input>& ticks;
  FeltSurface surface;
  cloud::Random random;
  std::uint32_t period_ns;
  Hand hand;

  /// Within ±1 on each axis; each draw is a statement of its own.
  Vector3d draw() {
    Vector3d v;
    for (double& coordinate : v) coordinate = random.uniform(-1, 1);
    return v;
  }

  std::optional<SurfacePoint> near_surface(const Vector3d& position) const {
    const auto foot = surface.project(position);
    return foot && (foot->position - position).norm() < kNear * surface.voxel_mm() ? foot : std::nullopt;
  }

  /// Up to `most` touches by rising rank, six voxels from each other, in the order of their ticks.
  template <class Rank>
  std::vector<Touch> touches(std::size_t most, Rank rank) {
    std::vector<Touch> all;
    for (std::size_t tick = 0; tick < ticks.size(); ++tick) {
      if (const auto foot = near_surface(to_double(ticks[tick].hip))) all.push_back({tick, *foot, rank(*foot)});
    }
    if (all.empty())
      throw InputError("the hand never comes near the object's surface; move or scale the motion so that it touches, or take another");
    std::stable_sort(all.begin(), all.end(), [](const Touch& a, const Touch& b) { return a.rank < b.rank; });
    std::vector<Touch> chosen;
    for (const Touch& touch : all) {
      const bool apart = std::all_of(chosen.begin(), chosen.end(),
                                     [&](const Touch& c) { return (c.at.position - touch.at.position).norm() > 6 * surface.voxel_mm(); });
      if (apart && chosen.size() < most) chosen.push_back(touch);
    }
    std::sort(chosen.begin(), chosen.end(), [](const Touch& a, const Touch& b) { return a.tick < b.tick; });
    return chosen;
  }

  /// The hand as it was, with a detour at each of the touches, from which it comes back.
  template <class Detour>
  void with_detours(const std::vector<Touch>& places, Detour detour) {
    auto next = places.begin();
    for (std::size_t tick = 0; tick < ticks.size(); ++tick) {
      hand.step(to_double(ticks[tick].hip));
      if (next == places.end() || next->tick != tick) continue;
      const Vector3d from = hand.position();
      detour(next->at, from);
      hand.move(from, kCrossing);
      ++next;
    }
  }
};

void fast(HandMutator& m) {
  std::vector<TimedPoint> points;
  double fastest = 0, fastest_touch = 0;
  for (std::size_t tick = 0; tick < m.ticks.size(); ++tick) {
    if (!m.ticks[tick].fresh) continue;
    const TimedPoint point{static_cast<double>(tick) * m.period_ns * 1e-9, to_double(m.ticks[tick].hip)};
    if (!points.empty()) {
      const double speed = (point.position - points.back().position).norm() / (point.time - points.back().time);
      fastest = std::max(fastest, speed);
      if (m.near_surface(point.position)) fastest_touch = std::max(fastest_touch, speed);
    }
    points.push_back(point);
  }
  if (!(fastest > 0)) throw InputError("the hand does not move; there is nothing to speed up");
  const double scale = (fastest_touch > 0 ? fastest_touch : fastest) / kFastestHand;
  std::vector<TimedPoint> sped{points.front()};
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double seconds = scale * (points[i].time - points[i - 1].time);
    const double least = (points[i].position - points[i - 1].position).norm() / kFastestHand;
    sped.push_back({sped.back().time + std::max(seconds, least), points[i].position});
  }
  resample(sped, m.period_ns, [&](const Input& input, const auto&) { m.hand.step(to_double(input.hip)); });
}

void mirror(HandMutator& m) {
  const auto axis = static_cast<Eigen::Index>(m.random.bits() % 3);
  for (const Input& tick : m.ticks) {
    Vector3d position = to_double(tick.hip);
    position[axis] = 2 * m.surface.centre()[axis] - position[axis];
    m.hand.step(position);
  }
}

void jitter(HandMutator& m) {
  for (const Input& tick : m.ticks) m.hand.step(to_double(tick.hip) + kCount * m.draw());
}

void dwell(HandMutator& m) {
  const double voxel = m.surface.voxel_mm();
  const auto bent_most = [&](const SurfacePoint& at) { return -m.surface.sample(at.position).curvature; };
  m.with_detours(m.touches(kPlaces, bent_most), [&](const SurfacePoint& at, const Vector3d&) {
    const Vector3d inner = at.position - m.random.uniform(1, 5) * voxel * at.normal;
    m.hand.move(inner, kPressSpeed);
    for (int tick = 0; tick < 200; ++tick) {  // each count is one of two neighbours
      Vector3d flicker;
      for (double& coordinate : flicker) coordinate = kCount * static_cast<double>(m.random.bits() & 1);
      m.hand.step(inner + flicker);
    }
    for (int i = 0; i < 4; ++i) m.hand.move(inner + 2 * voxel * m.draw(), kPressSpeed);
  });
}

void medial(HandMutator& m) {
  const double voxel = m.surface.voxel_mm();
  const double across = 2 * m.surface.radius();
  const auto thickness = [&](const SurfacePoint& at) {
    return 0.5 * voxel + m.surface.way_out(at.position - 0.5 * voxel * at.normal, -at.normal, across);
  };
  m.with_detours(m.touches(kPlaces, thickness), [&](const SurfacePoint& at, const Vector3d&) {
    const Vector3d middle = at.position - thickness(at) / 2 * at.normal;
    for (int i = 0; i < 4; ++i) {
      m.hand.move(middle - 2 * voxel * at.normal, kCrossing);
      m.hand.move(middle + 2 * voxel * at.normal, kCrossing);
    }
    for (int i = 0; i < 4; ++i) {
      const Vector3d drawn = 4 * voxel * m.draw();
      m.hand.move(middle + drawn - drawn.dot(at.normal) * at.normal, kCrossing);
    }
  });
}

void graze(HandMutator& m) {
  const double voxel = m.surface.voxel_mm();
  const double reach = kFastestHand * m.hand.period_s();
  bool grazed = false;
  double seconds = 0;
  for (const Input& tick : m.ticks) {
    Vector3d wanted = to_double(tick.hip);
    if (const auto foot = m.near_surface(wanted)) {
      wanted = foot->position + 0.1 * voxel * wave(10 * seconds) * foot->normal;
      grazed = true;
    }
    const Vector3d way = wanted - m.hand.position();
    const bool too_far = m.hand.emitted() > 0 && way.norm() > reach;  // at an edge the nearest place leaps
    m.hand.step(too_far ? Vector3d(m.hand.position() + reach * way.normalized()) : wanted);
    seconds += m.hand.period_s();
  }
  if (!grazed) throw InputError("the hand never comes near the object's surface; move or scale the motion so that it touches");
}

/// How far from a place in a direction a coordinate exceeds ±512 mm; at least 700 mm.
double way_beyond_reach(const Vector3d& from, const Vector3d& way) {
  constexpr double kLeast = 700, kBeyond = 530;
  double shortest = std::numeric_limits<double>::infinity();
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    if (way[axis] != 0) shortest = std::min(shortest, (std::copysign(kBeyond, way[axis]) - from[axis]) / way[axis]);
  }
  return std::max(kLeast, shortest);
}

void leave(HandMutator& m) {
  const double beyond = 2.2 * m.surface.radius();
  int leaving = 0;
  const auto any = [&](const SurfacePoint&) { return m.random.uniform(); };
  m.with_detours(m.touches(kLeavings, any), [&](const SurfacePoint& at, const Vector3d& from) {
    m.hand.move(at.position - 2 * m.surface.voxel_mm() * at.normal, kPressSpeed);
    const Vector3d drawn = m.draw();
    const Vector3d way = drawn.norm() > 0.1 ? Vector3d(drawn.normalized()) : at.normal;
    const Vector3d outside = at.position + beyond * way;
    m.hand.move(outside, kFastestHand);
    if (leaving++ % 2 == 0) {
      m.hand.move(outside + way_beyond_reach(outside, way) * way, kBeyondReach);
      m.hand.hold(0.02);
      m.hand.move(outside, kBeyondReach);
    }
    m.hand.move(from, kFastestHand);
  });
}

struct Kind {
  const char* name;
  void (*mine)(HandMutator&);
};
constexpr Kind kKinds[] = {{"fast", fast},     {"mirror", mirror}, {"jitter", jitter}, {"dwell", dwell},
                           {"medial", medial}, {"graze", graze},   {"leave", leave}};

}  // namespace

std::uint64_t mutate_hand(const std::vector<Input>& hand, const FieldView& field, const MutationOptions& options, Hand::Emit emit) {
  for (const Kind& kind : kKinds) {
    if (options.kind != kind.name) continue;
    HandMutator miner(hand, field, options, std::move(emit));
    kind.mine(miner);
    return miner.hand.emitted();
  }
  throw InputError("there is no mutation of positions '" + options.kind + "'");
}

}  // namespace isotouch::motion
