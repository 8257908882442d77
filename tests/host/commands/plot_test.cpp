/// isotouch plot force: what it draws of a recording whose settings changed.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "host/files/whole_file.h"
#include "host/trace/trace_file.h"
#include "tests/host/commands/run_command.h"
#include "tests/support/scratch_folder.h"

namespace isotouch::commands {
namespace {

/// The golden recording of packets, with a setting that changes in the middle and the outputs as they are.
void write_changed(const std::filesystem::path& file, SettingChange change) {
  const trace::Trace golden = trace::read_trace(ISOTOUCH_GOLDEN "/packets.trace");
  trace::TraceWriter writer(file, golden.header());
  for (std::size_t tick = 0; tick < golden.size(); ++tick) {
    TraceRecord record = golden.record(tick);
    if (tick == golden.size() / 2) record.input.change = change;
    writer.append(record);
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

}  // namespace
}  // namespace isotouch::commands
