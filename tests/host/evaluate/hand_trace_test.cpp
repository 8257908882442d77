#include "host/evaluate/hand_trace.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "host/cloud/random.h"
#include "host/error.h"
#include "host/evaluate/real.h"
#include "host/evaluate/replay.h"
#include "host/evaluate/shape_trial.h"
#include "host/evaluate/touch_points.h"
#include "host/evaluate/wire_hand.h"
#include "tests/support/scratch_folder.h"

namespace isotouch::evaluate {
namespace {

constexpr int kTicks = 6000;
constexpr double kRadius = 80 * kTrialVoxel;

/// A sphere, and a device that a hand leads round it 1 mm below the surface, as its packets.
class HandTrace : public testing::Test {
 protected:
  const OpenBlob& sphere() {
    static const OpenBlob blob = trial_blob(shape_trial("sphere"), blob::Method::kDefault);
    return blob;
  }
  static TickInput hand(int tick) {
    TickInput in;
    const double angle = tick * 0.004, z = 15 * std::sin(tick * 0.0007), depth = tick < 500 ? -5 + tick * 0.012 : 1;
    const double radius = std::sqrt((kRadius - depth) * (kRadius - depth) - z * z);
    in.hip = nearest<Mm>(Eigen::Vector3d(radius * std::cos(angle), radius * std::sin(angle), z));
    return in;
  }
  /// returns   the file; with outputs when `felt`
  std::filesystem::path record(bool felt) {
    const auto file = folder_.path() / "wire.trace";
    DeviceTraceHeader header;
    header.device = libnifalcon_model();
    header.run.settings.stiffness = Stiffness::of(0.5);
    DeviceRun run(sphere().view, header);
    if (felt) header = run.header();
    DeviceTraceWriter writer(file, header);
    WireHand wire(header.device);
    for (int tick = 0; tick < kTicks; ++tick) {
      DeviceInput in = wire(hand(tick), 1);
      if (tick == 0) in.commands = kCommandRestart;
      DeviceTraceRecord record = run.step(in);
      if (!felt) record = {in, {}, 0, 0};
      writer.append(record);
    }
    writer.finish();
    return file;
  }

  ScratchFolder folder_;
};

TEST_F(HandTrace, of_a_device_is_where_the_hand_was) {
  const Trace trace = read_hand(record(true));
  ASSERT_EQ(trace.size(), static_cast<std::size_t>(kTicks));
  EXPECT_EQ(trace.header().model_hash, 0U);
  EXPECT_EQ(trace.header().record_count, static_cast<std::uint64_t>(kTicks));
  int contact = 0;
  for (std::size_t tick = 0; tick < trace.size(); ++tick) {
    const TraceRecord record = trace.record(tick);
    ASSERT_TRUE(trace.chain_follows(tick));
    if (tick < 10) continue;  // before the device counts as homed and its pose is found
    ASSERT_NEAR((real(record.input.hip) - real(hand(static_cast<int>(tick)).hip)).norm(), 0, 0.08) << "a count of each arm";
    contact += (record.output.status & kContact) != 0 ? 1 : 0;
  }
  EXPECT_GT(contact, kTicks / 2);
}

TEST_F(HandTrace, of_a_device_is_scanned) {
  TouchReport report;
  const cloud::OrientedPoints points = touch_points(read_hand(record(true)), {.points = 200}, report);
  EXPECT_GT(points.size(), 100U);
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_NEAR(points.positions[i].norm(), kRadius, 0.1);
    EXPECT_GT(points.normals[i].dot(points.positions[i].normalized()), 0.99);
  }
}

TEST_F(HandTrace, of_positions_is_read_as_it_is) {
  TraceHeader header;
  TraceWriter writer(folder_.path() / "hip.trace", header);
  writer.append({hand(7), {}, 0, 0});
  writer.finish();
  EXPECT_EQ(read_hand(folder_.path() / "hip.trace").record(0).input.hip, hand(7).hip);
}

TEST_F(HandTrace, without_what_was_felt_is_refused) {
  const auto file = record(false);
  try {
    read_hand(file);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("; replay it first with isotouch replay BLOB " + file.string()));
  }
}

}  // namespace
}  // namespace isotouch::evaluate
