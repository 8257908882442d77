#include "host/evaluate/mesh_scan.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "host/cloud/mesh.h"
#include "host/cloud/poisson_disk.h"
#include "host/cloud/random.h"
#include "host/evaluate/god_object.h"
#include "host/field/first_hit.h"
#include "host/field/nearest.h"
#include "host/motion/hand.h"
#include "host/to_double.h"

namespace isotouch::evaluate {

using Eigen::Vector3d;
using field::TriangleTree;

namespace {

constexpr double kTick = kScanPeriodNs * 1e-9;  // s
constexpr double kMeanSpeed = 100;              // mm/s
constexpr double kUseful = 0.5;                 // share of the time that adds something new, by trial on the data's meshes
constexpr double kMaxStroke = 8;                // s
constexpr double kTravelSpeed = 250;            // mm/s
constexpr double kClearance = 4;                // mm over the surface before and after a stroke
constexpr int kTries = 3;                       // strokes that pass a target in vain
constexpr double kPatience = 0.15;              // s beyond the time that the way to a target should take

/// The mass behind the fingers: critically damped towards where the script wants it.
class Fingers {
 public:
  explicit Fingers(const Vector3d& at) : position_(at) {}

  const Vector3d& follow(const Vector3d& wanted) {
    constexpr double kStiffness = 60.0 * 60.0, kDamping = 2 * 60.0;  // 1/s², 1/s
    constexpr double kMaxAcceleration = 8000, kMaxSpeed = 400;       // mm/s², mm/s
    velocity_ += kTick * shortened(kStiffness * (wanted - position_) - kDamping * velocity_, kMaxAcceleration);
    velocity_ = shortened(velocity_, kMaxSpeed);
    position_ += kTick * velocity_;
    return position_;
  }

 private:
  static Vector3d shortened(const Vector3d& v, double most) {
    const double length = v.norm();
    return length > most ? Vector3d(most / length * v) : v;
  }
  Vector3d position_;
  Vector3d velocity_ = Vector3d::Zero();
};

Vector3d tremor(double time) {
  constexpr double kSize = 0.03;  // mm
  return kSize * Vector3d(motion::wave(9.3 * time), motion::wave(10.7 * time + 0.3), motion::wave(11.9 * time + 0.7));
}

class Scan {
 public:
  using Emit = std::function<void(const Input&, const Output&)>;

  Scan(const TriangleTree& tree, const MeshScanOptions& options, const Emit& emit)
      : tree_(tree),
        options_(options),
        emit_(emit),
        random_(options.seed),
        ticks_(static_cast<std::uint64_t>(options.seconds / kTick + 0.5)),
        centre_((box().low + box().high) / 2),
        radius_((box().high - box().low).norm() / 2 + 3 * kClearance),
        targets_(make_targets()),
        near_(targets_.positions),
        done_(targets_.size(), false),
        tries_(targets_.size(), 0),
        passed_(targets_.size(), 0),
        fingers_(centre_ + radius_ * Vector3d::UnitZ()),
        object_(tree, centre_ + radius_ * Vector3d::UnitZ()),
        at_(centre_ + radius_ * Vector3d::UnitZ()) {}

  MeshScanReport run() {
    while (!over()) {
      const std::optional<std::size_t> first = land();
      if (!first) break;
      ++report_.strokes;
      stroke(*first);
      lift();
    }
    report_.targets = targets_.size();
    return report_;
  }

 private:
  const TriangleTree::Box& box() const { return tree_.box(TriangleTree::root()); }
  bool over() const { return report_.ticks >= ticks_; }

  /// So far apart that the time suffices for strokes that far apart.
  cloud::OrientedPoints make_targets() {
    double area = 0;
    for (std::uint32_t face = 0; face < tree_.mesh().faces.size(); ++face) {
      const auto [a, b, c] = tree_.corners(face);
      area += (b - a).cross(c - a).norm() / 2;
    }
    spacing_ = std::clamp(area / (kMeanSpeed * kUseful * options_.seconds), 0.004 * radius_, 0.1 * radius_);
    const auto count = std::max<std::size_t>(16, static_cast<std::size_t>(area / (spacing_ * spacing_)));
    const cloud::OrientedPoints candidates = cloud::scatter_on_mesh(tree_.mesh(), 4 * count, options_.seed);
    cloud::OrientedPoints targets;
    for (const std::size_t i : cloud::spread_out(candidates, area, count)) {
      targets.positions.push_back(candidates.positions[i]);
      targets.normals.push_back(candidates.normals[i]);
    }
    return targets;
  }

  /// One tick of the hand towards a place.
  void tick(const Vector3d& wanted) {
    if (over()) return;
    const double time = static_cast<double>(report_.ticks) * kTick;
    const Input input = position_input(to_fixed<Mm>(fingers_.follow(wanted) + tremor(time)));
    const Vector3d hip = to_double(input.hip);
    const Vector3d proxy = object_.follow(hip);
    depth_ = (proxy - hip).norm();
    const Vector3d force = options_.stiffness_n_per_mm * (proxy - hip);
    const double limit = std::min(1.0, kScanForceLimit / std::max(force.norm(), 1e-9));
    Output output;
    output.hip = input.hip;
    output.proxy = to_fixed<Mm>(proxy);
    output.force = to_fixed<Newton>(Vector3d(limit * force));
    if (object_.touching()) {
      output.status = kContact | (limit < 1 ? kForceLimited : 0U);
      ++report_.touching;
      report_.deepest_mm = std::max(report_.deepest_mm, depth_);
      near_.within(proxy, 0.6 * spacing_, found_);
      for (const field::Neighbour& target : found_) {
        if (done_[target.index] || targets_.normals[target.index].dot(proxy - hip) <= 0) continue;
        done_[target.index] = true;
        ++report_.reached;
      }
    }
    ++report_.ticks;
    emit_(input, output);
  }

  void move(const Vector3d& to, double speed) {
    const Vector3d from = at_;
    const double steps = std::ceil((to - from).norm() / (speed * kTick));
    for (double step = 1; step <= steps && !over(); ++step) tick(from + step / steps * (to - from));
    at_ = to;
  }

  /// Where the free way from a place in front of the surface leaves the ball: along the normal, or the nearest to it of some others.
  std::optional<Vector3d> way_out(const Vector3d& place, const Vector3d& normal) {
    cloud::Random random(7);
    for (int attempt = 0; attempt < 48; ++attempt) {
      Vector3d way = normal;
      if (attempt > 0) {
        const double x = random.uniform(-1, 1), y = random.uniform(-1, 1);
        way = normal + attempt / 24.0 * Vector3d(x, y, random.uniform(-1, 1));
        if (!(way.dot(normal) > 0.05 * way.norm())) continue;
        way.normalize();
      }
      const Vector3d from = place + 0.01 * normal;
      if (field::first_hit(tree_, from, way)) continue;
      const Vector3d out = from - centre_;
      const double along = out.dot(way);
      const double t = std::sqrt(std::max(0.0, along * along - out.squaredNorm() + radius_ * radius_)) - along;
      return Vector3d(from + t * way);
    }
    return std::nullopt;
  }

  void travel(const Vector3d& to) {
    const Vector3d from = at_;
    for (int leg = 1; leg <= 8; ++leg) {
      Vector3d out = from + leg / 8.0 * (to - from) - centre_;
      if (out.norm() < 0.2 * radius_) out += 0.5 * radius_ * (to - centre_).unitOrthogonal();
      move(leg == 8 ? to : Vector3d(centre_ + radius_ * out.normalized()), kTravelSpeed);
    }
  }

  /// Goes to a target that is left and can be reached, and touches it.
  std::optional<std::size_t> land() {
    std::vector<std::size_t> left;
    for (std::size_t i = 0; i < done_.size(); ++i) {
      if (!done_[i]) left.push_back(i);
    }
    while (!left.empty()) {
      const std::size_t chosen = random_.bits() % left.size();
      const std::size_t target = left[chosen];
      const auto above = way_out(targets_.positions[target], targets_.normals[target]);
      if (above) {
        travel(*above);
        const Vector3d way = (*above - targets_.positions[target]).normalized();
        move(targets_.positions[target] + kClearance * way, kTravelSpeed);
        move(targets_.positions[target], 0.5 * kMeanSpeed);
        return target;
      }
      done_[target] = true;  // no way leads there
      left[chosen] = left.back();
      left.pop_back();
    }
    return std::nullopt;
  }

  /// The target to go to next: near, straight ahead, on this side; nothing when none is near.
  std::optional<std::size_t> next_target(const Vector3d& place, const Vector3d& normal, const Vector3d& heading) {
    std::optional<std::size_t> best;
    double best_cost = 0;
    for (const double reach : {4 * spacing_, 12 * spacing_}) {
      near_.within(place, reach, found_);
      for (const field::Neighbour& candidate : found_) {
        if (done_[candidate.index] || passed_[candidate.index] == report_.strokes || targets_.normals[candidate.index].dot(normal) < -0.2)
          continue;
        const Vector3d way = targets_.positions[candidate.index] - place;
        const double length = way.norm();
        const double cost = length * (2 - way.dot(heading) / std::max(length, 1e-9));
        if (!best || cost < best_cost) best = candidate.index, best_cost = cost;
      }
      if (best) return best;
    }
    return best;
  }

  /// Over the surface with the hand below it. The guide is a point on the surface; it waits for a hand that lags or sinks in.
  void stroke(std::size_t first) {
    const double speed = random_.uniform(80, 120);
    const double depth = random_.uniform(0.5, 2.0);
    const double end = static_cast<double>(report_.ticks) * kTick + random_.uniform(0.5, 1) * kMaxStroke;
    Vector3d guide = targets_.positions[first], normal = targets_.normals[first], heading = normal.unitOrthogonal();
    std::uint32_t face = 0;
    std::optional<std::size_t> target = next_target(guide, normal, heading);
    double patience = 0;
    double pressed = 0;
    while (target && !over() && static_cast<double>(report_.ticks) * kTick < end) {
      const bool there = (targets_.positions[*target] - guide).norm() < 0.3 * spacing_;
      if (done_[*target] || there || patience < 0) {
        if (!done_[*target] && ++tries_[*target] == kTries) done_[*target] = true;  // left out
        passed_[*target] = report_.strokes;
        target = next_target(guide, normal, heading);
        if (!target) break;
        patience = kPatience + 2 * (targets_.positions[*target] - guide).norm() / speed;
      }
      const Vector3d way = targets_.positions[*target] - guide;
      const Vector3d along = way - way.dot(normal) * normal;
      if (along.norm() > 1e-6) heading = (heading + 0.1 * along.normalized()).normalized();
      const double lag = (object_.position() - guide).norm();
      const double pace = speed * std::clamp(2 - lag / 3, 0.0, 1.0) * std::clamp(2.2 - depth_ / 2, 0.1, 1.0);
      const double step = std::min(pace * kTick, along.norm());
      const TriangleTree::Foot foot =
          tree_.nearest(guide + (along.norm() > 1e-6 ? Vector3d(step * along.normalized()) : Vector3d::Zero()), 0, face);
      const auto [a, b, c] = tree_.corners(foot.face);
      guide = foot.point;
      face = foot.face;
      const Vector3d across = (b - a).cross(c - a);
      if (across.norm() > 0) normal = (normal + 0.2 * across.normalized()).normalized();
      patience -= kTick;
      pressed = std::min(pressed + 10 * kTick, 1.0);
      tick(guide - pressed * depth * normal);
    }
    at_ = guide;
    last_normal_ = normal;
  }

  void lift() {
    const Vector3d place = object_.touching() ? object_.position() : at_;
    const auto out = way_out(place, last_normal_);
    at_ = place;
    move(place + kClearance * (out ? Vector3d((*out - place).normalized()) : last_normal_), 0.5 * kTravelSpeed);
    if (out) move(*out, kTravelSpeed);
  }

  const TriangleTree& tree_;
  MeshScanOptions options_;
  const Emit& emit_;
  cloud::Random random_;
  std::uint64_t ticks_;
  Vector3d centre_;
  double radius_;
  double spacing_ = 0;  // of the targets, mm
  cloud::OrientedPoints targets_;
  field::Nearest near_;
  std::vector<bool> done_;           // touched, or given up
  std::vector<int> tries_;           // guided to, and the hand did not come near
  std::vector<std::size_t> passed_;  // in which stroke
  Fingers fingers_;
  GodObject object_;
  double depth_ = 0;  // of the hand, mm
  Vector3d at_;       // where the script is
  Vector3d last_normal_ = Vector3d::UnitZ();
  std::vector<field::Neighbour> found_;
  MeshScanReport report_;
};

}  // namespace

MeshScanReport scan_mesh(const TriangleTree& tree, const MeshScanOptions& options,
                         const std::function<void(const Input&, const Output&)>& emit) {
  return Scan(tree, options, emit).run();
}

}  // namespace isotouch::evaluate
