#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "host/bag/bag_motion.h"
#include "host/bag/mcap_writer.h"
#include "host/files/whole_file.h"
#include "host/to_double.h"
#include "host/trace/trace_file.h"
#include "tests/host/commands/run_command.h"
#include "tests/support/scratch_folder.h"

namespace isotouch::commands {
namespace {

class TraceInABag : public ::testing::Test {
 protected:
  std::string file(const std::string& name) const { return (folder_.path() / name).string(); }
  void SetUp() override {
    run_command("trace make press " ISOTOUCH_GOLDEN "/field_1_2.itf --ticks 300 -o " + file("hand.trace"));
    run_command("trace export " + file("hand.trace") + " -o " + file("hand.mcap"));
  }
  ScratchFolder folder_;
};

TEST_F(TraceInABag, ComesBackToTheBit) {
  run_command("trace import " + file("hand.mcap") + " -o " + file("again.trace"));
  EXPECT_EQ(read_file(file("again.trace")), read_file(file("hand.trace")));
}

TEST_F(TraceInABag, ComesBackWithThePatchesOfItsField) {
  for (const std::string kind : {".trace", ".patches"})
    std::filesystem::copy_file(ISOTOUCH_GOLDEN "/positions_patches" + kind, file("felt" + kind));
  run_command("trace export " + file("felt.trace") + " -o " + file("felt.mcap"));
  run_command("trace import " + file("felt.mcap") + " -o " + file("back.trace"));
  EXPECT_EQ(read_file(file("back.trace")), read_file(file("felt.trace")));
  EXPECT_EQ(read_file(file("back.patches")), read_file(file("felt.patches")));
  EXPECT_EQ(complaint_on("trace import " + file("felt.mcap") + " -o -"),
            file("felt.mcap") + ": its field was patched, and the patches belong into a file beside the trace; write to a file, not to -");
  std::filesystem::remove(file("felt.patches"));
  EXPECT_NE(complaint_on("trace export " + file("felt.trace") + " -o " + file("no.mcap")).find("felt.patches is not there"),
            std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(file("no.mcap")));
}

/// Nobody knows the file that it is looked at in.
TEST_F(TraceInABag, WhatIsWrongWithItIsSaidOfTheFileThatWasNamed) {
  std::vector<std::uint8_t> trace = read_file(ISOTOUCH_GOLDEN "/positions.trace");
  const auto attach = [&](const char* name) {
    bag::McapWriter writer("test");
    writer.attach("felt.trace", bag::kTraceMediaType, trace);
    const std::vector<std::uint8_t> bytes = writer.finish();
    write_file(file(name), bytes.data(), bytes.size());
    return "trace import " + file(name) + " -o " + file("back.trace");
  };
  trace[256 + 104 * 3 + 46] ^= 1;
  EXPECT_EQ(complaint_on(attach("changed.mcap")),
            file("changed.mcap") +
                ": the trace that it holds cannot be read (the chain breaks at record 3: its bytes were changed after they were "
                "recorded; use the original file); choose a topic with --topic");
  EXPECT_FALSE(std::filesystem::exists(file("back.trace")));
  trace[256 + 104 * 3 + 46] ^= 1;
  trace.resize(trace.size() - 130);
  ::testing::internal::CaptureStderr();
  run_command(attach("cut.mcap"));
  EXPECT_EQ(::testing::internal::GetCapturedStderr().find("isotouch: " + file("cut.mcap") + ": the recording was cut off; it holds "), 0U);
  trace = read_file(ISOTOUCH_GOLDEN "/positions_patches.trace");
  EXPECT_EQ(
      complaint_on(attach("alone.mcap")),
      file("alone.mcap") +
          ": the trace that it holds cannot be read (its field was patched, and the patches are not there); choose a topic with --topic");
}

TEST_F(TraceInABag, AnOptionForAnotherKindOfSourceIsRefused) {
  const auto refuses = [&](const std::string& source, const std::string& options, const std::string& words) {
    const std::string sentence = complaint_on("trace import " + source + " " + options + " -o " + file("no.trace"));
    EXPECT_NE(sentence.find(words), std::string::npos) << options << ": " << sentence;
    EXPECT_FALSE(std::filesystem::exists(file("no.trace")));
  };
  write_file(file("table.csv"), "t_s,x_mm,y_mm,z_mm\n0,0,0,0\n1,1,1,1\n");
  refuses(file("hand.mcap"), "--topic /isotouch/hip --columns t=a", "--columns is for a table");
  refuses(file("hand.mcap"), "--topic /isotouch/hip --time-unit ms", "--time-unit is for a table");
  refuses(file("table.csv"), "--topic /hand", "--topic is for a recording");
  refuses(file("table.csv"), "--forces --force-topic /hand", "--force-topic is for a recording");
  refuses(file("hand.mcap"), "--topic /isotouch/hip --force-topic /hand", "--force-topic is for forces");
}

TEST_F(TraceInABag, AnOptionThatWouldHaveNoEffectIsRefusedByItsName) {
  for (const std::string option : {"--scale 2", "--stiffness 0.5", "--forces"}) {
    const std::string sentence = complaint_on("trace import " + file("hand.mcap") + " " + option + " -o " + file("no.trace"));
    EXPECT_NE(sentence.find("leave " + option.substr(0, option.find(' ')) + " out"), std::string::npos) << sentence;
    EXPECT_FALSE(std::filesystem::exists(file("no.trace")));
  }
}

/// A hand that presses a wall for 50 ms, pauses for two seconds, and presses it again elsewhere, in samples of 1 kHz.
TEST(TraceImport, APauseOfARecordingIsNoTouch) {
  const ScratchFolder folder;
  const auto file = [&](const std::string& name) { return (folder.path() / name).string(); };
  std::string table = "t_s,x_mm,y_mm,z_mm,fx_N,fy_N,fz_N\n";
  for (int i = 0; i < 100; ++i)
    table += std::to_string(0.001 * i + (i < 50 ? 0 : 1.951)) + "," + std::to_string(i < 50 ? 0 : 40) + ",-1,0,0,1,0\n";
  write_file(file("gap.csv"), table);
  run_command("trace import " + file("gap.csv") + " --forces --stiffness 1 -o " + file("gap.trace"));
  const auto trace = trace::read_trace(file("gap.trace"));
  ASSERT_EQ(trace.size(), 2051U);
  const Vec3<Mm> last = trace.record(49).input.hip;
  for (std::size_t tick = 0; tick < trace.size(); ++tick) {
    const TraceRecord record = trace.record(tick);
    const bool is_known = tick < 50 || tick > 2000;
    EXPECT_EQ(record.input.fresh, is_known) << tick;
    EXPECT_TRUE(is_known || record.input.hip == last) << "the same sample as before: " << tick;
    EXPECT_EQ(record.input.age, is_known ? 0 : tick - 49) << tick;
    EXPECT_EQ(record.output.status, is_known ? std::uint32_t{kContact} : std::uint32_t{kStale}) << tick;
    EXPECT_EQ(record.output.force == Vec3<Newton>{}, !is_known) << tick;
  }
}

TEST(TraceImport, AForceOrASurfaceThatATraceCannotHoldIsRefusedByItsSample) {
  const ScratchFolder folder;
  const auto file = [&](const std::string& name) { return (folder.path() / name).string(); };
  const auto complaint = [&](const std::string& second) {
    write_file(file("far.csv"), "t_s,x_mm,y_mm,z_mm,fx_N,fy_N,fz_N\n0,0,0,0,0,1,0\n0.01," + second + "\n");
    return complaint_on("trace import " + file("far.csv") + " --forces --stiffness 0.01 -o " + file("far.trace"));
  };
  EXPECT_EQ(complaint("2000,0,0,0.4,0,0"), "");
  EXPECT_NE(complaint("2000,0,0,2,0,0").find("far.csv: sample 2 has the surface 2200.000000 mm from"), std::string::npos);
  EXPECT_NE(complaint("0,0,0,0,-40000,0").find("far.csv: sample 2 has a force of 40000.000000 N"), std::string::npos);
  EXPECT_NE(complaint("2500,0,0,0,1,0").find("far.csv: sample 2 lies 2500.000000 mm from"), std::string::npos);
  EXPECT_NE(complaint("2500,0,0,-10,0,0").find("far.csv: sample 2 lies 2500.000000 mm from"), std::string::npos);
}

TEST_F(TraceInABag, ItsPositionsAreImportedAnewByTheirTopic) {
  run_command("trace import " + file("hand.mcap") + " --topic /isotouch/hip --scale 2 -o " + file("twice.trace"));
  const auto hand = trace::read_trace(file("hand.trace")), twice = trace::read_trace(file("twice.trace"));
  ASSERT_EQ(twice.size(), hand.size());
  const double x = to_double(hand.record(150).input.hip).x();
  EXPECT_NEAR(to_double(twice.record(150).input.hip).x(), 2 * x, 1e-4);
}

}  // namespace
}  // namespace isotouch::commands
