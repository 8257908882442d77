/// isotouch plot force and replay: what they draw and say of a recording whose settings changed.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "host/board_commands/commands.h"
#include "host/error.h"
#include "host/files/whole_file.h"
#include "host/trace/trace_file.h"
#include "tests/host/commands/run_command.h"
#include "tests/support/chained.h"
#include "tests/support/scratch_folder.h"

namespace isotouch::commands {
namespace {

/// The golden recording of packets, with a setting that changes in the middle and the outputs as they are.
void write_changed(const std::filesystem::path& file, SettingChange change) {
  const trace::Trace golden = trace::read_trace(ISOTOUCH_GOLDEN "/packets.trace");
  trace::TraceWriter writer(file, golden.header());
  Chain chain(golden.header());
  for (std::size_t tick = 0; tick < golden.size(); ++tick) {
    TraceRecord record = golden.record(tick);
    if (tick == golden.size() / 2) record.input.change = change;
    writer.append(test::chained(chain, record));
  }
  writer.finish();
}

TEST(Plot, DrawsTheLimitAndTheStiffnessThatWereSetMeanwhile) {
  const ScratchFolder folder;
  const auto picture_with = [&](SettingChange change, const std::string& more) {
    const auto file = folder.path() / "hand.trace", picture = folder.path() / "force.png";
    write_changed(file, change);
    run_command("plot force " + file.string() + " --field " ISOTOUCH_GOLDEN "/field_1_3.itf --size 320x320 -o " + picture.string() + more);
    return read_file(picture);
  };
  const SettingChange limit{TickSetting::kForceLimit, Newton::of(1).raw()}, stiffness{TickSetting::kStiffness, Stiffness::of(0.1).raw()};
  EXPECT_NE(picture_with(limit, ""), picture_with({}, ""));
  EXPECT_EQ(picture_with(stiffness, ""), picture_with({}, "")) << "only the exact answer needs it";
  EXPECT_NE(picture_with(stiffness, " --exact-sphere 30"), picture_with({}, " --exact-sphere 30"));
}

/// The second half, as what a controller saves at a fault: the header states the settings of the controller's start.
TEST(Plot, WhatBeginsInTheMiddleOfARunHasNoLimitAndNoExactAnswer) {
  const ScratchFolder folder;
  const auto file = folder.path() / "fault-1.trace", picture = folder.path() / "force.png";
  const std::string plot = "plot force " + file.string() + " --size 320x320 -o " + picture.string();
  const auto picture_with = [&](Newton limit) {
    const trace::Trace golden = trace::read_trace(ISOTOUCH_GOLDEN "/packets.trace");
    TraceHeader header = golden.header();
    header.settings.force_limit = limit;
    trace::TraceWriter writer(file, header);
    Chain chain(header);
    for (std::size_t tick = golden.size() / 2; tick < golden.size(); ++tick) writer.append(test::chained(chain, golden.record(tick)));
    writer.finish();
    run_command(plot);
    return read_file(picture);
  };
  EXPECT_EQ(picture_with(Newton::of(1)), picture_with(Newton::of(8)));
  EXPECT_THAT([&] { run_command(plot + " --field " ISOTOUCH_GOLDEN "/field_1_1.itf --exact-sphere 30"); },
              ::testing::ThrowsMessage<InputError>(::testing::HasSubstr("fault-1.trace: begins in the middle of a run")));
}

TEST(Replay, WarnsOfTheStiffestThatWasSet) {
  const ScratchFolder folder;
  const auto said_with = [&](SettingChange change) {
    const auto file = folder.path() / "hand.trace";
    write_changed(file, change);
    CLI::App app;
    add_replay(app, {});
    ::testing::internal::CaptureStdout();
    ::testing::internal::CaptureStderr();
    app.parse("replay " ISOTOUCH_GOLDEN "/field_1_1.itf " + file.string());
    ::testing::internal::GetCapturedStdout();
    return ::testing::internal::GetCapturedStderr();
  };
  EXPECT_EQ(said_with({}), "");
  EXPECT_EQ(said_with({TickSetting::kStiffness, Stiffness::of(0.1).raw()}), "");
  EXPECT_THAT(said_with({TickSetting::kStiffness, Stiffness::of(20).raw()}), ::testing::HasSubstr("N/mm is safe"));
}

}  // namespace
}  // namespace isotouch::commands
