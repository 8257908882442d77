#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>

#include "host/field_file/open_field.h"
#include "host/motion/felt_surface.h"
#include "host/to_double.h"
#include "host/trace/recorded_patches.h"
#include "host/trace/replay.h"
#include "host/trace/trace_file.h"
#include "tests/host/commands/run_command.h"
#include "tests/support/scratch_folder.h"

namespace isotouch::commands {
namespace {

const std::string kField = ISOTOUCH_GOLDEN "/field_1_2.itf";

class TraceMutate : public ::testing::Test {
 protected:
  std::string file(const std::string& name) const { return (folder_.path() / name).string(); }
  /// A recorded hand, and the same as packets.
  void SetUp() override {
    run_command("trace make press " + kField + " --ticks 2000 -o " + file("hand.trace"));
    run_command("trace to-packets " + kField + " " + file("hand.trace") + " -o " + file("packets.trace"));
  }
  ScratchFolder folder_;
};

TEST_F(TraceMutate, AMutatedHandIsATraceWithoutOutputsAndWithTheSettingsOfTheHand) {
  run_command("trace mutate jitter " + kField + " " + file("hand.trace") + " --seed 3 -o " + file("mutated.trace"));
  const auto mutated = trace::read_trace(file("mutated.trace")), hand = trace::read_trace(file("hand.trace"));
  EXPECT_EQ(mutated.size(), hand.size());
  EXPECT_FALSE(mutated.header().has_outputs);
  EXPECT_EQ(mutated.header().settings, hand.header().settings);
}

TEST_F(TraceMutate, MutatedPacketsHoldWhatTheTickAnswers) {
  run_command("trace mutate faults " + kField + " " + file("packets.trace") + " -o " + file("mutated.trace"));
  const auto mutated = trace::read_trace(file("mutated.trace"));
  EXPECT_EQ(mutated.size(), 2000U);
  EXPECT_TRUE(mutated.header().has_outputs);
  EXPECT_TRUE(mutated.chain_follows(1999));
}

/// A hand whose field was patched meanwhile: what becomes of it replays, with the patches beside it.
TEST_F(TraceMutate, UnderAStreamPatchesAreKeptWhereTheTicksAre) {
  const std::string field = ISOTOUCH_GOLDEN "/field_1_3.itf", hand = ISOTOUCH_GOLDEN "/positions_patches.trace";
  const auto first = field_file::open_field(field);
  const auto recorded = trace::read_trace(hand);
  for (const std::string kind : {"mirror", "jitter", "graze"}) {
    run_command("trace mutate " + kind + " " + field + " " + hand + " -o " + file("mutated.trace"));
    const auto mutated = trace::read_trace(file("mutated.trace"));
    ASSERT_EQ(mutated.size(), recorded.size()) << kind;
    ASSERT_TRUE(trace::read_patches(mutated, first.view)) << kind;
    for (std::size_t tick = 0; tick < mutated.size(); ++tick) {
      EXPECT_EQ(mutated.record(tick).input.moved_to, recorded.record(tick).input.moved_to) << kind << ", tick " << tick;
    }
    EXPECT_EQ(trace::replay(first.view, mutated, false).ticks, recorded.size()) << kind;
  }
  for (const std::string kind : {"fast", "dwell", "medial", "leave"}) {
    EXPECT_NE(complaint_on("trace mutate " + kind + " " + field + " " + hand + " -o " + file("no.trace")).find("its field was patched"),
              std::string::npos)
        << kind;
  }
}

/// The same as packets, which replay to the bit.
TEST_F(TraceMutate, PacketsUnderAStreamKeepTheirPatches) {
  const std::string field = ISOTOUCH_GOLDEN "/field_1_3.itf";
  const auto first = field_file::open_field(field);
  run_command("trace to-packets " + field + " " ISOTOUCH_GOLDEN "/positions_patches.trace -o " + file("under.trace"));
  const auto packets = trace::read_trace(file("under.trace"));
  ASSERT_TRUE(trace::read_patches(packets, first.view));
  EXPECT_FALSE(trace::replay(first.view, packets, true).first_difference);
  for (const std::string kind : {"wrap", "faults", "settings", "resume", "grip"}) {
    for (const std::string seed : {"1", "2", "3"}) {
      run_command("trace mutate " + kind + " " + field + " " + file("under.trace") + " --seed " + seed + " -o " + file("mutated.trace"));
      const auto mutated = trace::read_trace(file("mutated.trace"));
      EXPECT_EQ(mutated.size(), packets.size());
      EXPECT_FALSE(trace::replay(first.view, mutated, true).first_difference) << kind << ' ' << seed;
    }
  }
  std::filesystem::create_directory(file("no.patches.part"));  // no file can get that name
  EXPECT_NE(complaint_on("trace mutate wrap " + field + " " + file("under.trace") + " -o " + file("no.trace")), "");
  EXPECT_FALSE(std::filesystem::exists(file("no.trace"))) << "without its patches it cannot be replayed";
  std::filesystem::remove(file("under.patches"));
  EXPECT_NE(
      complaint_on("trace mutate wrap " + field + " " + file("under.trace") + " -o " + file("no.trace")).find("under.patches is not there"),
      std::string::npos);
}

TEST_F(TraceMutate, AMutationOfTheOtherKindIsRefusedWithTheWayThere) {
  EXPECT_NE(
      complaint_on("trace mutate wrap " + kField + " " + file("hand.trace") + " -o " + file("no.trace")).find("isotouch trace to-packets"),
      std::string::npos);
  EXPECT_NE(complaint_on("trace mutate dwell " + kField + " " + file("packets.trace") + " -o " + file("no.trace"))
                .find("mutate the positions first"),
            std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(file("no.trace")));
}

TEST_F(TraceMutate, AMotionIsImportedIntoTheFieldsBox) {
  std::ofstream(file("motion.csv")) << "t_s,x_mm,y_mm,z_mm\n0,1000,5,7\n0.5,1100,25,7\n1,1000,5,57\n";
  run_command("trace import " + file("motion.csv") + " --into " + kField + " -o " + file("motion.trace"));
  const field_file::OpenField field = field_file::open_field(kField);
  const motion::FeltSurface object(field.view);
  const auto trace = trace::read_trace(file("motion.trace"));
  Eigen::Vector3d low = to_double(trace.record(0).input.hip), high = low;
  for (std::size_t tick = 0; tick < trace.size(); ++tick) {
    low = low.cwiseMin(to_double(trace.record(tick).input.hip));
    high = high.cwiseMax(to_double(trace.record(tick).input.hip));
  }
  const double longest = object.voxel_mm() * (*std::max_element(field.view.size.begin(), field.view.size.end()) - 1);
  EXPECT_NEAR((high - low).x(), longest, 0.01);
  EXPECT_NEAR((high - low).z(), longest / 2, 0.01);
  EXPECT_LT(((high + low) / 2 - object.centre()).norm(), 0.01);

  const auto warning_of = [&](const std::string& arguments) {
    testing::internal::CaptureStderr();
    run_command(arguments);
    return testing::internal::GetCapturedStderr();
  };
  const std::string into = " --into " + kField + " -o " + file("again.trace");
  EXPECT_EQ(warning_of("trace import " + file("motion.csv") + into).find("never touches"), std::string::npos);
  std::ofstream(file("far.csv"))
      << "t_s,x_mm,y_mm,z_mm\n0,0,0,0\n0.5,100,0,0\n1,100,100,0\n1.5,100,100,100\n2,0,100,100\n2.5,0,0,100\n3,0,0,0\n";
  EXPECT_NE(warning_of("trace import " + file("far.csv") + into).find("the motion never touches the object"), std::string::npos);

  std::ofstream(file("rest.csv")) << "t_s,x_mm,y_mm,z_mm\n0,1,5,7\n0.5,1,5,7\n";
  EXPECT_NE(complaint_on("trace import " + file("rest.csv") + " --into " + kField + " -o " + file("no.trace")).find("stays at one place"),
            std::string::npos);
}

}  // namespace
}  // namespace isotouch::commands
