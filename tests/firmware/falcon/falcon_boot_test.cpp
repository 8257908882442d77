#include "firmware/falcon/falcon_boot.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

#include "tests/firmware/falcon/fake_falcon.h"
#include "tests/support/random.h"

namespace isotouch::falcon {
namespace {

using test::Bytes;
using test::FakeClock;
using test::FakeFalcon;
using testing::HasSubstr;

/// A legal image of several pieces: one block of `words` random words.
Bytes image_of(std::size_t words) {
  const auto smallest = synthetic_image();
  Bytes image(smallest.begin(), smallest.begin() + 22);
  for (const std::size_t byte : {words & 0xFFU, words >> 8, std::size_t{0x3F}, std::size_t{0}, std::size_t{2}, std::size_t{0x80}}) {
    image.push_back(static_cast<std::uint8_t>(byte));
  }
  test::Random random(7);
  for (std::size_t i = 0; i < 2 * words; ++i) image.push_back(static_cast<std::uint8_t>(random.bits()));
  image.insert(image.end(), {0, 0});
  return image;
}

/// A cold Falcon on an open link.
struct Desk {
  FakeClock clock;
  FakeFalcon falcon{clock};
  Bytes image = image_of(80);  // 190 bytes: 3 pieces of 62 and one of 4
  BootSettings settings;

  Desk() {
    EXPECT_TRUE(falcon.open());
    falcon.log.clear();
  }
  BootReport run(const BootWatch& watch = {}) { return boot(falcon, clock, image, settings, watch); }
};

const std::vector<std::string> kPurges = {"40 00 01 00 00 00 00 00", "40 00 02 00 00 00 00 00"};
const std::string kLatency1 = "40 09 01 00 00 00 00 00", kBaudRun = "40 03 02 00 00 00 00 00";
const std::string kProbe = "> 3c 41 41 41 41 41 41 41 41 41 41 41 41 4a 41 3e",
                  kOtherProbe = "> 3c 41 41 41 41 41 41 41 41 41 41 41 41 4c 41 3e";

std::vector<std::string> joined(std::initializer_list<std::vector<std::string>> parts) {
  std::vector<std::string> all;
  for (const std::vector<std::string>& part : parts) all.insert(all.end(), part.begin(), part.end());
  return all;
}

std::vector<std::string> normal_mode() { return joined({{kLatency1, kBaudRun}, kPurges}); }

TEST(FalconBoot, SendsEveryRequestInItsOrder) {
  Desk desk;
  const BootReport report = desk.run();
  EXPECT_EQ(report.outcome, BootOutcome::kLoaded) << explain(report);
  const std::vector<std::string> firmware_mode = {"40 09 10 00 00 00 00 00",
                                                  "40 03 38 41 00 00 00 00",
                                                  "40 04 08 00 00 00 00 00",
                                                  "40 02 00 00 00 00 00 00",
                                                  "40 01 00 02 00 00 00 00",
                                                  "40 01 00 01 00 00 00 00",
                                                  "40 01 01 01 00 00 00 00",
                                                  "> 0a 43 0d",
                                                  "40 01 00 01 00 00 00 00",
                                                  "40 03 15 00 00 00 00 00",
                                                  "> 41"};
  std::vector<std::string> pieces;
  for (std::size_t at = 0; at < desk.image.size(); at += 62) {
    pieces.push_back("> " + test::hex(std::span(desk.image).subspan(at, std::min<std::size_t>(62, desk.image.size() - at))));
  }
  ASSERT_EQ(pieces.size(), 4U);
  std::vector<std::string> probes;
  for (int i = 0; i < 5; ++i) probes.insert(probes.end(), {kProbe, kOtherProbe});
  EXPECT_EQ(desk.falcon.log, joined({kPurges, normal_mode(), probes, kPurges, firmware_mode, pieces, normal_mode(), kPurges, {kProbe}}));
  EXPECT_EQ(desk.falcon.uploaded, desk.image);
  EXPECT_EQ(report.attempts, 1);
  EXPECT_EQ(report.stray_bytes, 0U);
}

TEST(FalconBoot, LeavesRunningFirmwareAlone) {
  Desk desk;
  desk.falcon.running = true;
  EXPECT_EQ(desk.run().outcome, BootOutcome::kAlreadyRunning);
  EXPECT_EQ(desk.falcon.log, joined({kPurges, normal_mode(), {kProbe}}));
  desk.image.clear();
  EXPECT_EQ(desk.run().outcome, BootOutcome::kAlreadyRunning);
}

TEST(FalconBoot, TakesNoEchoForAReply) {
  Desk desk;
  desk.falcon.faults.echoes_packets = true;
  EXPECT_EQ(desk.run().outcome, BootOutcome::kLoaded);
}

TEST(FalconBoot, AReplyThatLooksLikeAnEchoIsAReplyTheSecondTime) {
  Desk desk;
  desk.falcon.running = true;
  desk.falcon.reply.buttons = 9;
  EXPECT_EQ(desk.run().outcome, BootOutcome::kAlreadyRunning);
  EXPECT_EQ(desk.falcon.log, joined({kPurges, normal_mode(), {kProbe, kOtherProbe}}));
}

TEST(FalconBoot, LoadsRunningFirmwareAnewWhenAsked) {
  Desk desk;
  desk.falcon.running = true;
  desk.settings.always_upload = true;
  EXPECT_EQ(desk.run().outcome, BootOutcome::kLoaded);
  EXPECT_EQ(desk.falcon.uploaded, desk.image);
}

TEST(FalconBoot, SendsNothingOfABadImage) {
  Desk desk;
  desk.image[1] = 9;
  const BootReport report = desk.run();
  EXPECT_EQ(report.outcome, BootOutcome::kBadImage);
  EXPECT_TRUE(desk.falcon.log.empty());
  EXPECT_THAT(explain(report), HasSubstr("AA 08"));
}

TEST(FalconBoot, AsksForAnImageWhenNoFirmwareAnswers) {
  Desk desk;
  desk.image.clear();
  const BootReport report = desk.run();
  EXPECT_EQ(report.outcome, BootOutcome::kNoImage);
  EXPECT_THAT(explain(report), HasSubstr("no firmware file was given"));
}

TEST(FalconBoot, LoadsPastStrayBytes) {
  struct Variant {
    const char* name;
    test::Faults faults;
    std::size_t stray;
  };
  std::vector<Variant> variants(6);
  variants[0] = {"zero before the answer", {}, 1};
  variants[0].faults.before_answer = {0x00};
  variants[1] = {"13 before the A", {}, 1};
  variants[1].faults.before_autobaud = {0x13};
  variants[2] = {"13 before the first echo", {}, 1};
  variants[2].faults.before_first_echo = {0x13};
  variants[3] = {"a second answer comes late", {}, 4};
  variants[3].faults.after_handshake = {0x0A, 0x44, 0x2C, 0x0D};
  variants[4] = {"everything in packets of one byte", {}, 3};
  variants[4].faults.before_answer = {0x00, 0x0A, 0x44};
  variants[4].faults.byte_by_byte = true;
  variants[5] = {"no empty packets, pieces taken by five bytes", {}, 0};
  variants[5].faults.empty_packets = false;
  variants[5].faults.short_writes = true;
  for (const Variant& variant : variants) {
    Desk desk;
    desk.falcon.faults = variant.faults;
    // Bytes taken five at a time are echoed five at a time, an A of its own among them: the fake locks on the first write.
    const BootReport report = desk.run();
    EXPECT_EQ(report.outcome, BootOutcome::kLoaded) << variant.name << ": " << explain(report);
    EXPECT_EQ(report.attempts, 1) << variant.name;
    EXPECT_EQ(report.stray_bytes, variant.stray) << variant.name;
    EXPECT_EQ(desk.falcon.uploaded, desk.image) << variant.name;
  }
}

TEST(FalconBoot, AsksAgainForALostAnswer) {
  Desk desk;
  desk.falcon.faults.mute_handshakes = 4;
  EXPECT_EQ(desk.run().attempts, 1);
  EXPECT_EQ(std::count(desk.falcon.log.begin(), desk.falcon.log.end(), "> 0a 43 0d"), 5);
}

TEST(FalconBoot, TriesAgainAndOpensAnewAfterEveryThird) {
  for (const int failures : {1, 2, 3, 6, 9}) {
    for (const int kind : {0, 1, 2}) {
      Desk desk;
      (kind == 0   ? desk.falcon.faults.mute_attempts
       : kind == 1 ? desk.falcon.faults.lost_autobauds
                   : desk.falcon.faults.wrong_echoes) = failures;
      const BootReport report = desk.run();
      EXPECT_EQ(report.outcome, BootOutcome::kLoaded) << explain(report);
      EXPECT_EQ(report.attempts, failures + 1);
      EXPECT_EQ(std::count(desk.falcon.log.begin(), desk.falcon.log.end(), "open"), failures / 3);
      EXPECT_EQ(std::count(desk.falcon.log.begin(), desk.falcon.log.end(), "close"), failures / 3);
      EXPECT_EQ(report.bad_echoes, kind == 2 ? static_cast<std::size_t>(failures) : 0U);
    }
  }
}

TEST(FalconBoot, SaysAfterAllAttemptsWhereTheyEnded) {
  struct Case {
    test::Faults faults;
    BootOutcome outcome;
    const char* says;
  };
  std::vector<Case> cases(4);
  cases[0] = {{}, BootOutcome::kNoHandshake, "no wall power?"};
  cases[0].faults.wall_power = false;
  cases[1] = {{}, BootOutcome::kNoAutobaud, "boot loader"};
  cases[1].faults.lost_autobauds = 1000;
  cases[2] = {{}, BootOutcome::kEchoDiffers, "echoes its firmware wrongly"};
  cases[2].faults.wrong_echoes = 1000;
  cases[3] = {{}, BootOutcome::kSilent, "does not answer"};
  cases[3].faults.mute_firmware = true;
  for (const Case& c : cases) {
    Desk desk;
    desk.falcon.faults = c.faults;
    const std::int64_t began = desk.clock.now;
    const BootReport report = desk.run();
    EXPECT_EQ(report.outcome, c.outcome) << explain(report);
    EXPECT_THAT(explain(report), HasSubstr(c.says));
    EXPECT_THAT(explain(report), HasSubstr("after 10 attempts"));
    EXPECT_EQ(report.attempts, 10);
    EXPECT_EQ(std::count(desk.falcon.log.begin(), desk.falcon.log.end(), "open"), 3);
    EXPECT_LT(desk.clock.now - began, 15'000'000'000);
  }
}

TEST(FalconBoot, GoesOnPastAWrongEchoWhenItIsIgnored) {
  Desk desk;
  desk.settings.ignore_echo = true;
  desk.falcon.faults.wrong_echoes = 3;
  const BootReport report = desk.run();
  EXPECT_EQ(report.outcome, BootOutcome::kLoaded);
  EXPECT_EQ(report.attempts, 1);
  EXPECT_EQ(report.bad_echoes, 3U);
  EXPECT_EQ(desk.falcon.uploaded, desk.image);
}

TEST(FalconBoot, TakesARefusedRequestForAFailedAttempt) {
  Desk desk;
  const BootReport report = desk.run([&](const BootProgress& progress) {
    if (progress.attempt == 1 && progress.stage == BootStage::kAutobaud) desk.falcon.faults.stall_controls = 1;
    return true;
  });
  EXPECT_EQ(report.outcome, BootOutcome::kLoaded) << explain(report);
  EXPECT_EQ(report.attempts, 2);
  EXPECT_EQ(std::count(desk.falcon.log.begin(), desk.falcon.log.end(), "open"), 1);
}

TEST(FalconBoot, EndsAtOnceWhenTheDeviceIsUnpluggedAtAnyStage) {
  int stages = 0;
  for (const BootStage stage : {BootStage::kProbe, BootStage::kHandshake, BootStage::kAutobaud, BootStage::kUpload, BootStage::kStart}) {
    Desk desk;
    const BootReport report = desk.run([&](const BootProgress& progress) {
      if (progress.stage == stage) desk.falcon.faults.present = false;
      return true;
    });
    EXPECT_EQ(report.outcome, BootOutcome::kLinkFailed) << name(stage);
    EXPECT_EQ(report.error, LinkError::kGone) << name(stage);
    EXPECT_LE(report.attempts, 1);
    ++stages;
  }
  EXPECT_EQ(stages, 5);
}

TEST(FalconBoot, TellsEveryStepAndStopsWhenTold) {
  Desk desk;
  std::vector<std::size_t> sent;
  std::string stages;
  desk.run([&](const BootProgress& progress) {
    EXPECT_EQ(progress.total, desk.image.size());
    if (progress.stage == BootStage::kUpload) sent.push_back(progress.sent);
    if (stages.find(name(progress.stage)) == std::string::npos) stages += std::string(name(progress.stage)) + "; ";
    return true;
  });
  EXPECT_EQ(sent, (std::vector<std::size_t>{0, 62, 124, 186}));
  EXPECT_EQ(stages, "looking for firmware; waking the boot loader; agreeing on the rate; loading firmware; starting firmware; ");
  Desk other;
  EXPECT_EQ(other.run([](const BootProgress& progress) { return progress.sent < 100; }).outcome, BootOutcome::kStopped);
  EXPECT_EQ(other.falcon.uploaded.size(), 124U);
}

}  // namespace
}  // namespace isotouch::falcon
