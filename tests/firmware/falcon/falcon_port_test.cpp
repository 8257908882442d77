#include "firmware/falcon/falcon_port.h"

#include <gtest/gtest.h>

#include <string>

#include "tests/firmware/falcon/fake_falcon.h"

namespace isotouch::falcon {
namespace {

using loop::Answer;

struct Desk : test::SessionDesk {
  FalconPort port{session, falcon};
  FalconPacket reply{};

  Answer exchange() { return port.exchange({{7, 7, 7}, 0}, reply); }
};

TEST(FalconPort, ADeviceThatDoesNotAnswerIsSilentAndOneThatIsNotThereAbsent) {
  Desk desk;
  EXPECT_EQ(desk.exchange(), Answer::kAbsent) << "it is searched for";
  EXPECT_EQ(desk.exchange(), Answer::kAbsent) << "it is brought up";
  desk.falcon.reply = {{1, 2, 3}, 0, 7};
  EXPECT_EQ(desk.exchange(), Answer::kReply);
  EXPECT_EQ(desk.reply, encode(desk.falcon.reply));
  desk.falcon.faults.mute_replies = 1;
  const FalconPacket before = desk.reply;
  desk.falcon.reply = {{4, 5, 6}, 0, 7};
  EXPECT_EQ(desk.exchange(), Answer::kSilent);
  EXPECT_EQ(desk.reply, before);
  EXPECT_EQ(desk.exchange(), Answer::kReply);
  desk.falcon.faults.present = false;
  EXPECT_EQ(desk.exchange(), Answer::kSilent) << "it was asked";
  EXPECT_EQ(desk.exchange(), Answer::kAbsent);
}

TEST(FalconPort, ShowsWhatBecameOfTheDevice) {
  Desk desk;
  desk.falcon.faults.present = false;
  desk.exchange();
  EXPECT_EQ(desk.port.shown().get().state, SessionState::kSearching);
  EXPECT_TRUE(desk.port.shown().get().troubled);
  EXPECT_EQ(desk.port.shown().get().trouble, LinkError::kNotFound);
  desk.falcon.faults.present = true;
  while (desk.session.state() != SessionState::kRunning) desk.exchange();
  const PortReport& running = desk.port.shown().get();
  EXPECT_EQ(running.state, SessionState::kRunning);
  EXPECT_EQ(running.boots, 1U);
  EXPECT_FALSE(running.troubled);
  EXPECT_EQ(std::string(running.serial.data()), "FAKE0001");
}

TEST(FalconPort, AnotherDeviceThanTheExpectedOneGetsNoForceAndIsNotHeardUntilItIsTrusted) {
  for (const bool is_expected : {false, true}) {
    Desk desk;
    desk.port.expect(is_expected ? "FAKE0001" : "FAKE0002");
    desk.falcon.reply = {{1, 2, 3}, 0, 7};
    while (desk.session.state() != SessionState::kRunning) desk.exchange();
    for (int n = 0; n < 5; ++n) {
      EXPECT_EQ(desk.exchange(), is_expected ? Answer::kReply : Answer::kSilent);
      EXPECT_EQ(desk.falcon.commands.back().words, is_expected ? (MotorCommands{7, 7, 7}) : MotorCommands{});
    }
    desk.port.trust(desk.port.shown().get().found);
    EXPECT_EQ(desk.exchange(), Answer::kReply);
    desk.falcon.faults.present = false;
    while (desk.session.state() == SessionState::kRunning) desk.exchange();
    desk.falcon.faults.present = true;
    while (desk.session.state() != SessionState::kRunning) desk.exchange();
    EXPECT_EQ(desk.exchange(), is_expected ? Answer::kReply : Answer::kSilent) << "after an unplug it may be another one";
  }
}

TEST(FalconPort, ADeviceThatIsDistrustedGetsNoForceAndIsNotHeardUntilItIsTrustedAgain) {
  for (const bool was_trusted : {false, true}) {
    Desk desk;
    desk.port.expect("FAKE0001");
    desk.falcon.reply = {{1, 2, 3}, 0, 7};
    while (desk.session.state() != SessionState::kRunning) desk.exchange();
    if (was_trusted) desk.port.trust(desk.port.shown().get().found);
    ASSERT_EQ(desk.exchange(), Answer::kReply);
    desk.port.distrust();
    EXPECT_EQ(desk.exchange(), Answer::kSilent);
    EXPECT_EQ(desk.falcon.commands.back().words, MotorCommands{});
    desk.falcon.faults.present = false;
    while (desk.session.state() == SessionState::kRunning) desk.exchange();
    desk.falcon.faults.present = true;
    while (desk.session.state() != SessionState::kRunning) desk.exchange();
    EXPECT_EQ(desk.exchange(), Answer::kSilent) << "it was only plugged in anew";
    desk.port.trust(desk.port.shown().get().found);
    EXPECT_EQ(desk.exchange(), Answer::kReply);
    EXPECT_EQ(desk.falcon.commands.back().words, (MotorCommands{7, 7, 7}));
  }
}

TEST(FalconPort, ADeviceInPlaceOfTheExpectedOneStaysTrustedWhenThatOneIsDistrusted) {
  for (const bool is_expected : {false, true}) {
    Desk desk;
    desk.port.expect(is_expected ? "FAKE0001" : "FAKE0002");
    while (desk.session.state() != SessionState::kRunning) desk.exchange();
    if (!is_expected) desk.port.trust(desk.port.shown().get().found);
    ASSERT_EQ(desk.exchange(), Answer::kReply);
    desk.port.distrust(false);
    EXPECT_EQ(desk.exchange(), is_expected ? Answer::kSilent : Answer::kReply);
  }
}

TEST(FalconPort, RestsBySwitchingTheDeviceOff) {
  Desk desk;
  while (desk.session.state() != SessionState::kRunning) desk.exchange();
  desk.exchange();
  desk.port.rest();
  EXPECT_EQ(desk.falcon.commands.back(), FalconCommand{});
  EXPECT_FALSE(desk.falcon.is_open());
}

}  // namespace
}  // namespace isotouch::falcon
