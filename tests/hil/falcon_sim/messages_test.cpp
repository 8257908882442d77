#include "hil/falcon_sim/messages.h"

#include <gtest/gtest.h>

#include <string>

#include "tests/hil/falcon_model/driver.h"

namespace isotouch::falcon_sim {
namespace {

using namespace falcon_model;

Bytes ask(PacedDevice& device, const Bytes& message) { return answer(message, device, Time{}); }

TEST(Messages, DescribeTheDevice) {
  Settings settings;
  settings.strings.serial = "12PZ657E";
  PacedDevice device(SimulatedFalcon(settings), Pace::kLockstep);
  const Bytes bytes = ask(device, {'D'});
  ASSERT_EQ(bytes.size(), 1U + 18 + 5 + 14 + 9);
  EXPECT_EQ(bytes[0], 'd');
  EXPECT_EQ(Bytes(bytes.begin() + 1, bytes.begin() + 19), device_descriptor());
  EXPECT_EQ(std::string(bytes.begin() + 19, bytes.end()),
            "\x04"
            "FTDI"
            "\x0D"
            "FALCON HAPTIC"
            "\x08"
            "12PZ657E");
}

TEST(Messages, ControlRequestsComeBackWithStatusAndData) {
  PacedDevice device(SimulatedFalcon({}), Pace::kLockstep);
  EXPECT_EQ(ask(device, {'C', 0x40, 9, 5, 0, 0, 0, 0, 0}), (Bytes{'c', 0}));
  EXPECT_EQ(ask(device, {'C', 0xC0, 0x0A, 0, 0, 0, 0, 1, 0}), (Bytes{'c', 0, 5}));
  EXPECT_EQ(ask(device, {'C', 0x40, 0x77, 0, 0, 0, 0, 0, 0}), (Bytes{'c', 1}));
}

TEST(Messages, BytesOutAreCountedAndAReadIsRead) {
  PacedDevice device(driver::running({}), Pace::kLockstep);
  Bytes out = driver::command({});
  out.insert(out.begin(), 'O');
  EXPECT_EQ(ask(device, out), (Bytes{'o', 0, 16, 0}));
  const auto read = parse_read(Bytes{'I', 0x80, 0x02, 10, 0, 1, 0});
  ASSERT_TRUE(read.has_value());
  EXPECT_EQ(read->capacity, 640U);
  EXPECT_EQ(read->timeout_ms, 65546U);
  EXPECT_EQ(read_answer(kOk, device.falcon().read(read->capacity)).size(), 20U);
}

TEST(Messages, AnUnpluggedDeviceSaysSo) {
  Settings settings;
  settings.faults = {{0, FaultKind::kUnplug, {}}};
  PacedDevice device(SimulatedFalcon(settings), Pace::kLockstep);
  EXPECT_EQ(ask(device, {'O', 'A'}), (Bytes{'o', 3, 0, 0}));
  EXPECT_EQ(ask(device, {'C', 0x40, 9, 5, 0, 0, 0, 0, 0}), (Bytes{'c', 1}));
  EXPECT_TRUE(says_gone({'o', 3, 0, 0}) && says_gone({'i', 3}));
  EXPECT_FALSE(says_gone({'i', 0, 3}) || says_gone({'c', 3}) || says_gone({'d'}));
}

TEST(Messages, WhatIsNoRequestHasNoAnswer) {
  PacedDevice device(SimulatedFalcon({}), Pace::kLockstep);
  for (const Bytes& message : {Bytes{}, Bytes{'X'}, Bytes{'D', 0}, Bytes{'C', 1, 2}, Bytes{'O'}, Bytes(4098, 'O'), Bytes{'I', 64, 0}}) {
    EXPECT_TRUE(ask(device, message).empty());
  }
  EXPECT_FALSE(parse_read(Bytes{'I', 65, 0, 0, 0, 0, 0}).has_value());
  EXPECT_FALSE(parse_read(Bytes{'I', 0, 0, 0, 0, 0, 0}).has_value());
}

}  // namespace
}  // namespace isotouch::falcon_sim
