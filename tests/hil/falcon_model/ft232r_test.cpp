#include "hil/falcon_model/ft232r.h"

#include <gtest/gtest.h>

#include <string>

#include "tests/hil/falcon_model/driver.h"

namespace isotouch::falcon_model {
namespace {

using driver::Request;
using driver::vendor;

Bytes counted(std::size_t size) {
  Bytes bytes(size);
  for (std::size_t i = 0; i < size; ++i) bytes[i] = static_cast<std::uint8_t>(i);
  return bytes;
}

TEST(Ft232r, SetupBytesAreThoseOfTheSheet) {
  EXPECT_EQ(driver::kBaud9600, (Request{0x40, 0x03, 0x38, 0x41, 0, 0, 0, 0}));
  EXPECT_EQ(driver::kDtrHigh, (Request{0x40, 0x01, 0x01, 0x01, 0, 0, 0, 0}));
  EXPECT_EQ(driver::kLatency16, (Request{0x40, 0x09, 0x10, 0, 0, 0, 0, 0}));
}

TEST(Ft232r, TakesEveryRequestOfTheSheet) {
  Ft232r chip{{}};
  for (const Request& setup : {vendor(0, 0), driver::kPurge1, driver::kPurge2, driver::kRtsLow, driver::kDtrLow, driver::kDtrHigh,
                               driver::kNoFlowControl, driver::kBaud9600, driver::kBaudUpload, driver::kBaudRun, driver::kEightNoneOne,
                               driver::kLatency16, driver::kLatency1, vendor(6, 0x13E), vendor(7, 0), vendor(0x0B, 0)}) {
    EXPECT_EQ(chip.control(setup), (ControlAnswer{false, {}}));
  }
  EXPECT_EQ(chip.control(Request{0xC0, 5, 0, 0, 0, 0, 2, 0}).data, (Bytes{0x01, 0x60}));
  EXPECT_EQ(chip.control(Request{0xC0, 0x0A, 0, 0, 0, 0, 1, 0}).data, Bytes{1});
  EXPECT_TRUE(chip.control(vendor(0x77, 0)).stalled);
  EXPECT_TRUE(chip.control(Request{0xC0, 0x77, 0, 0, 0, 0, 1, 0}).stalled);
  EXPECT_TRUE(chip.control(Request{0x21, 0, 0, 0, 0, 0, 0, 0}).stalled);
}

TEST(Ft232r, RequestsSetTheLine) {
  Ft232r chip{{}};
  chip.control(driver::kDtrHigh);
  chip.control(vendor(1, 0x0202));
  chip.control(driver::kBaudRun);
  EXPECT_TRUE(chip.line().dtr && chip.line().rts && chip.line().eight_none_one);
  EXPECT_EQ(chip.line().rate, 1.5e6);
  chip.control(vendor(1, 0x0200));
  EXPECT_TRUE(chip.line().dtr);  // only the masked line changes
  EXPECT_FALSE(chip.line().rts);
  chip.control(vendor(4, 0x0108));
  EXPECT_FALSE(chip.line().eight_none_one);
  chip.control(vendor(0, 0));
  EXPECT_FALSE(chip.line().dtr);
  EXPECT_EQ(chip.line().rate, 1.5e6);
}

TEST(Ft232r, SaysWhatItIs) {
  Ft232r chip{{"FTDI", "FALCON HAPTIC", "12PZ657E"}};
  const auto descriptor = [&](unsigned type, unsigned number, std::uint8_t length) {
    return chip.control(Request{0x80, 6, static_cast<std::uint8_t>(number), static_cast<std::uint8_t>(type), 0, 0, length, 0}).data;
  };
  EXPECT_EQ(descriptor(1, 0, 18), (Bytes{18, 1, 0, 2, 0, 0, 0, 8, 0x03, 0x04, 0x48, 0xCB, 0x00, 0x06, 1, 2, 3, 1}));
  EXPECT_EQ(descriptor(1, 0, 8).size(), 8U);
  const Bytes configuration = descriptor(2, 0, 255);
  ASSERT_EQ(configuration.size(), 32U);
  EXPECT_EQ(configuration[7], 0xA0);
  EXPECT_EQ(configuration[8], 45);
  EXPECT_EQ(configuration[20], 0x81);
  EXPECT_EQ(configuration[27], 0x02);
  std::string serial;
  const Bytes third = descriptor(3, 3, 255);
  ASSERT_EQ(third.size(), 18U);
  for (std::size_t i = 2; i < third.size(); i += 2) serial += static_cast<char>(third[i]);
  EXPECT_EQ(serial, "12PZ657E");
  EXPECT_TRUE(chip.control(Request{0x80, 6, 9, 3, 0, 0, 255, 0}).stalled);
}

TEST(Ft232r, ItsMemoryHoldsItsNumbersAndTheirChecksum) {
  Ft232r chip{{}};
  const auto word = [&](unsigned at) {
    const Bytes two = chip.control(Request{0xC0, 0x90, 0, 0, static_cast<std::uint8_t>(at), 0, 2, 0}).data;
    return static_cast<unsigned>(two.at(0) | two.at(1) << 8);
  };
  EXPECT_EQ(word(1), 0x0403U);
  EXPECT_EQ(word(2), 0xCB48U);
  unsigned checksum = 0xAAAA;
  for (unsigned i = 0; i < 63; ++i) {
    checksum ^= word(i);
    checksum = (checksum << 1 | checksum >> 15) & 0xFFFF;
  }
  EXPECT_EQ(word(63), checksum);
}

TEST(Ft232r, EveryUsbPacketBeginsWithTheStatusPair) {
  Ft232r chip{{}};
  chip.receive(counted(100));
  const Bytes transfer = chip.read(512);
  ASSERT_EQ(transfer.size(), 104U);  // 64 and 40
  for (const std::size_t at : {0U, 64U}) {
    EXPECT_EQ(transfer[at], 0x01);
    EXPECT_EQ(transfer[at + 1], 0x60);
  }
  EXPECT_EQ(driver::data_of(transfer), counted(100));
  EXPECT_EQ(chip.read(512), (Bytes{0x01, 0x60}));
}

TEST(Ft232r, ATransferEndsFullOrWithAShortPacket) {
  Ft232r chip{{}};
  chip.receive(counted(62));
  EXPECT_EQ(chip.read(64).size(), 64U);
  chip.receive(counted(62));
  EXPECT_EQ(chip.read(512).size(), 66U);  // the latency timer ends it with a bare pair
  chip.receive(counted(200));
  EXPECT_EQ(chip.read(128).size(), 128U);
  EXPECT_EQ(driver::data_of(chip.read(128)).size(), 76U);
}

TEST(Ft232r, WhatDoesNotFitIsLostAndReported) {
  Ft232r chip{{}};
  chip.receive(counted(300));
  const Bytes transfer = chip.read(512);
  EXPECT_EQ(driver::data_of(transfer), counted(256));
  EXPECT_EQ(transfer[1], 0x62);
  EXPECT_EQ(transfer[65], 0x60);  // reported once
}

TEST(Ft232r, AWrongRateGivesGarbageWithFramingErrors) {
  Ft232r chip{{}};
  chip.receive_garbled(counted(3));
  const Bytes transfer = chip.read(64);
  ASSERT_EQ(transfer.size(), 5U);
  EXPECT_EQ(transfer[1], 0xE8);
  EXPECT_NE(driver::data_of(transfer), counted(3));
}

TEST(Ft232r, APurgeForgetsWhatWaitsForTheHost) {
  Ft232r chip{{}};
  chip.receive(counted(10));
  chip.control(driver::kPurge1);
  EXPECT_FALSE(chip.empty());
  chip.control(driver::kPurge2);
  EXPECT_TRUE(chip.empty());
}

}  // namespace
}  // namespace isotouch::falcon_model
