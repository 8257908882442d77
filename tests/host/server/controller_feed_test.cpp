/// What a page hears of a controller.
#include "host/server/controller_feed.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/socket.h>

#include <atomic>
#include <bit>
#include <chrono>
#include <cstdint>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "host/server/tick_rows.h"
#include "shared/bytes.h"
#include "shared/trace.h"
#include "tests/support/scripted_controller.h"

namespace isotouch::server {
namespace {

using namespace std::chrono_literals;
using protocol::Kind, test::frame;
using testing::HasSubstr, testing::Not;

test::Bytes record(std::uint64_t tick, const TraceRecord& of_tick) {
  const TraceRecordBytes bytes = encode(of_tick);
  return frame(Kind::kRecords, protocol::Records{tick, 1, static_cast<std::uint32_t>(bytes.size()), 0, bytes});
}

test::Bytes record(std::uint64_t tick, std::uint16_t faults) {
  TraceRecord of_tick;
  of_tick.input = position_input({{}, Mm::of(1), {}});
  of_tick.input.kind = InputKind::kPacket;
  of_tick.output.state = static_cast<std::uint16_t>(faults != 0 ? SupervisorState::kFault : SupervisorState::kActive);
  of_tick.output.faults = faults;
  return record(tick, of_tick);
}

/// A hand there, which a newton pushes along x.
test::Bytes pushed(std::uint64_t tick, Mm x) {
  TraceRecord of_tick;
  of_tick.input = position_input({x, {}, {}});
  of_tick.output.hip.x = x;
  of_tick.output.force.x = Newton::of(1);
  return record(tick, of_tick);
}

void say(int client, const std::vector<test::Bytes>& frames) {
  for (const test::Bytes& bytes : frames) (void)::send(client, bytes.data(), bytes.size(), MSG_NOSIGNAL);
}

protocol::Welcome of_a_millisecond() {
  protocol::Welcome welcome;
  welcome.period_ns = 1'000'000;
  return welcome;
}

/// What a controller says first to the one who asks for its figures, without its device.
std::vector<test::Bytes> measured(const protocol::Welcome& welcome, const protocol::StatusReport& status) {
  return {frame(Kind::kWelcome, welcome), frame(Kind::kHistogramReport, protocol::HistogramReport{}),
          frame(Kind::kHistogramReport, protocol::HistogramReport{}), frame(Kind::kStatusReport, status)};
}

/// The status has the faults before a restart, which no tick has. It is asked four times a second, and a new fault may come before.
TEST(ControllerFeed, AFaultThatIsOverIsNotShownBesideANewOne) {
  protocol::Welcome welcome;
  welcome.period_ns = 1'000'000;
  std::atomic<bool> is_asked = false;
  const auto follows = [&](int client) {
    say(client, {frame(Kind::kWelcome, welcome), frame(Kind::kDone), record(1, kFaultSilent)});
    for (int n = 0; n < 200 && !is_asked; ++n) std::this_thread::sleep_for(50ms);
    std::this_thread::sleep_for(200ms);
    say(client, {record(1001, kFaultSilent), record(2001, 0), record(3001, kFaultLate), record(4001, kFaultLate)});  // a gap ends a batch
    test::Scripted::says({}, false)(client);
  };
  const auto measures = [&](int client) {
    protocol::StatusReport status;
    status.faults = kFaultSilent | kFaultSpeed;
    say(client, measured(welcome, status));
    say(client, {frame(Kind::kDeviceReport, protocol::DeviceReport{})});
    is_asked = true;
    test::Scripted::says({}, false)(client);
  };
  const test::Scripted scripted({follows, measures});
  std::mutex lock;
  std::vector<std::string> states;
  const auto heard = [&](const Shared& message) {
    const std::scoped_lock held(lock);
    if (message->topic == Topic::kState) states.push_back(message->bytes);
  };
  const ControllerFeed feed(scripted.address(), heard, [](link::Controller&) { return nlohmann::ordered_json::object(); },
                            {[](std::uint64_t) { return false; }, [](const std::string&, const link::Controller::Image&) {}});
  const auto has_come = [&](const std::string& words) {
    const std::scoped_lock held(lock);
    return !states.empty() && states.back().find(words) != std::string::npos;
  };
  for (int n = 0; n < 400 && !has_come("too late"); ++n) std::this_thread::sleep_for(50ms);
  const std::scoped_lock held(lock);
  ASSERT_FALSE(states.empty());
  EXPECT_THAT(states, testing::Contains(HasSubstr("moved too fast"))) << "which no tick has";
  EXPECT_THAT(states.back(), HasSubstr("too late"));
  EXPECT_THAT(states.back(), Not(HasSubstr("moved too fast")));
}

/// Its status is asked over a connection of its own, which may answer late.
TEST(ControllerFeed, NothingIsSaidOfAControllerThatIsGone) {
  std::atomic<bool> is_asked = false, is_gone = false;
  const auto follows = [&](int client) {
    say(client, {frame(Kind::kWelcome, of_a_millisecond()), frame(Kind::kDone), record(1, kFaultSilent)});
    for (int n = 0; n < 400 && !is_asked; ++n) std::this_thread::sleep_for(50ms);
  };
  const auto measures = [](int client) {
    say(client, measured(of_a_millisecond(), {}));
    test::Scripted::says({}, false)(client);
  };
  const test::Scripted scripted({follows, measures});
  std::atomic<int> statuses = 0;
  const auto heard = [&](const Shared& message) {
    if (message->topic == Topic::kStatus) ++statuses;
    if (message->topic == Topic::kLink && message->bytes.find("false") != std::string::npos) is_gone = true;
  };
  const auto describe = [&](link::Controller&) {
    is_asked = true;
    for (int n = 0; n < 400 && !is_gone; ++n) std::this_thread::sleep_for(50ms);
    return nlohmann::ordered_json::object();
  };
  const ControllerFeed feed(scripted.address(), heard, describe,
                            {[](std::uint64_t) { return false; }, [](const std::string&, const link::Controller::Image&) {}});
  for (int n = 0; n < 400 && !is_gone; ++n) std::this_thread::sleep_for(50ms);
  std::this_thread::sleep_for(500ms);
  EXPECT_EQ(statuses, 0);
  const std::vector<Shared> newest = feed.newest();
  ASSERT_EQ(newest.size(), 1U);
  EXPECT_EQ(newest[0]->topic, Topic::kLink);
}

/// The energies in the rows that came of what a controller says.
///
/// talk      says it, to the client that follows
/// returns   as soon as there are that many, or after ten seconds
std::vector<float> energies_of(const test::Scripted::Talk& talk, std::size_t rows) {
  const test::Scripted scripted({talk});
  std::mutex lock;
  std::vector<float> energies;
  const auto heard = [&](const Shared& message) {
    const std::scoped_lock held(lock);
    if (message->topic != Topic::kTicks) return;
    const auto* const bytes = reinterpret_cast<const std::uint8_t*>(message->bytes.data());
    for (std::size_t at = 16; at < message->bytes.size(); at += kRowBytes)
      energies.push_back(std::bit_cast<float>(load_le<std::uint32_t>(bytes + at + 4 * (kFloatColumns.size() - 1))));
  };
  const ControllerFeed feed(scripted.address(), heard, [](link::Controller&) { return nlohmann::ordered_json::object(); },
                            {[](std::uint64_t) { return false; }, [](const std::string&, const link::Controller::Image&) {}});
  for (int n = 0; n < 200; ++n) {
    std::this_thread::sleep_for(50ms);
    const std::scoped_lock held(lock);
    if (energies.size() >= rows) break;
  }
  const std::scoped_lock held(lock);
  return energies;
}

/// The next burst of a controller, or the end of its ticks, may be a long time away.
TEST(ControllerFeed, NoTickWaitsForTheNextBurst) {
  const auto energies = energies_of(
      [](int client) {
        say(client, {frame(Kind::kWelcome, of_a_millisecond()), frame(Kind::kDone), pushed(1, Mm::of(0)), pushed(2, Mm::of(1))});
        test::Scripted::says({}, false)(client);
      },
      2);
  EXPECT_THAT(energies, testing::ElementsAre(0, 1));
}

/// What a hand did while no tick came is not known.
TEST(ControllerFeed, NoWorkIsDoneWhereTicksAreMissing) {
  const auto energies = energies_of(
      [](int client) {
        say(client, {frame(Kind::kWelcome, of_a_millisecond()), frame(Kind::kDone), pushed(1, Mm::of(0)), pushed(2, Mm::of(1))});
        std::this_thread::sleep_for(100ms);
        say(client, {pushed(1000, Mm::of(50)), pushed(1001, Mm::of(52)), pushed(2000, Mm::of(0)), pushed(2001, Mm::of(0)),
                     pushed(3000, Mm::of(0))});
        test::Scripted::says({}, false)(client);
      },
      6);
  ASSERT_GE(energies.size(), 6U);
  EXPECT_THAT(std::vector(energies.begin(), energies.begin() + 6), testing::ElementsAre(0, 1, 1, 3, 3, 3));
}

/// Which only the controller knows: it is in no tick.
TEST(ControllerFeed, OtherAnglesThatWaitAreTheCauseOfASilence) {
  protocol::Welcome welcome;
  welcome.period_ns = 1'000'000;
  std::atomic<bool> is_told = false, is_over = false;
  const auto follows = [&](int client) {
    say(client, {frame(Kind::kWelcome, welcome), frame(Kind::kDone)});
    for (std::uint64_t tick = 1; !is_over; tick += 1000) {  // a gap ends a batch
      say(client, {record(tick, kFaultSilent)});
      std::this_thread::sleep_for(20ms);
    }
  };
  const auto measures = [&](int client) {
    protocol::StatusReport status;
    status.faults = kFaultSilent;
    protocol::DeviceReport device;
    device.waits = static_cast<std::uint8_t>(protocol::OtherAngles::kKept);
    say(client, measured(welcome, status));
    for (int n = 0; n < 400 && !is_told; ++n) std::this_thread::sleep_for(50ms);
    say(client, {frame(Kind::kDeviceReport, device)});
    test::Scripted::says({}, false)(client);
  };
  const test::Scripted scripted({follows, measures});
  std::mutex lock;
  std::vector<std::string> states;
  const auto heard = [&](const Shared& message) {
    const std::scoped_lock held(lock);
    if (message->topic != Topic::kState) return;
    states.push_back(message->bytes);
    is_told = true;
  };
  {
    const ControllerFeed feed(scripted.address(), heard, [](link::Controller&) { return nlohmann::ordered_json::object(); },
                              {[](std::uint64_t) { return false; }, [](const std::string&, const link::Controller::Image&) {}});
    const auto has_come = [&] {
      const std::scoped_lock held(lock);
      return states.size() == 2;
    };
    for (int n = 0; n < 400 && !has_come(); ++n) std::this_thread::sleep_for(50ms);
    is_over = true;
  }
  ASSERT_EQ(states.size(), 2U);
  EXPECT_THAT(states[0], HasSubstr("check its cable"));
  EXPECT_THAT(states[1], HasSubstr("fault: other angles were measured for this device"));
  EXPECT_THAT(states[1], Not(HasSubstr("resume")));
}

}  // namespace
}  // namespace isotouch::server
