/// A device's recording, scanned: its outputs say where the hand was.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "host/cloud/random.h"
#include "host/error.h"
#include "host/evaluate/shape_trial.h"
#include "host/evaluate/touch_points.h"
#include "host/motion/device_in_hand.h"
#include "host/to_double.h"
#include "host/trace/replay.h"
#include "tests/support/scratch_folder.h"

namespace isotouch::evaluate {
namespace {

constexpr int kTicks = 6000;
constexpr double kRadius = 80 * kTrialVoxel;

/// A sphere, and a device that a hand leads round it 1 mm below the surface, as its packets.
class DeviceScan : public testing::Test {
 protected:
  const field_file::OpenField& sphere() {
    static const field_file::OpenField field = trial_field(shape_trial("sphere"), Method::kDefault);
    return field;
  }
  static Input hand(int tick) {
    const double angle = tick * 0.004, z = 15 * std::sin(tick * 0.0007), depth = tick < 500 ? -5 + tick * 0.012 : 1;
    const double radius = std::sqrt((kRadius - depth) * (kRadius - depth) - z * z);
    return position_input(to_fixed<Mm>(Eigen::Vector3d(radius * std::cos(angle), radius * std::sin(angle), z)));
  }
  /// returns   the file; with outputs when `felt`
  std::filesystem::path record(bool felt) {
    const auto file = folder_.path() / "device.trace";
    TraceHeader header;
    header.device = libnifalcon_model();
    header.settings.stiffness = Stiffness::of(0.5);
    trace::Run run(sphere().view, header);
    if (felt) header = run.header();
    trace::TraceWriter writer(file, header);
    motion::DeviceInHand device(header.device);
    for (int tick = 0; tick < kTicks; ++tick) {
      Input in = device(hand(tick));
      if (tick == 0) in.requests = kRequestRestart;
      TraceRecord record = run.step(in);
      if (!felt) record = {in, {}, 0, 0};
      writer.append(record);
    }
    writer.finish();
    return file;
  }

  ScratchFolder folder_;
};

TEST_F(DeviceScan, TheRecordingSaysWhereTheHandWas) {
  const trace::Trace trace = trace::read_trace(record(true));
  ASSERT_EQ(trace.size(), static_cast<std::size_t>(kTicks));
  EXPECT_EQ(trace.header().record_count, static_cast<std::uint64_t>(kTicks));
  int contact = 0;
  for (std::size_t tick = 0; tick < trace.size(); ++tick) {
    const TraceRecord record = trace.record(tick);
    ASSERT_TRUE(trace.chain_follows(tick));
    if (tick < 10) continue;  // before the device counts as homed and its pose is found
    ASSERT_NEAR((to_double(record.output.hip) - to_double(hand(static_cast<int>(tick)).hip)).norm(), 0, 0.08) << "a count of each arm";
    contact += (record.output.status & kContact) != 0 ? 1 : 0;
  }
  EXPECT_GT(contact, kTicks / 2);
}

TEST_F(DeviceScan, ThePointsLieOnTheSurface) {
  TouchReport report;
  const cloud::OrientedPoints points = touch_points(trace::read_trace(record(true)), {.points = 200}, report);
  EXPECT_GT(points.size(), 100U);
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_NEAR(points.positions[i].norm(), kRadius, 0.1);
    EXPECT_GT(points.normals[i].dot(points.positions[i].normalized()), 0.99);
  }
}

TEST_F(DeviceScan, PacketsWithoutForcesAreRefused) {
  TouchReport report;
  try {
    touch_points(trace::read_trace(record(false)), {}, report);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("holds no forces; record them with isotouch replay"));
  }
}

}  // namespace
}  // namespace isotouch::evaluate
