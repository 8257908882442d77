/// A device whose hand is put where one likes, and a ball to feel.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cstdint>

#include "firmware/core/tick.h"
#include "tests/support/falcon_twin.h"
#include "tests/support/field_image.h"

namespace isotouch::test {

using Words = std::array<std::int16_t, 3>;

inline constexpr Point kCentre = {2, -1, 3};  ///< workspace, mm, of a ball of 8 mm
inline constexpr Point kOrigin = {0, 0, 125};

inline const FieldImage& ball() {
  static const FieldImage image({64, 64, 64},
                                [](const Point& p) {
                                  const Point mm = p * 0.4 - Point{12, 12, 12};
                                  return (length(mm - kCentre) - 8.0) / 0.4;
                                },
                                {.edge_mm = 0.4, .origin_mm = {-12, -12, -12}});
  return image;
}

inline Point mm(const Vec3<Mm>& v) { return {v.x.raw() / 1048576.0, v.y.raw() / 1048576.0, v.z.raw() / 1048576.0}; }
inline Point newton(const Vec3<Newton>& v) { return {v.x.raw() / 65536.0, v.y.raw() / 65536.0, v.z.raw() / 65536.0}; }
inline SupervisorState state_of(const Output& out) { return static_cast<SupervisorState>(out.state); }

inline Input packet(const core::Counts& counts, std::uint8_t homed = 7, std::uint8_t buttons = 0) {
  Input in;
  in.packet = encode(FalconReply{counts, buttons, homed});
  in.fresh = true;
  return in;
}

struct DeviceBench {
  explicit DeviceBench(const FalconSet& which = falcon_sets()[0], DeviceModel device = falcon_sets()[0].model,
                       const TickSettings& settings = {})
      : set(which), model(core::make_tick_model(device, settings, 1'000'000)) {}

  core::Counts counts_at(const Point& workspace) const { return nearest_counts(set.twin, workspace + kOrigin, 3000).value(); }
  Output operator()(Input in) {
    in.field_generation = generation;
    return core::tick(in, generation == 0 ? nullptr : &ball().view(), model, state);
  }
  Output at(const Point& workspace) { return (*this)(packet(counts_at(workspace))); }
  Output rest(const Point& workspace, int ticks) {
    Output out;
    for (int t = 0; t < ticks; ++t) out = at(workspace);
    return out;
  }
  /// Around the ball, 2 mm above it, from one direction to another.
  void go_round(const Point& from, const Point& to) {
    for (int t = 0; t <= 60; ++t) at(kCentre + unit(from * (60.0 - t) + to * t) * 10);
  }
  /// From beside the ball along x, at 50 mm/s, until `radius` mm are left to its middle.
  Output press(double radius) {
    Output out;
    for (double r = 10; r > radius; r -= 0.05) out = at(kCentre + Point{r, 0, 0});
    return out;
  }
  /// Homed, with the field, active, ramp done, beside the ball.
  void begin() {
    generation = 1;
    ASSERT_EQ(state_of(rest(kCentre + Point{10, 0, 0}, 240)), SupervisorState::kActive);
  }
  /// Nothing new for so many ticks.
  static Input stale(std::uint16_t age) {
    Input in;
    in.age = age;
    return in;
  }

  FalconSet set;
  core::TickModel model;
  core::TickState state;
  std::uint32_t generation = 0;
};

}  // namespace isotouch::test
