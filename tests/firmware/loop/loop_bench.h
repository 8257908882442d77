/// A loop with everything around it but a device: a fake one on a clock of its own, and a ball to load.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <vector>

#include "firmware/loop/loop.h"
#include "tests/support/fake_device.h"
#include "tests/support/falcon_twin.h"
#include "tests/support/field_image.h"

namespace isotouch::loop {

using test::FakeDevice;
using test::Point;

inline constexpr Point kOrigin = {0, 0, 125};

inline std::vector<std::uint8_t> ball(double radius = 20.0) {
  return test::FieldImage({64, 64, 64},
                          [radius](const Point& p) {
                            return test::length(p * 0.4 - Point{12, 12, 12}) / 0.4 - radius;
                          },
                          {.edge_mm = 0.4, .origin_mm = {-12, -12, -12}})
      .bytes();
}

/// A homed grip at a place of the workspace.
inline FalconPacket grip_at(const Point& place) {
  static const test::FalconSet set = test::falcon_sets()[0];
  return encode(FalconReply{test::nearest_counts(set.twin, place + kOrigin).value(), 0, 7});
}

struct Bench {
  explicit Bench(const LoopSettings& wish = {}, std::size_t ring = 1 << 12)
      : trace(ring), settings(wish), loop(settings, device, clock, {fields, requests, trace, shown, stats, &lines}) {}

  VirtualClock clock;
  FakeDevice device{clock};
  FieldSlots fields{1 << 20};
  Requests requests;
  TraceRing trace;
  Latest<TickRecord> shown;
  TickStats stats;
  LineState lines;
  LoopSettings settings;
  Loop loop;

  void steps(int count) {
    for (int i = 0; i < count; ++i) ASSERT_TRUE(loop.step());
  }
  TickRecord step() {
    EXPECT_TRUE(loop.step());
    return shown.get();
  }
  void load(const std::vector<std::uint8_t>& image, std::uint32_t author = kNobody) {
    std::copy(image.begin(), image.end(), fields.begin(image.size()).begin());
    ASSERT_TRUE(fields.verify());
    ASSERT_TRUE(fields.commit(author));
  }
  /// The same as a patch of the field that is felt.
  void patch(const std::vector<std::uint8_t>& image, std::uint32_t author = kNobody) {
    std::copy(image.begin(), image.end(), fields.begin(image.size()).begin());
    const auto view = fields.verify();
    ASSERT_TRUE(view);
    ASSERT_TRUE(fields.commit_patched((*view)->hash(), author));
  }
  SupervisorState state() { return static_cast<SupervisorState>(shown.get().out.state); }
};

}  // namespace isotouch::loop
