#include "firmware/falcon/falcon_session.h"

#include <gtest/gtest.h>

#include "tests/firmware/falcon/fake_falcon.h"

namespace isotouch::falcon {
namespace {

using test::FakeClock;
using test::FakeFalcon;
using test::kImage;

struct Desk : test::SessionDesk {
  /// Steps until the state is reached; false when it is not within a minute.
  bool reaches(SessionState state) {
    for (const std::int64_t until = clock.now + 60'000'000'000; clock.now < until; clock.now += 100'000) {
      if (session.state() == state) return true;
      session.step({{7, 7, 7}});
    }
    return false;
  }
  void unplug(bool power_too) {
    falcon.faults.present = false;
    if (power_too) falcon.running = false;
  }
};

TEST(FalconSession, FindsBootsAndRuns) {
  Desk desk;
  EXPECT_EQ(desk.session.state(), SessionState::kSearching);
  EXPECT_TRUE(desk.session.step({}).lost);
  EXPECT_EQ(desk.session.state(), SessionState::kBooting);
  EXPECT_TRUE(desk.session.step({}).lost);
  EXPECT_EQ(desk.session.state(), SessionState::kRunning);
  EXPECT_EQ(desk.session.last_boot().outcome, BootOutcome::kLoaded);
  const Exchange exchange = desk.session.step({{1, 2, 3}});
  EXPECT_TRUE(exchange.fresh && !exchange.lost);
  EXPECT_FALSE(desk.session.trouble());
}

TEST(FalconSession, SurvivesAnyNumberOfUnplugs) {
  Desk desk;
  ASSERT_TRUE(desk.reaches(SessionState::kRunning));
  desk.falcon.reply.homed = 7;  // else a reply to nothing would be an echo
  for (int i = 1; i <= 5; ++i) {
    for (int k = 0; k < 10; ++k) EXPECT_TRUE(desk.session.step({}).fresh);
    const bool power_too = i % 2 == 0;
    desk.unplug(power_too);
    EXPECT_TRUE(desk.session.step({}).lost);
    EXPECT_EQ(desk.session.state(), SessionState::kSearching);
    EXPECT_EQ(desk.session.losses(), static_cast<std::uint64_t>(i));
    for (int k = 0; k < 200; ++k) EXPECT_TRUE(desk.session.step({}).lost);
    EXPECT_EQ(desk.session.trouble(), LinkError::kNotFound);
    desk.falcon.faults.present = true;
    ASSERT_TRUE(desk.reaches(SessionState::kRunning));
    EXPECT_EQ(desk.session.last_boot().outcome, power_too ? BootOutcome::kLoaded : BootOutcome::kAlreadyRunning);
  }
}

TEST(FalconSession, LooksForADeviceFourTimesASecondAndSleepsInBetween) {
  Desk desk;
  desk.falcon.faults.present = false;
  const std::int64_t began = desk.clock.now;
  int steps = 0;
  for (; desk.clock.now < began + 10'000'000'000; ++steps) {
    const std::int64_t before = desk.clock.now;
    desk.session.step({});
    EXPECT_LE(desk.clock.now - before, 10'000'000);
  }
  EXPECT_EQ(std::count(desk.falcon.log.begin(), desk.falcon.log.end(), "open"), 40);
  EXPECT_LT(steps, 1100);
}

TEST(FalconSession, TriesToBootAgainUntilTheWallPowerIsThere) {
  Desk desk;
  desk.falcon.faults.wall_power = false;
  EXPECT_FALSE(desk.reaches(SessionState::kRunning));
  EXPECT_EQ(desk.session.last_boot().outcome, BootOutcome::kNoHandshake);
  desk.falcon.faults.wall_power = true;
  const std::int64_t began = desk.clock.now;
  EXPECT_TRUE(desk.reaches(SessionState::kRunning));
  EXPECT_LT(desk.clock.now - began, 2'000'000'000);
}

TEST(FalconSession, ABootThatFailedIsTriedAgainAfterASecond) {
  Desk desk;
  desk.falcon.faults.wall_power = false;
  ASSERT_TRUE(desk.reaches(SessionState::kBooting));
  ASSERT_TRUE(desk.reaches(SessionState::kSearching));
  const std::int64_t failed = desk.clock.now;
  ASSERT_TRUE(desk.reaches(SessionState::kBooting));
  EXPECT_GE(desk.clock.now - failed, 990'000'000);
  EXPECT_LE(desk.clock.now - failed, 1'100'000'000);
}

TEST(FalconSession, AnUnplugWhileBootingLeadsBackToTheSearch) {
  FakeClock clock;
  FakeFalcon falcon(clock);
  bool unplugged = false;
  FalconSession session(falcon, clock, kImage, {}, [&](const BootProgress& progress) {
    if (progress.stage == BootStage::kUpload && !unplugged) {
      unplugged = true;
      falcon.faults.present = false;
    }
    return true;
  });
  session.step({});
  session.step({});
  EXPECT_TRUE(unplugged);
  EXPECT_EQ(session.state(), SessionState::kSearching);
  EXPECT_EQ(session.last_boot().outcome, BootOutcome::kLinkFailed);
  falcon.faults.present = true;
  for (int i = 0; i < 1000 && session.state() != SessionState::kRunning; ++i) session.step({});
  EXPECT_EQ(session.state(), SessionState::kRunning);
}

TEST(FalconSession, BringsASilentDeviceUpAgain) {
  Desk desk;
  ASSERT_TRUE(desk.reaches(SessionState::kRunning));
  desk.falcon.running = false;  // its wall power was away for a moment
  int lost = 0;
  for (int i = 0; i < 20; ++i) lost += desk.session.step({}).lost ? 1 : 0;
  EXPECT_EQ(lost, 1);
  ASSERT_TRUE(desk.reaches(SessionState::kRunning));
  EXPECT_EQ(desk.session.last_boot().outcome, BootOutcome::kLoaded);
}

TEST(FalconSession, ADeviceThatIsLostIsLeftWithoutForceAndLight) {
  Desk desk;
  ASSERT_TRUE(desk.reaches(SessionState::kRunning));
  const FalconCommand pushes = {{7, 7, 7}, kFalconGreen};
  desk.session.step(pushes);
  desk.falcon.faults.mute_replies = 20;  // it hears, and does not answer
  bool lost = false;
  for (int i = 0; i < 20; ++i) lost = desk.session.step(pushes).lost;
  ASSERT_TRUE(lost);
  EXPECT_FALSE(desk.falcon.is_open());
  const auto& commands = desk.falcon.commands;
  ASSERT_GE(commands.size(), 4U);
  EXPECT_NE(commands[commands.size() - 4], FalconCommand{});
  for (std::size_t i = 1; i <= 3; ++i) EXPECT_EQ(commands[commands.size() - i], FalconCommand{});
}

TEST(FalconSession, EndsWithoutForceAndLightAndGivesTheDeviceBack) {
  FakeClock clock;
  FakeFalcon falcon(clock);
  {
    FalconSession session(falcon, clock, kImage);
    for (int i = 0; i < 5; ++i) session.step({{100, 100, 100}});
    EXPECT_EQ(falcon.commands.back().words[0], 100);
  }
  ASSERT_GE(falcon.commands.size(), 4U);
  for (std::size_t i = 1; i <= 3; ++i) EXPECT_EQ(falcon.commands[falcon.commands.size() - i], FalconCommand{});
  EXPECT_FALSE(falcon.is_open());
}

TEST(FalconSession, AFlippedBitOfItsStateLeavesTheDeviceWithoutForce) {
  for (std::uint8_t bit = 0; bit < 8; ++bit) {
    Desk desk;
    ASSERT_TRUE(desk.reaches(SessionState::kRunning));
    desk.session.step({{7, 7, 7}, kFalconGreen});
    auto* const bytes = reinterpret_cast<std::uint8_t*>(&desk.session);
    bool found = false;
    for (std::size_t at = 0; at < sizeof(FalconSession) && !found; ++at) {
      bytes[at] ^= static_cast<std::uint8_t>(1U << bit);
      found = desk.session.state() != SessionState::kRunning;
      if (!found) bytes[at] ^= static_cast<std::uint8_t>(1U << bit);
    }
    ASSERT_TRUE(found);
    desk.session.step({{7, 7, 7}, kFalconGreen});
    EXPECT_EQ(desk.falcon.commands.back(), FalconCommand{}) << int{bit};
    EXPECT_TRUE(desk.reaches(SessionState::kRunning)) << int{bit};
  }
}

TEST(FalconSession, StopsWithinABootWhenToldTo) {
  FakeClock clock;
  FakeFalcon falcon(clock);
  FalconSession session(falcon, clock, kImage, {}, [](const BootProgress&) { return false; });
  session.step({});
  session.step({});
  EXPECT_EQ(session.last_boot().outcome, BootOutcome::kStopped);
  EXPECT_EQ(session.state(), SessionState::kSearching);
}

}  // namespace
}  // namespace isotouch::falcon
