#include "tests/integration/wall_trials.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <vector>

#include "firmware/core/render.h"
#include "host/encoding/write_image.h"
#include "host/field/make_grid.h"
#include "host/field/sample_distance.h"
#include "shared/device_model.h"
#include "tests/support/random.h"

namespace isotouch::test {

namespace {

constexpr double kEdge = 0.34;        // mm a voxel: all lengths below are voxels
constexpr double kRim = 42;           // plates end here
constexpr double kReach = 30;         // of the hand: a proxy that follows it on a plate stays well within the rim
constexpr double kSpeed = 1 / kEdge;  // 1 m/s at 1 kHz
constexpr double kBand = 3;

using Distance = std::function<double(const Point&)>;

/// A body around the origin.
struct Body {
  std::string name;
  Distance distance;            ///< true outside, never too far inside
  std::vector<Distance> sides;  ///< a proxy may change the sign of none of them
};

Body plates(int count, Random& random, const WallOptions& options) {
  Body body;
  std::vector<Point> normals;
  std::vector<double> heights, halves;
  while (normals.size() < static_cast<std::size_t>(count)) {
    const Point normal = random.direction();
    const bool flat = std::any_of(normals.begin(), normals.end(), [&](const Point& n) { return std::abs(dot(n, normal)) > 0.87; });
    if (flat) continue;  // at least 30 degrees apart
    normals.push_back(normal);
    heights.push_back(random.uniform(-8, 8));
    halves.push_back(random.uniform(options.thinnest, options.thickest) / 2);
  }
  body.name = std::to_string(count) + (count == 1 ? " plate" : " crossing plates");
  for (std::size_t i = 0; i < normals.size(); ++i) {
    const auto height = [n = normals[i], h = heights[i]](const Point& p) { return dot(p, n) - h; };
    body.sides.emplace_back(height);
    body.name += ", " + std::to_string(2 * halves[i]) + " thick";
  }
  body.distance = [sides = body.sides, halves](const Point& p) {
    double nearest = 1e9;
    for (std::size_t i = 0; i < sides.size(); ++i) nearest = std::min(nearest, std::abs(sides[i](p)) - halves[i]);
    return std::max(nearest, length(p) - kRim);
  };
  return body;
}

/// A ball, a box or a capsule, turned and moved at random.
Distance piece(Random& random) {
  const Point middle = random.in_ball(16);
  const Frame frame(random.direction());
  const auto local = [=](const Point& p) { return Point{dot(p - middle, frame.x), dot(p - middle, frame.y), dot(p - middle, frame.z)}; };
  const double radius = random.uniform(4, 14);
  switch (random.bits() % 3) {
    case 0: return [=](const Point& p) { return length(p - middle) - radius; };
    case 1: {
      const Point half = {random.uniform(2, 14), random.uniform(2, 14), random.uniform(2, 14)};
      return [=](const Point& p) {
        const Point q = local(p);
        const Point out = {std::abs(q.x) - half.x, std::abs(q.y) - half.y, std::abs(q.z) - half.z};
        return length({std::max(out.x, 0.0), std::max(out.y, 0.0), std::max(out.z, 0.0)}) + std::min(std::max({out.x, out.y, out.z}), 0.0);
      };
    }
    default: {
      const double half = random.uniform(4, 16), thick = radius / 2;
      return [=](const Point& p) {
        const Point q = local(p);
        return length({q.x - std::clamp(q.x, -half, half), q.y, q.z}) - thick;
      };
    }
  }
}

/// Pieces added and taken away.
Distance object(Random& random) {
  std::vector<Distance> added, taken;
  for (std::uint64_t n = 2 + random.bits() % 5; n > 0; --n) added.push_back(piece(random));
  for (std::uint64_t n = random.bits() % 3; n > 0; --n) taken.push_back(piece(random));
  return [=](const Point& p) {
    double distance = 1e9;
    for (const Distance& one : added) distance = std::min(distance, one(p));
    for (const Distance& one : taken) distance = std::max(distance, -one(p));
    return distance;
  };
}

Body shell(Random& random, const WallOptions& options) {
  const double half = random.uniform(options.thinnest, options.thickest) / 2;
  const Distance middle = object(random);
  return {"a hollow object, " + std::to_string(2 * half) + " thick", [=](const Point& p) { return std::abs(middle(p)) - half; }, {middle}};
}

/// Deeper than a voxel is wrong everywhere.
Body solid(Random& random) {
  const Distance surface = object(random);
  return {"a solid object", surface, {[=](const Point& p) { return surface(p) + 1; }}};
}

Body random_body(Random& random, const WallOptions& options) {
  switch (random.bits() % 6) {
    case 0: return plates(1, random, options);
    case 1: return plates(2, random, options);
    case 2: return plates(3, random, options);
    case 3: return solid(random);
    default: return shell(random, options);
  }
}

field_file::Image image_of(const Body& body, Interpolation interpolation) {
  const Eigen::Vector3d corner = Eigen::Vector3d::Constant(kRim * kEdge);
  const field::Grid grid = field::make_grid(-corner, corner, kEdge, kBand + 5);
  const auto distance = [&](const Eigen::Vector3d& p) {
    return kEdge * std::max(body.distance({p.x() / kEdge, p.y() / kEdge, p.z() / kEdge}), p.norm() / kEdge - kRim);
  };
  encoding::FieldInfo info;
  info.interpolation = interpolation;
  return encoding::write_image(field::sample_distance(distance, grid, kBand), info);
}

/// Where a hand is in each tick.
class Wanderer {
 public:
  Wanderer(const Point& start, Random& random) : hip_(start), random_(random) {}

  Point next() {
    if (left_ == 0) choose();
    --left_;
    switch (way_) {
      case Way::kStraight: hip_ = hip_ + step_; break;
      case Way::kWalk: hip_ = hip_ + random_.in_ball(kSpeed / 2); break;
      case Way::kRest: break;
      case Way::kJump: hip_ = target_; break;
    }
    if (length(hip_) > kReach) hip_ = hip_ * (kReach / length(hip_));
    return hip_;
  }

 private:
  enum class Way { kStraight, kWalk, kRest, kJump };

  void choose() {
    way_ = static_cast<Way>(random_.bits() % 4);
    target_ = random_.in_ball(kReach);
    left_ = 1 + random_.bits() % 100;
    if (way_ == Way::kStraight) {
      const double speed = kSpeed * random_.uniform(0.05, 1);
      left_ = static_cast<std::uint64_t>(std::ceil(length(target_ - hip_) / speed));
      step_ = (target_ - hip_) * (1 / std::max(1.0, static_cast<double>(left_)));
      left_ = std::max<std::uint64_t>(left_, 1);
    }
    if (way_ == Way::kJump) {
      const Point by = target_ - hip_;
      target_ = hip_ + by * std::min(1.0, 50 / length(by));
      left_ = 1;
    }
  }

  Point hip_, target_, step_;
  Random& random_;
  Way way_ = Way::kRest;
  std::uint64_t left_ = 0;
};

Point free_place(const Body& body, Random& random) {
  for (int i = 0; i < 10'000; ++i) {
    const Point p = random.in_ball(kReach);
    if (body.distance(p) > 3) return p;
  }
  return {0, 0, kReach};
}

Vec3<Mm> to_mm(const Point& p) {
  const auto raw = [](double voxels) { return Mm::from_raw(static_cast<std::int32_t>(std::lround(voxels * kEdge * 1048576))); };
  return {raw(p.x), raw(p.y), raw(p.z)};
}
Point to_voxels(const Vec3<Mm>& v) {
  const auto voxels = [](Mm mm) { return mm.raw() / 1048576.0 / kEdge; };
  return {voxels(v.x), voxels(v.y), voxels(v.z)};
}

void run_body(const Body& body, const WallOptions& options, Random& random, WallRun& run) {
  const field_file::Image image = image_of(body, options.interpolation);
  const FieldView field = *FieldView::parse(image.bytes());
  TickSettings settings;
  const core::PositionModel model = core::make_position_model(libnifalcon_model(), settings, 1'000'000, field);
  core::PositionState state;
  const Point start = free_place(body, random);
  std::vector<bool> side;
  for (const Distance& of : body.sides) side.push_back(of(start) > 0);
  Wanderer hand(start, random);
  core::render_position(position_input(to_mm(start)), field, model, state);
  ++run.bodies;
  Point before = start, last = start;
  bool touched = false;
  for (std::uint64_t tick = 0; tick < kTicksOfAWall; ++tick) {
    const Point hip = hand.next();
    const Output out = core::render_position(position_input(to_mm(hip)), field, model, state);
    const Point proxy = to_voxels(out.proxy);
    ++run.ticks;
    run.jumps += length(hip - before) > kSpeed + 1e-9 ? 1U : 0U;
    before = hip;
    const bool touching = (out.status & kContact) != 0;
    if (touching) {
      ++run.touching;
      run.deepest_voxel = std::max(run.deepest_voxel, -body.distance(proxy));
      if (touched) run.longest_voxel = std::max(run.longest_voxel, length(proxy - last));
    }
    touched = touching;
    last = proxy;
    for (std::size_t i = 0; i < body.sides.size(); ++i) {
      if ((body.sides[i](proxy) > 0) == side[i]) continue;
      if (run.passed++ == 0) {
        char text[200];
        std::snprintf(text, sizeof text, "body %llu (%s), tick %llu: proxy at (%.3f, %.3f, %.3f) voxels from the middle",
                      static_cast<unsigned long long>(run.bodies), body.name.c_str(), static_cast<unsigned long long>(tick), proxy.x,
                      proxy.y, proxy.z);
        run.first = text;
      }
      return;
    }
  }
}

}  // namespace

WallRun wall_trials(std::uint64_t ticks, std::uint64_t seed, const WallOptions& options) {
  WallRun run;
  Random random(seed);
  while (run.ticks < ticks) {
    Random of_body(random.bits());
    run_body(random_body(of_body, options), options, of_body, run);
  }
  return run;
}

std::string describe(const WallRun& run) {
  char text[400];
  std::snprintf(
      text, sizeof text,
      "%llu ticks on %llu bodies, %llu of them in contact, %llu jumps; walls passed on %llu bodies; deepest proxy %.3f voxel below the "
      "true surface, longest way in a tick of contact %.2f voxels%s%s",
      static_cast<unsigned long long>(run.ticks), static_cast<unsigned long long>(run.bodies),
      static_cast<unsigned long long>(run.touching), static_cast<unsigned long long>(run.jumps),
      static_cast<unsigned long long>(run.passed), run.deepest_voxel, run.longest_voxel,
      run.first.empty() ? "" : "; first: ", run.first.c_str());
  return text;
}

}  // namespace isotouch::test
