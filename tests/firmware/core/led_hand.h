/// Surfaces and a hand for tests of surfaces that move: bodies in voxels of one grid, and a hand that is led from place to place over them.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "firmware/core/render.h"
#include "shared/tick_io.h"
#include "tests/support/field_image.h"

namespace isotouch::core {

using test::DistanceFunction;
using test::FieldImage;
using test::Point;

inline constexpr double kEdge = 0.5, kStiffness = 0.8;
inline constexpr std::uint32_t kSize = 48;
inline constexpr double kMostChange = 0.05;

inline FieldImage field_of(const DistanceFunction& distance) {
  return FieldImage({kSize, kSize, kSize}, distance,
                    {.edge_mm = kEdge,
                     .band = 4.0,
                     .stiffness = kStiffness,
                     .origin_mm = {0, 0, 0},
                     .prefilter = false,
                     .interpolation = Interpolation::kTrilinear});
}

/// A block whose top is at z = height, voxels.
inline DistanceFunction block(double height) {
  return [height](const Point& at) { return std::max({at.z - height, 6 - at.z, 7 - at.x, at.x - 40, 7 - at.y, at.y - 40}); };
}
inline DistanceFunction plate(double middle, double half = 1.5) {
  return [=](const Point& at) { return std::max({std::abs(at.z - middle) - half, 7 - at.x, at.x - 40, 7 - at.y, at.y - 40}); };
}
inline DistanceFunction ball(const Point& centre, double radius) {
  return [=](const Point& at) { return length(at - centre) - radius; };
}
inline DistanceFunction nothing() {
  return [](const Point&) { return 100.0; };
}

inline double newton(Newton n) { return n.raw() / 65536.0; }
inline Point newton(const Vec3<Newton>& f) { return {newton(f.x), newton(f.y), newton(f.z)}; }
inline Point millimetres(const Vec3<Mm>& p) { return {p.x.raw() / 1048576.0, p.y.raw() / 1048576.0, p.z.raw() / 1048576.0}; }
inline Mm mm(double v) { return Mm::from_raw(static_cast<std::int32_t>(std::lround(v * 1048576))); }
/// Of a place in voxels.
inline Vec3<Mm> at_voxel(const Point& p) { return {mm(p.x * kEdge), mm(p.y * kEdge), mm(p.z * kEdge)}; }

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

inline constexpr Point kAbove = {24, 24, 30};

/// On a block of height 20, pressed to `z`, after the hand came from above.
inline Hand pressed(const FieldImage& field, double z, const TickSettings& settings = {}) {
  Hand hand(field, settings);
  hand.lead(kAbove, {24, 24, z}, 400);
  for (int t = 0; t < 100; ++t) hand.go_to({24, 24, z});
  return hand;
}

inline double spring(double voxels) { return voxels * kEdge * kStiffness; }

}  // namespace isotouch::core
