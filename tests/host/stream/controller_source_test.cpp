/// Touches of a running controller as frames.
#include <gtest/gtest.h>

#include <cstdint>
#include <string>

#include "host/error.h"
#include "host/stream/sources.h"
#include "shared/trace.h"
#include "tests/support/scripted_controller.h"

namespace isotouch::stream {
namespace {

using namespace std::chrono_literals;
using protocol::Kind, test::Bytes, test::frame;

/// A hand 1 mm below a plane, for that many ticks.
Bytes records(std::uint64_t first_tick, std::size_t count) {
  TraceRecord record;
  record.input = position_input({{}, Mm::of(-1), {}});
  record.output.hip = record.input.hip;
  record.output.force.y = Newton::of(0.5);
  record.output.status = kContact;
  const TraceRecordBytes bytes = encode(record);
  Bytes all;
  for (std::size_t i = 0; i < count; ++i) all.insert(all.end(), bytes.begin(), bytes.end());
  return frame(Kind::kRecords, protocol::Records{first_tick, 1, static_cast<std::uint32_t>(bytes.size()), 0, all});
}

Bytes begin(const std::string& settings) {
  protocol::Welcome welcome;
  welcome.period_ns = 1'000'000;
  Bytes all = frame(Kind::kWelcome, welcome);
  const Bytes report =
      frame(Kind::kSettingsReport, protocol::SettingsReport{1, {reinterpret_cast<const std::uint8_t*>(settings.data()), settings.size()}});
  for (const Bytes& next : {report, frame(Kind::kDone)}) all.insert(all.end(), next.begin(), next.end());
  return all;
}

/// Why the source ended.
std::string end_of(const Bytes& answers, Inbox& inbox) {
  const test::Scripted scripted(answers);
  const std::jthread thread = run(controller(scripted.address(), 30), inbox);
  try {
    while (!inbox.is_finished()) (void)inbox.take(1s);
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

TEST(ControllerSource, TicksThatDoNotArriveAreCounted) {
  Bytes answers = begin("feel.stiffness = 0.5\n");
  for (const auto& [tick, count] : {std::pair<std::uint64_t, std::size_t>{100, 20}, {120, 20}, {150, 10}, {167, 3}}) {
    const Bytes more = records(tick, count);
    answers.insert(answers.end(), more.begin(), more.end());
  }
  Inbox inbox;
  EXPECT_NE(end_of(answers, inbox).find("closed the connection"), std::string::npos);
  EXPECT_EQ(inbox.lost(), 10U + 7U);
}

TEST(ControllerSource, FrictionIsRefused) {
  for (const char* settings : {"feel.friction = 0.3\n", "feel.stiffness = 0.5\nfeel.friction_damping = 0.001\n"}) {
    Inbox inbox;
    EXPECT_NE(end_of(begin(settings), inbox).find(" is set, which moves the proxy"), std::string::npos) << settings;
  }
}

}  // namespace
}  // namespace isotouch::stream
