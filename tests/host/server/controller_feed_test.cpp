/// What a page hears of a controller.
#include "host/server/controller_feed.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/socket.h>

#include <atomic>
#include <chrono>
#include <cstdint>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "shared/trace.h"
#include "tests/support/scripted_controller.h"

namespace isotouch::server {
namespace {

using namespace std::chrono_literals;
using protocol::Kind, test::Bytes, test::frame;
using testing::HasSubstr, testing::Not;

Bytes record(std::uint64_t tick, std::uint16_t faults) {
  TraceRecord of_tick;
  of_tick.input = position_input({{}, Mm::of(1), {}});
  of_tick.input.kind = InputKind::kPacket;
  of_tick.output.state = static_cast<std::uint16_t>(faults != 0 ? SupervisorState::kFault : SupervisorState::kActive);
  of_tick.output.faults = faults;
  const TraceRecordBytes bytes = encode(of_tick);
  return frame(Kind::kRecords, protocol::Records{tick, 1, static_cast<std::uint32_t>(bytes.size()), 0, bytes});
}

void say(int client, const std::vector<Bytes>& frames) {
  for (const Bytes& bytes : frames) (void)::send(client, bytes.data(), bytes.size(), MSG_NOSIGNAL);
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
    say(client, {frame(Kind::kWelcome, welcome), frame(Kind::kHistogramReport, protocol::HistogramReport{}),
                 frame(Kind::kHistogramReport, protocol::HistogramReport{}), frame(Kind::kStatusReport, status)});
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

}  // namespace
}  // namespace isotouch::server
