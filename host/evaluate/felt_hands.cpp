#include "host/evaluate/felt_hands.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>

#include "host/cloud/mesh.h"
#include "host/cloud/random.h"
#include "host/error.h"
#include "host/evaluate/crease_hand.h"
#include "host/evaluate/plane_motion.h"
#include "host/evaluate/sharp_edges.h"
#include "host/field/first_hit.h"
#include "host/field/line_crossings.h"
#include "host/field/parallel.h"
#include "host/motion/hand.h"

namespace isotouch::evaluate {

using cloud::Random;
using Eigen::Vector3d;
using field::TriangleTree;

namespace {

constexpr double kClearance = 2;           // mm above the surface, where a hand begins
constexpr double kMinClearance = 0.5;      // mm, and as much again to the other side of a gap
constexpr double kTick = 0.001;            // s
constexpr std::size_t kPlaces = 4096;      // to choose from
constexpr std::size_t kPieceTicks = 2000;  // of a recorded hand
constexpr std::size_t kMaxPieces = 20;     // of one recording

/// How many hands of each kind, by trial: some thousand ticks of contact each, and less than 20 s on 100,000 faces.
constexpr std::array<std::size_t, 8> kHands = {240, 40, 40, 30, 400, 50, 50, 60};

struct Place {
  Vector3d point, outward;
};

Vector3d in_cube(Random& random, double half) {
  const double x = random.uniform(-half, half), y = random.uniform(-half, half);
  return {x, y, random.uniform(-half, half)};
}

/// What a wave of amplitude 1 moves in this tick.
double swing(double per_second, int tick) {
  return motion::wave(per_second * kTick * (tick + 1)) - motion::wave(per_second * kTick * tick);
}

class Planner {
 public:
  Planner(const TrueTrees& trees, const std::vector<RecordedHand>& recorded, const FeltHandOptions& options)
      : trees_(trees), tree_(trees.outer), options_(options) {
    const cloud::OrientedPoints drawn = cloud::scatter_on_mesh(tree_.mesh(), kPlaces, options.seed);
    for (std::size_t i = 0; i < drawn.size(); ++i) {
      if (const Place place{drawn.positions[i], drawn.normals[i]}; is_free(place) && above(place)) places_.push_back(place);
    }
    if (places_.empty()) throw InputError("the mesh has no place that can be touched from outside");
    for (const SharpEdge& edge : bounding_edges(trees, kSharpDeg)) (edge.turn_deg > 0 ? convex_ : concave_).push_back(edge);
    for (const RecordedHand& hand : recorded) motions_.push_back(plane_motion(hand.positions));
    for (std::size_t kind = 0; kind < kHands.size(); ++kind) {
      const double wanted = static_cast<double>(kHands[kind]) * options.share;
      for (std::size_t i = 0; i < std::max<std::size_t>(1, static_cast<std::size_t>(wanted)); ++i) {
        hands_.push_back({static_cast<FeltKind>(kind), i, {}, {}});
        pieces_.push_back({});
      }
    }
    std::size_t number = 0;
    for (std::size_t r = 0; r < recorded.size(); ++r) {
      const std::size_t pieces = std::min(kMaxPieces, (recorded[r].positions.size() + kPieceTicks - 1) / kPieceTicks);
      for (std::size_t i = 0; i < pieces; ++i) {
        hands_.push_back({FeltKind::kRecorded, number++, recorded[r].name, {}});
        pieces_.push_back({r, i * kPieceTicks});
      }
    }
  }

  std::vector<FeltHand> run() {
    field::in_parallel(hands_.size(), 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) plan(hands_[i], pieces_[i]);
    });
    std::erase_if(hands_, [](const FeltHand& hand) { return hand.ticks.empty(); });
    return std::move(hands_);
  }

 private:
  struct Piece {
    std::size_t recording = 0, first = 0;
  };

  void plan(FeltHand& hand, const Piece& piece) const {
    Random random(options_.seed * 1'000'003 + static_cast<std::uint64_t>(hand.kind) * 65'537 + hand.number);
    switch (hand.kind) {
      case FeltKind::kPress: hand.ticks = press(random); return;
      case FeltKind::kSlide100: hand.ticks = slide(random, 100, 600); return;
      case FeltKind::kSlide300: hand.ticks = slide(random, 300, 400); return;
      case FeltKind::kScrub: hand.ticks = scrub(random); return;
      case FeltKind::kStab: hand.ticks = stab(random); return;
      case FeltKind::kEdge: hand.ticks = edge(random); return;
      case FeltKind::kCrease: hand.ticks = crease(random); return;
      case FeltKind::kThin: hand.ticks = thin(random); return;
      case FeltKind::kRecorded: hand.ticks = recorded(random, motions_[piece.recording], piece.first); return;
    }
  }

  /// Anywhere on the surface that can be seen from outside, by area.
  const Place& any_place(Random& random) const { return places_[random.bits() % places_.size()]; }
  bool is_free(const Place& place) const { return !field::is_inside(trees_.closed, place.point + 0.01 * place.outward); }

  /// A place in front of the surface for a hand to begin at; none where the gap is too narrow for one.
  std::optional<Vector3d> before(const Place& place, const Vector3d& way, double wanted) const {
    const auto hit = field::first_hit(tree_, place.point + 1e-4 * way, way);
    const double room = hit ? std::min(wanted, hit->t / 2) : wanted;
    return room < kMinClearance ? std::nullopt : std::optional(Vector3d(place.point + room * way));
  }
  std::optional<Vector3d> above(const Place& place) const { return before(place, place.outward, kClearance); }

  std::vector<FeltTick> press(Random& random) const {
    const Place& place = any_place(random);
    const double depth = random.uniform(0.3, 1);
    const std::optional<Vector3d> begin = above(place);
    if (!begin) return {};
    FeltPath path(tree_, *begin);
    const double mm_per_tick = random.uniform(0.01, 0.05);
    path.move(place.point, 0.1);
    path.move(place.point - depth * place.outward, mm_per_tick);
    path.hold(20);
    path.move(place.point, mm_per_tick);
    path.move(*begin, 0.1);
    return path.take();
  }

  std::vector<FeltTick> slide(Random& random, double speed, int ticks) const {
    const Place& place = any_place(random);
    const std::optional<Vector3d> begin = above(place);
    if (!begin) return {};
    FeltPath path(tree_, *begin);
    SteeredHand hand(tree_, path, place.outward, in_cube(random, 1));
    const double depth = random.uniform(0.1, 1), bend = random.uniform(-0.01, 0.01);
    hand.sink(depth);
    for (int tick = 0; tick < ticks; ++tick) {
      hand.step(std::min(1.0, tick / 50.0) * speed * kTick, 0, depth);
      hand.turn(bend);
    }
    return path.take();
  }

  std::vector<FeltTick> scrub(Random& random) const {
    constexpr double kStroke = 10, kPerSecond = 3;  // mm from its middle, times a second
    const Place& place = any_place(random);
    const std::optional<Vector3d> begin = above(place);
    if (!begin) return {};
    FeltPath path(tree_, *begin);
    SteeredHand hand(tree_, path, place.outward, in_cube(random, 1));
    const double depth = random.uniform(0.1, 1);
    hand.sink(depth);
    for (int tick = 0; tick < 700; ++tick) {
      hand.step(-kStroke * swing(kPerSecond, tick), 0, depth);
    }
    return path.take();
  }

  std::vector<FeltTick> stab(Random& random) const {
    constexpr double kMmPerTick = 1;  // 1 m/s
    const Place& place = any_place(random);
    const Vector3d away = (place.outward + in_cube(random, 0.7)).normalized();
    const double slope = away.dot(place.outward);
    if (slope < 0.3) return {};
    const double depth = random.uniform(0.1, 1) / slope;
    const std::optional<Vector3d> begin = before(place, away, 3 + random.uniform());
    if (!begin) return {};
    FeltPath path(tree_, *begin);
    path.move(place.point - depth * away, kMmPerTick);
    path.hold(20);
    path.move(*begin, kMmPerTick);
    return path.take();
  }

  std::vector<FeltTick> edge(Random& random) const {
    constexpr double kBeside = 1, kPerSecond = 2.5, kSpeed = 20;  // mm, times a second, mm/s
    const std::optional<EdgePlace> found = place_on_edges(convex_, random);
    if (!found) return {};
    const auto& [edge, on_edge] = *found;
    const Vector3d along = (edge.end - edge.begin).normalized();
    const std::size_t side = random.bits() & 1U;
    const Vector3d into_face = edge.into_face(side);
    const TriangleTree::Foot foot = tree_.nearest(on_edge + kBeside * into_face);
    const Place place{foot.point, cloud::face_normal(tree_.mesh(), foot.face)};
    if (!is_free(place)) return {};
    const std::optional<Vector3d> begin = above(place);
    if (!begin) return {};
    FeltPath path(tree_, *begin);
    SteeredHand hand(tree_, path, place.outward, along);
    const double depth = random.uniform(0.1, 1);
    hand.sink(depth);
    const double width = into_face.dot(hand.aside()) > 0 ? kBeside : -kBeside;
    for (int tick = 0; tick < 400; ++tick) {
      hand.step(kSpeed * kTick, width * swing(kPerSecond, tick), depth);
    }
    return path.take();
  }

  std::vector<FeltTick> crease(Random& random) const {
    constexpr double kWidth = 2, kPerSecond = 2.5, kSpeed = 20;  // to each side, times a second, mm/s
    const std::optional<EdgePlace> found = place_on_edges(concave_, random);
    if (!found) return {};
    const Vector3d out = found->edge.normals[0] + found->edge.normals[1];
    if (out.norm() < 0.1) return {};
    const Place place{found->point, out.normalized()};
    if (!is_free(place)) return {};
    const std::optional<Vector3d> begin = above(place);
    if (!begin) return {};
    const double depth = random.uniform(0.1, 1);
    const double width = (random.bits() & 1U) != 0 ? kWidth : 0.0;
    if (!field::is_inside(trees_.closed, place.point - depth * place.outward)) return {};  // a thin part
    FeltPath path(tree_, *begin);
    CreaseHand hand(concave_, *found, path, depth);
    hand.sink(0.1);
    for (int tick = 0; tick < 400; ++tick) {
      hand.step(kSpeed * kTick, width * motion::wave(kPerSecond * kTick * tick + 0.25));
    }
    return path.take();
  }

  /// The thinnest of some places, if it is thin.
  std::vector<FeltTick> thin(Random& random) const {
    constexpr int kDraws = 24;
    std::optional<Place> thinnest;
    double thickness = kThinMm;
    for (int draw = 0; draw < kDraws; ++draw) {
      const Place& place = any_place(random);
      const auto hit = field::first_hit(tree_, place.point - 1e-4 * place.outward, -place.outward);
      if (!hit || !hit->from_inside || hit->t >= thickness || hit->normal.dot(place.outward) > -0.5) continue;
      thickness = hit->t;
      thinnest = place;
    }
    if (!thinnest) return {};
    const Vector3d begin = *above(*thinnest);
    FeltPath path(tree_, begin);
    const Vector3d end = thinnest->point - (thickness + 1) * thinnest->outward;
    path.move(end, 0.1);
    path.hold(10);
    path.move(begin, 0.1);
    return path.take();
  }

  std::vector<FeltTick> recorded(Random& random, const PlaneMotion& motion, std::size_t first) const {
    const Place& place = any_place(random);
    const std::optional<Vector3d> begin = above(place);
    if (!begin) return {};
    FeltPath path(tree_, *begin);
    SteeredHand hand(tree_, path, place.outward, in_cube(random, 1));
    hand.sink(motion.depth[first]);
    for (std::size_t i = first; i < std::min(first + kPieceTicks, motion.depth.size()); ++i) {
      hand.step(motion.ahead[i], motion.aside[i], motion.depth[i]);
    }
    return path.take();
  }

  TrueTrees trees_;
  const TriangleTree& tree_;  ///< of what can be touched
  FeltHandOptions options_;
  std::vector<Place> places_;
  std::vector<SharpEdge> convex_, concave_;
  std::vector<PlaneMotion> motions_;
  std::vector<FeltHand> hands_;
  std::vector<Piece> pieces_;
};

}  // namespace

std::vector<FeltHand> felt_hands(const TrueTrees& trees, const std::vector<RecordedHand>& recorded, const FeltHandOptions& options) {
  return Planner(trees, recorded, options).run();
}

}  // namespace isotouch::evaluate
