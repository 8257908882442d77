#include "host/trace/felt_settings.h"

#include <gtest/gtest.h>

#include <cmath>

#include "host/motion/device_in_hand.h"
#include "host/motion/motion.h"
#include "host/trace/replay.h"
#include "tests/support/field_image.h"

namespace isotouch::trace {
namespace {

const test::FieldImage& ball() {
  static const test::FieldImage image({61, 61, 61},
                                      [](const test::Point& p) { return std::hypot(p[0] - 30.2, p[1] - 29.7, p[2] - 30.4) - 20; });
  return image;
}

/// A touch of a device whose settings change: before there is force, on the way to the value of before, and while another field is loaded.
std::vector<Input> inputs() {
  std::vector<Input> all;
  motion::DeviceInHand device(DeviceModel{});
  const FieldView field = ball().view();
  motion::make_motion(&field, {.kind = "tour", .ticks = 3000}, [&](const Input& at) {
    const std::size_t tick = all.size();
    Input in = device(at);
    in.field_generation = tick < 40 ? 0 : tick < 1530 ? 7 : 8;
    if (tick < 10) in = Input{};
    if (tick == 20) in.change = {TickSetting::kForceLimit, Newton::of(6).raw()};
    if (tick == 500) in.change = {TickSetting::kStiffness, Stiffness::of(0.2).raw()};
    if (tick == 900) in.change = {TickSetting::kForceLimit, Newton::of(2).raw()};
    if (tick == 910) in.change = {TickSetting::kFriction, Ratio::of(0.4).raw()};
    if (tick == 1500) in.change = {TickSetting::kStiffness, Stiffness::of(0.4).raw()};
    if (tick == 2500) in.requests = kRequestRestart;
    all.push_back(in);
  });
  return all;
}

TEST(FeltSettings, AreThoseThatTheTickFeltWith) {
  for (const Stiffness stiffness : {Stiffness{}, Stiffness::of(0.7)}) {
    TraceHeader header;
    header.settings.stiffness = stiffness;
    trace::Run run(ball().view(), header);
    FeltSettings settings(run.header(), ball().view().stiffness);
    std::size_t tick = 0, moving = 0;
    TickSettings before = header.settings;
    for (const Input& input : inputs()) {
      const TickSettings now = settings.next(run.step(input));
      const core::RenderModel& felt = run.felt(InputKind::kPacket);
      TickSettings expected = felt.settings;
      if (tick >= 40 && expected.stiffness == Stiffness{}) expected.stiffness = felt.coupling.stiffness;
      if (tick < 40) expected.stiffness = now.stiffness;  // of no field yet
      ASSERT_EQ(now, expected) << "tick " << tick << ", stiffness " << stiffness.raw();
      if (tick > 40 && !(now == before)) ++moving;
      before = now, ++tick;
    }
    EXPECT_GT(moving, 100U) << "the ramps were seen";
  }
}

TEST(FeltSettings, APositionTakesNoChange) {
  TraceHeader header;
  TraceRecord record;
  record.input = position_input({});
  record.input.change = {TickSetting::kForceLimit, Newton::of(2).raw()};
  EXPECT_EQ(FeltSettings(header, Stiffness::of(0.5)).next(record).force_limit, header.settings.force_limit);
}

}  // namespace
}  // namespace isotouch::trace
