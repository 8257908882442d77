/// The order of a boot, request by request, against the whole device.
#include "hil/falcon_model/board.h"

#include <gtest/gtest.h>

#include "tests/hil/falcon_model/driver.h"

namespace isotouch::falcon_model {
namespace {

using driver::boot;
using driver::data_of;
using driver::request;
using driver::send;
using State = Board::State;

SimulatedFalcon falcon_with(const Quirks& quirks) {
  Settings settings;
  settings.quirks = quirks;
  return SimulatedFalcon(settings);
}

/// Up to the locked rate; what came back after the 'A'.
Bytes to_upload(SimulatedFalcon& falcon) {
  driver::firmware_mode(falcon);
  request(falcon, {driver::kDtrLow, driver::kBaudUpload});
  send(falcon, {0x41});
  return falcon.read(512);
}

TEST(Board, BootsInTheOrderOfTheSheetWithItsGoldenBytes) {
  SimulatedFalcon falcon{Settings{}};
  EXPECT_EQ(falcon.read(64), (Bytes{0x01, 0x60}));
  EXPECT_TRUE(request(
      falcon, {driver::kPurge1, driver::kPurge2, driver::kLatency16, driver::kBaud9600, driver::kEightNoneOne, driver::kNoFlowControl}));
  EXPECT_TRUE(request(falcon, {driver::kRtsLow, driver::kDtrLow}));
  EXPECT_EQ(falcon.board().state(), State::kCold);
  EXPECT_TRUE(request(falcon, {driver::kDtrHigh}));
  EXPECT_EQ(falcon.board().state(), State::kPic);
  send(falcon, {0x0A, 0x43, 0x0D});
  EXPECT_EQ(falcon.read(512), (Bytes{0x01, 0x60, 0x0A, 0x44, 0x2C, 0x0D}));
  EXPECT_TRUE(request(falcon, {driver::kDtrLow, driver::kBaudUpload}));
  EXPECT_EQ(falcon.board().state(), State::kCold);
  send(falcon, {0x41});
  EXPECT_EQ(falcon.read(512), (Bytes{0x01, 0x60, 0x41}));
  EXPECT_EQ(falcon.board().state(), State::kUpload);
  EXPECT_TRUE(driver::upload(falcon, driver::image_of({100, 3})));
  EXPECT_EQ(falcon.board().state(), State::kRun);
  driver::run_mode(falcon);
  send(falcon, driver::command({}, false));
  const Bytes reply = falcon.read(64);
  EXPECT_EQ(reply.size(), 18U);
  ASSERT_TRUE(driver::decode(data_of(reply)).has_value());
  EXPECT_EQ(driver::decode(data_of(reply))->homed, 0);
}

TEST(Board, TheFirstUploadEchoIsOneFullPacket) {
  SimulatedFalcon falcon{Settings{}};
  to_upload(falcon);
  const Bytes image = driver::image_of({100});
  const Bytes chunk(image.begin(), image.begin() + 62);
  send(falcon, chunk);
  Bytes expected{0x01, 0x60};
  for (const std::uint8_t byte : chunk) expected.push_back(byte);
  EXPECT_EQ(falcon.read(64), expected);
}

TEST(Board, AColdBoardAnswersNoPacketAndBootsAllTheSame) {
  SimulatedFalcon falcon{Settings{}};
  driver::run_mode(falcon);
  send(falcon, driver::command({}));
  EXPECT_EQ(falcon.read(64), (Bytes{0x01, 0x60}));
  EXPECT_EQ(falcon.packets(), 1U);
  EXPECT_TRUE(boot(falcon));
}

TEST(Board, AColdBoardThatMislocksSpoilsTheUploadUntilDtrRises) {
  SimulatedFalcon falcon = falcon_with({.mislock = true});
  driver::run_mode(falcon);
  send(falcon, driver::command({}));
  EXPECT_EQ(falcon.board().state(), State::kUpload);
  falcon.read(512);
  request(falcon, {driver::kDtrLow, driver::kBaudUpload});
  send(falcon, {0x41});
  EXPECT_NE(data_of(falcon.read(512)), Bytes{0x41});
  EXPECT_TRUE(boot(falcon));
}

TEST(Board, TheHandshakeNeedsItsRateItsFormatAndDtr) {
  for (const driver::Request& wrong : {driver::kBaudUpload, driver::vendor(4, 0x0108), driver::kDtrLow}) {
    SimulatedFalcon falcon{Settings{}};
    driver::firmware_mode(falcon);
    request(falcon, {wrong});
    send(falcon, {0x0A, 0x43, 0x0D});
    EXPECT_NE(data_of(falcon.read(512)), (Bytes{0x0A, 0x44, 0x2C, 0x0D}));
  }
}

TEST(Board, TheSecondHandshakeIsAnsweredToo) {
  SimulatedFalcon falcon = falcon_with({.fail_handshakes = 2});
  driver::firmware_mode(falcon);
  for (const std::size_t size : {2U, 2U, 6U, 6U}) {
    send(falcon, {0x0A, 0x43, 0x0D});
    EXPECT_EQ(falcon.read(512).size(), size);
  }
}

TEST(Board, AnUploadAtTheOtherCommonRateIsAsGood) {
  SimulatedFalcon falcon{Settings{}};
  driver::firmware_mode(falcon);
  request(falcon, {driver::kDtrLow, driver::vendor(3, 0x0015, 1)});
  send(falcon, {0x61});
  EXPECT_EQ(data_of(falcon.read(64)), Bytes{0x61});
  EXPECT_TRUE(driver::upload(falcon, driver::small_image()));
  EXPECT_EQ(falcon.board().state(), State::kRun);
}

TEST(Board, AnUploadWhoseRateChangesIsGarbled) {
  SimulatedFalcon falcon{Settings{}};
  to_upload(falcon);
  request(falcon, {driver::kBaud9600});
  send(falcon, driver::small_image());
  const Bytes transfer = falcon.read(64);
  EXPECT_GT(transfer.size(), 2U);
  EXPECT_EQ(transfer[1] & 0x08, 0x08);  // framing error
  EXPECT_EQ(falcon.board().state(), State::kUpload);
}

TEST(Board, AMalformedImageIsEchoedAndNeverStarts) {
  SimulatedFalcon falcon{Settings{}};
  to_upload(falcon);
  Bytes image = driver::small_image();
  image[1] = 0x09;
  EXPECT_TRUE(driver::upload(falcon, image));
  EXPECT_EQ(falcon.board().state(), State::kUpload);
}

TEST(Board, UploadsThatFailAreEchoedWronglyAndTheNextOneStarts) {
  SimulatedFalcon falcon = falcon_with({.fail_uploads = 2});
  for (int failed = 0; failed < 2; ++failed) {
    to_upload(falcon);
    EXPECT_FALSE(driver::upload(falcon, driver::image_of({200})));
    EXPECT_EQ(falcon.board().state(), State::kUpload);
  }
  to_upload(falcon);
  EXPECT_TRUE(driver::upload(falcon, driver::image_of({200})));
  EXPECT_EQ(falcon.board().state(), State::kRun);
}

TEST(Board, JunkBeforeTheAnswersIsOnOrder) {
  SimulatedFalcon falcon = falcon_with({.leading_zero = true, .stray_13 = true});
  driver::firmware_mode(falcon);
  send(falcon, {0x0A, 0x43, 0x0D});
  EXPECT_EQ(falcon.read(512), (Bytes{0x01, 0x60, 0x00, 0x0A, 0x44, 0x2C, 0x0D}));
  request(falcon, {driver::kDtrLow, driver::kBaudUpload});
  send(falcon, {0x41});
  EXPECT_EQ(data_of(falcon.read(512)), (Bytes{0x13, 0x41}));
}

TEST(Board, AStaleStatusPairIsOnOrder) {
  SimulatedFalcon falcon = falcon_with({.stale_status = true});
  driver::firmware_mode(falcon);
  falcon.read(64);
  request(falcon, {driver::kDtrHigh});
  send(falcon, {0x0A, 0x43, 0x0D});
  EXPECT_EQ(falcon.read(512).size(), 2U);
  EXPECT_EQ(falcon.read(512).size(), 6U);
}

TEST(Board, WithoutWallPowerTheChipAnswersAlone) {
  SimulatedFalcon falcon = falcon_with({.no_wall_power = true});
  EXPECT_FALSE(boot(falcon));
  EXPECT_EQ(falcon.read(64), (Bytes{0x01, 0x60}));
  EXPECT_FALSE(falcon.control(driver::kLatency1).stalled);
}

TEST(Board, DtrRisingEndsTheFirmware) {
  SimulatedFalcon falcon = falcon_with({.firmware_loaded = true});
  driver::run_mode(falcon);
  EXPECT_TRUE(driver::exchange(falcon).has_value());
  request(falcon, {driver::kDtrHigh});
  EXPECT_FALSE(driver::exchange(falcon).has_value());
  EXPECT_TRUE(boot(falcon));
}

TEST(Board, RunningFirmwareHearsOnlyItsOwnRate) {
  SimulatedFalcon falcon = falcon_with({.firmware_loaded = true});
  request(falcon, {driver::kBaudUpload});
  send(falcon, driver::command({}));
  EXPECT_EQ(falcon.packets(), 0U);
  EXPECT_EQ(falcon.read(64)[1] & 0x08, 0x08);
  SimulatedFalcon silent = falcon_with({.silent_on_wrong_rate = true, .firmware_loaded = true});
  request(silent, {driver::kBaudUpload});
  send(silent, driver::command({}));
  EXPECT_EQ(silent.read(64), (Bytes{0x01, 0x60}));
}

}  // namespace
}  // namespace isotouch::falcon_model
