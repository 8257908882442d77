#include "hil/falcon_sim/paced_device.h"

#include <gtest/gtest.h>

#include "tests/hil/falcon_model/driver.h"

namespace isotouch::falcon_sim {
namespace {

using namespace falcon_model;
using namespace std::chrono_literals;

constexpr Time kNoon{std::chrono::hours(12)};

PacedDevice running(Pace pace) { return PacedDevice(driver::running({}), pace); }

TEST(PacedDevice, AReplyComesWithTheFrameThatHasTimeForIt) {
  PacedDevice device = running(Pace::kReal);
  device.write(driver::command({}), kNoon + 10us);
  EXPECT_EQ(device.ready(kNoon + 20us), kNoon + 1ms);
  EXPECT_EQ(device.ready(kNoon + 2300us), kNoon + 3ms);
  device.falcon().read(64);
  device.write(driver::command({}), kNoon + 3900us);  // too late for the next frame
  EXPECT_EQ(device.ready(kNoon + 3950us), kNoon + 5ms);
}

TEST(PacedDevice, WithoutDataTheLatencyTimerAnswers) {
  PacedDevice device = running(Pace::kReal);
  EXPECT_EQ(device.ready(kNoon), kNoon + 1ms);
  device.falcon().control(driver::kLatency16);
  EXPECT_EQ(device.ready(kNoon + 1us), kNoon + 17ms);
}

/// How long ten packets and their replies take, each packet half a millisecond after the reply before it.
Time::duration ten_packets(PacedDevice& device) {
  Time now = kNoon;
  for (int i = 0; i < 10; ++i) {
    device.write(driver::command({}), now + 500us);
    now = device.ready(now + 510us);
    EXPECT_EQ(device.read(64, now + 50us).size(), 18U);  // the event loop is a little late
  }
  return now - kNoon;
}

TEST(PacedDevice, AReplyWaitsForTheLatencyTimer) {
  PacedDevice device = running(Pace::kReal);
  EXPECT_EQ(ten_packets(device), 10ms);
  device.falcon().control(driver::kLatency16);
  device.read(64, kNoon);
  EXPECT_EQ(ten_packets(device), 160ms);  // as a host felt it whose driver left the timer as it was: 62.5 Hz
}

TEST(PacedDevice, AFullPacketDoesNotWaitForTheLatencyTimer) {
  PacedDevice device = running(Pace::kReal);
  device.falcon().control(driver::kLatency16);
  device.read(64, kNoon);
  for (int i = 0; i < 3; ++i) device.write(driver::command({}), kNoon + 10us);
  EXPECT_EQ(device.ready(kNoon + 20us), kNoon + 16ms);  // 48 bytes
  device.write(driver::command({}), kNoon + 30us);
  EXPECT_EQ(device.ready(kNoon + 40us), kNoon + 1ms);  // 64 bytes
}

TEST(PacedDevice, LockstepAnswersAtOnce) {
  PacedDevice device = running(Pace::kLockstep);
  EXPECT_EQ(device.ready(kNoon), kNoon);
  device.write(driver::command({}), kNoon);
  EXPECT_EQ(device.ready(kNoon), kNoon);
}

TEST(PacedDevice, OnlyInRealPaceSilenceEndsATorque) {
  for (const Pace pace : {Pace::kReal, Pace::kLockstep}) {
    PacedDevice device = running(pace);
    device.write(driver::command({-800, -800, -800}), kNoon);
    const Bytes part(3, 'A');
    device.write(part, kNoon + 9ms);
    EXPECT_NE(device.falcon().firmware().commands(), Commands{});
    device.write(part, kNoon + 60ms);
    EXPECT_EQ(device.falcon().firmware().commands() == Commands{}, pace == Pace::kReal);
  }
}

}  // namespace
}  // namespace isotouch::falcon_sim
