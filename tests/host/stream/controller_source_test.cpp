/// Touches of a running controller as frames.
#include <gtest/gtest.h>
#include <sys/socket.h>

#include <cstdint>
#include <string>
#include <thread>
#include <utility>

#include "host/error.h"
#include "host/stream/sources.h"
#include "shared/trace.h"
#include "tests/support/scripted_controller.h"

namespace isotouch::stream {
namespace {

using namespace std::chrono_literals;
using protocol::Kind, test::Bytes, test::frame;

/// A hand 1 mm below a plane, for that many ticks.
Bytes records(std::uint64_t first_tick, std::size_t count, SettingChange change = {}, std::uint32_t generation = 0) {
  TraceRecord record;
  record.input = position_input({{}, Mm::of(-1), {}});
  record.input.change = change;
  record.input.field_generation = generation;
  record.output.hip = record.input.hip;
  record.output.force.y = Newton::of(0.5);
  record.output.status = kContact;
  const TraceRecordBytes bytes = encode(record);
  Bytes all;
  for (std::size_t i = 0; i < count; ++i) all.insert(all.end(), bytes.begin(), bytes.end());
  return frame(Kind::kRecords, protocol::Records{first_tick, 1, static_cast<std::uint32_t>(bytes.size()), 0, all});
}

Bytes operator+(Bytes a, const Bytes& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

Bytes welcome() {
  protocol::Welcome welcome;
  welcome.period_ns = 1'000'000;
  return frame(Kind::kWelcome, welcome);
}

Bytes settings(const std::string& different) {
  return frame(Kind::kSettingsReport,
               protocol::SettingsReport{1, {reinterpret_cast<const std::uint8_t*>(different.data()), different.size()}});
}

const Bytes kFrictionless = settings("feel.stiffness = 0.5\n"), kRough = settings("feel.friction = 0.3\n");

/// Why the source ended.
///
/// reports   of the settings, each time they are asked for
/// ticks     of the hand
std::string end_of(const Bytes& reports, const test::Scripted::Talk& ticks, Inbox& inbox) {
  const test::Scripted scripted({test::Scripted::says(welcome() + reports), [&](int client) {
                                   const Bytes begin = welcome() + frame(Kind::kDone);
                                   (void)::send(client, begin.data(), begin.size(), MSG_NOSIGNAL);
                                   ticks(client);
                                 }});
  const std::jthread thread = run(controller(scripted.address(), 30), inbox);
  try {
    while (!inbox.is_finished()) (void)inbox.take(1s);
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

TEST(ControllerSource, TicksThatDoNotArriveAreCounted) {
  Bytes ticks, reports;
  for (const auto& [tick, count] : {std::pair<std::uint64_t, std::size_t>{100, 20}, {120, 20}, {150, 10}, {167, 3}}) {
    ticks = ticks + records(tick, count);
    reports = reports + kFrictionless + kFrictionless;
  }
  Inbox inbox;
  EXPECT_NE(end_of(reports, test::Scripted::says(ticks), inbox).find("closed the connection"), std::string::npos);
  EXPECT_EQ(inbox.heard(), 53U);
  EXPECT_EQ(inbox.lost(), 10U + 7U);
}

/// The stream waits for its own controller, for up to minutes.
TEST(ControllerSource, TouchesWaitForTenSecondsAtMost) {
  constexpr std::size_t kBursts = 600, kBurst = 20, kRoom = 10'000;
  Bytes ticks;
  for (std::size_t burst = 0; burst < kBursts; ++burst) {
    const Bytes more = records(100 + burst * kBurst, kBurst);
    ticks.insert(ticks.end(), more.begin(), more.end());
  }
  const test::Scripted scripted(
      {test::Scripted::says(welcome() + kFrictionless + kFrictionless), test::Scripted::says(welcome() + frame(Kind::kDone) + ticks)});
  Inbox inbox;
  const std::jthread thread = run(controller(scripted.address(), 30), inbox);
  while (inbox.heard() < kBursts * kBurst) std::this_thread::sleep_for(1ms);
  EXPECT_EQ(inbox.take(1s)->read().positions.size(), 1U) << "of the first tick";
  EXPECT_EQ(inbox.take(10s)->read().positions.size(), kRoom);
  EXPECT_EQ(inbox.lost(), kBursts * kBurst - 1 - kRoom);
  inbox.close();
}

TEST(ControllerSource, FrictionIsRefused) {
  for (const char* different : {"feel.friction = 0.3\n", "feel.stiffness = 0.5\nfeel.friction_damping = 0.001\n"}) {
    Inbox inbox;
    EXPECT_NE(end_of(settings(different), test::Scripted::says({}), inbox).find(" is set, which moves the proxy"), std::string::npos)
        << different;
  }
}

TEST(ControllerSource, FrictionThatWasSetBeforeTheFirstTickIsSeen) {
  Inbox inbox;
  EXPECT_NE(end_of(kFrictionless + kRough, test::Scripted::says(records(100, 20)), inbox).find("friction is set"), std::string::npos);
  EXPECT_EQ(inbox.offered(), 0U);
}

/// The touches of 20 ticks are good, and what comes after them ends the stream.
void expect_end_after(const Bytes& twenty, const Bytes& after, const char* why) {
  const test::Scripted scripted({test::Scripted::says(welcome() + kFrictionless + kFrictionless),
                                 test::Scripted::says(welcome() + frame(Kind::kDone) + twenty + after)});
  Inbox inbox;
  const std::jthread thread = run(controller(scripted.address(), 30), inbox);
  EXPECT_EQ(inbox.take(10s)->read().positions.size(), 1U) << "of the first tick";
  const auto rest = inbox.take(10s);
  ASSERT_TRUE(rest);
  EXPECT_EQ(rest->read().positions.size(), 19U);
  try {
    while (!inbox.is_finished()) (void)inbox.take(1s);
    ADD_FAILURE() << "no end: " << why;
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find(why), std::string::npos) << error.what();
  }
}

TEST(ControllerSource, TouchesBeforeFrictionWasSetAreGood) {
  expect_end_after(records(100, 20), records(120, 1, {TickSetting::kFriction, rows::kFriction.raw(0.5)}), "friction is set");
}

TEST(ControllerSource, TouchesBeforeAnotherFieldAreGood) {
  expect_end_after(records(100, 20, {}, 3), records(120, 20, {}, 4), "another field was loaded while the hand touched");
}

TEST(ControllerSource, FrictionThatWasSetInALostTickIsSeen) {
  Inbox inbox;
  const auto ticks = [&](int client) {
    const Bytes before = records(100, 20);
    (void)::send(client, before.data(), before.size(), MSG_NOSIGNAL);
    while (inbox.offered() == 0 || !inbox.has_room()) std::this_thread::sleep_for(1ms);
    test::Scripted::says(records(150, 20))(client);
  };
  EXPECT_NE(end_of(kFrictionless + kFrictionless + kRough, ticks, inbox).find("friction is set"), std::string::npos);
  EXPECT_EQ(inbox.offered(), 1U);
}

}  // namespace
}  // namespace isotouch::stream
