#include "firmware/falcon/falcon_usb.h"

#include <gtest/gtest.h>
#include <libusb.h>

#include <algorithm>
#include <string>
#include <vector>

#include "firmware/falcon/falcon_session.h"
#include "firmware/falcon/ft232.h"
#include "tests/firmware/falcon/fake_libusb.h"

namespace isotouch::falcon {
namespace {

using test::Bytes;
using test::fake_bus;
using test::FakeClock;
using test::FakeFalcon;
using test::kImage;

/// A bus with one Falcon on it.
struct Desk {
  FakeClock clock;
  FakeFalcon falcon{clock}, other{clock};

  Desk() {
    fake_bus() = {};
    fake_bus().clock = &clock;
    fake_bus().least_pending_in = 100;
    fake_bus().devices = {{&falcon}};
  }
  /// Nothing of libusb is left behind.
  ~Desk() {
    EXPECT_EQ(fake_bus().contexts, 0);
    EXPECT_EQ(fake_bus().handles, 0);
    EXPECT_EQ(fake_bus().claimed, 0);
    EXPECT_EQ(fake_bus().transfers, 0);
    EXPECT_EQ(fake_bus().lists, 0);
  }
};

/// The Falcon is open.
struct OpenDesk : Desk {
  FalconUsb link{clock};
  Bytes buffer = Bytes(64);

  OpenDesk() { EXPECT_TRUE(link.open()); }
};

TEST(FalconUsb, OpensTheDeviceAndGivesItBack) {
  Desk desk;
  FalconUsb link(desk.clock);
  ASSERT_TRUE(link.open());
  EXPECT_TRUE(link.is_open());
  EXPECT_EQ(link.identity().name, "FALCON HAPTIC");
  EXPECT_EQ(link.identity().serial, "FAKE0001");
  EXPECT_EQ(fake_bus().claimed, 1);
  EXPECT_EQ(fake_bus().detaches, 1);
  ASSERT_TRUE(link.open()) << "again";
  link.close();
  EXPECT_EQ(fake_bus().cancelled, 16) << "eight transfers were pending, twice";
  EXPECT_FALSE(link.is_open());
  link.close();
}

TEST(FalconUsb, ChoosesBySerialPastOtherDevices) {
  Desk desk;
  FakeFalcon keyboard(desk.clock);
  fake_bus().devices = {{&keyboard}, {&desk.falcon}, {&desk.other}};
  fake_bus().devices[0].product = 0x6001;
  fake_bus().devices[2].serial = "FAKE0002";
  FalconUsb any(desk.clock), second(desk.clock, "FAKE0002"), third(desk.clock, "FAKE0003");
  ASSERT_TRUE(any.open());
  EXPECT_EQ(any.identity().serial, "FAKE0001");
  any.close();
  ASSERT_TRUE(second.open());
  EXPECT_EQ(second.identity().serial, "FAKE0002");
  second.close();
  EXPECT_EQ(third.open().error(), LinkError::kNotFound);
  EXPECT_FALSE(keyboard.is_open());
}

TEST(FalconUsb, TakesAnotherWhenTheFirstIsHeldAndElseSaysWhy) {
  Desk desk;
  fake_bus().devices = {{&desk.falcon}, {&desk.other}};
  fake_bus().devices[0].claim_error = LIBUSB_ERROR_BUSY;
  FalconUsb link(desk.clock);
  ASSERT_TRUE(link.open());
  link.close();
  fake_bus().devices.pop_back();
  EXPECT_EQ(link.open().error(), LinkError::kBusy);
  fake_bus().devices[0].open_error = LIBUSB_ERROR_ACCESS;
  EXPECT_EQ(link.open().error(), LinkError::kNotAllowed);
  fake_bus().devices = {{&desk.falcon}};
  fake_bus().devices[0].packet_size = 512;
  EXPECT_EQ(link.open().error(), LinkError::kUnsuitable);
  desk.falcon.faults.present = false;
  EXPECT_NE(link.open().error(), LinkError::kUnsuitable);
  fake_bus().init_error = LIBUSB_ERROR_OTHER;
  EXPECT_EQ(link.open().error(), LinkError::kNoUsb);
}

TEST(FalconUsb, CarriesABootAndAThousandExchangesWithAllTransfersPending) {
  Desk desk;
  {
    FalconUsb link(desk.clock);
    FalconSession session(link, desk.clock, kImage);
    for (int i = 0; i < 2; ++i) session.step({});
    ASSERT_EQ(session.state(), SessionState::kRunning) << explain(session.last_boot());
    EXPECT_EQ(session.last_boot().outcome, BootOutcome::kLoaded);
    EXPECT_EQ(desk.falcon.uploaded, Bytes(kImage.begin(), kImage.end()));
    for (std::int16_t i = 0; i < 1000; ++i) {
      desk.falcon.reply.counts = {i, 2, 3};
      EXPECT_EQ(session.step({{i, 0, 0}}).reply.counts[0], i);
      EXPECT_EQ(desk.falcon.commands.back().words[0], i);
    }
    EXPECT_EQ(session.counts().timeouts, 0U);
    EXPECT_EQ(fake_bus().least_pending_in, 8) << "whatever was read is submitted again before the next wait";
  }
  for (std::size_t i = 1; i <= 3; ++i) EXPECT_EQ(desk.falcon.commands[desk.falcon.commands.size() - i], FalconCommand{});
}

TEST(FalconUsb, KeepsTheOrderOfBytesWhenManyPacketsWait) {
  OpenDesk desk;
  desk.falcon.faults.byte_by_byte = true;
  desk.falcon.faults.empty_packets = false;
  Bytes sent;
  for (int i = 0; i < 100; ++i) sent.push_back(static_cast<std::uint8_t>(i));
  desk.falcon.send(sent);
  Bytes got;
  while (got.size() < sent.size()) {
    const LinkResult<std::size_t> size = desk.link.read(desk.buffer, 5);
    ASSERT_TRUE(size);
    ASSERT_EQ(*size, 3U);
    got.push_back(desk.buffer[2]);
  }
  EXPECT_EQ(got, sent);
}

TEST(FalconUsb, AReadWithoutDataEndsInTime) {
  OpenDesk desk;
  desk.falcon.faults.empty_packets = false;
  for (const std::uint32_t timeout : {0U, 1U, 20U}) {
    const std::int64_t began = desk.clock.now;
    EXPECT_EQ(desk.link.read(desk.buffer, timeout).error(), LinkError::kTimedOut);
    EXPECT_EQ(desk.clock.now - began, std::int64_t{timeout} * 1'000'000);
  }
}

TEST(FalconUsb, AnUnplugIsSeenByEveryCallAndAReplugIsANewOpening) {
  for (const int call : {0, 1, 2}) {
    OpenDesk desk;
    desk.falcon.faults.present = false;
    if (call < 2) {
      EXPECT_EQ((call == 0 ? desk.link.control(ft232::kPurge1, {}) : desk.link.write(desk.buffer, 5)).error(), LinkError::kGone);
    }
    EXPECT_EQ(desk.link.read(desk.buffer, 5).error(), LinkError::kGone);
    EXPECT_EQ(desk.link.read(desk.buffer, 0).error(), LinkError::kGone);
    desk.link.close();
    EXPECT_FALSE(desk.link.open());
    desk.falcon.faults.present = true;
    EXPECT_TRUE(desk.link.open());
    EXPECT_TRUE(desk.link.control(ft232::kPurge1, {}));
  }
}

TEST(FalconUsb, StallsAndDisturbedTransfersAreOvercome) {
  OpenDesk desk;
  desk.falcon.faults.empty_packets = false;
  fake_bus().line_errors = 20;
  desk.falcon.send({1});
  EXPECT_EQ(desk.link.read(desk.buffer, 50).value(), 3U);
  fake_bus().stall_in = 1;
  EXPECT_EQ(desk.link.read(desk.buffer, 50).error(), LinkError::kStalled);
  desk.falcon.send({2});
  EXPECT_EQ(desk.link.read(desk.buffer, 50).value(), 3U);
  fake_bus().stall_out = 1;
  EXPECT_TRUE(desk.link.write(desk.buffer, 5));
  EXPECT_EQ(desk.link.read(desk.buffer, 5).error(), LinkError::kTimedOut);
  EXPECT_EQ(desk.link.write(desk.buffer, 5).error(), LinkError::kStalled);
  EXPECT_TRUE(desk.link.write(desk.buffer, 5));
  EXPECT_EQ(fake_bus().clear_halts, 2);
  fake_bus().line_errors = 1000;
  EXPECT_EQ(desk.link.read(desk.buffer, 500).error(), LinkError::kGone) << "nothing but errors";
}

TEST(FalconUsb, ErrorsWithGoodTransfersBetweenThemDoNotAddUp) {
  OpenDesk desk;
  desk.falcon.faults.empty_packets = false;
  for (int i = 0; i < 10; ++i) {
    fake_bus().line_errors = 20;
    desk.falcon.send({1});
    const LinkResult<std::size_t> size = desk.link.read(desk.buffer, 50);
    ASSERT_TRUE(size) << i;
    EXPECT_EQ(*size, 3U);
  }
}

TEST(FalconUsb, SeveralWritesAreOnTheirWayAtOnce) {
  OpenDesk desk;
  Bytes data(1000, 0x55);
  EXPECT_EQ(desk.link.write(data, 0).value(), 512U);
  for (int i = 0; i < 3; ++i) EXPECT_TRUE(desk.link.write(data, 0));
  EXPECT_TRUE(desk.falcon.log.back() == "open") << "nothing has been sent yet";
  EXPECT_TRUE(desk.link.write(data, 5)) << "waits for a free one";
  desk.link.close();
  EXPECT_EQ(std::count_if(desk.falcon.log.begin(), desk.falcon.log.end(), [](const std::string& line) { return line[0] == '>'; }), 5);
}

TEST(FalconUsb, ClosedItIsGone) {
  Desk desk;
  FalconUsb link(desk.clock);
  Bytes buffer(64);
  EXPECT_EQ(link.control(ft232::kPurge1, {}).error(), LinkError::kGone);
  EXPECT_EQ(link.write(buffer, 1).error(), LinkError::kGone);
  EXPECT_EQ(link.read(buffer, 1).error(), LinkError::kGone);
}

}  // namespace
}  // namespace isotouch::falcon
