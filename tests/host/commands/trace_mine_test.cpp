#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>

#include "host/error.h"
#include "host/evaluate/felt_surface.h"
#include "host/evaluate/open_blob.h"
#include "host/evaluate/real.h"
#include "host/evaluate/trace_file.h"
#include "tests/host/commands/run_command.h"
#include "tests/support/scratch_folder.h"

namespace isotouch::commands {
namespace {

const std::string kBlob = ISOTOUCH_GOLDEN "/blob_1_2.itf";

class TraceMine : public ::testing::Test {
 protected:
  std::string file(const std::string& name) const { return (folder_.path() / name).string(); }
  /// A recorded hand, and the same at the wire.
  void SetUp() override {
    run_command("trace make press " + kBlob + " --ticks 2000 -o " + file("hand.trace"));
    run_command("trace wire " + kBlob + " " + file("hand.trace") + " -o " + file("wire.trace"));
  }
  std::string complaint(const std::string& arguments) const {
    try {
      run_command(arguments);
    } catch (const InputError& e) {
      return e.what();
    }
    return {};
  }
  ScratchFolder folder_;
};

TEST_F(TraceMine, AMinedHandIsATraceWithoutOutputsAndWithTheSettingsOfTheHand) {
  run_command("trace mine jitter " + kBlob + " " + file("hand.trace") + " --seed 3 -o " + file("mined.trace"));
  const auto mined = evaluate::Trace::read(file("mined.trace")), hand = evaluate::Trace::read(file("hand.trace"));
  EXPECT_EQ(mined.size(), hand.size());
  EXPECT_FALSE(mined.header().has_outputs());
  EXPECT_EQ(mined.header().settings, hand.header().settings);
}

TEST_F(TraceMine, AMinedWireHoldsWhatTheTickAnswers) {
  run_command("trace mine faults " + kBlob + " " + file("wire.trace") + " -o " + file("mined.trace"));
  const auto mined = evaluate::DeviceTrace::read(file("mined.trace"));
  EXPECT_EQ(mined.size(), 2000U);
  EXPECT_TRUE(mined.header().has_outputs());
  EXPECT_TRUE(mined.chain_follows(1999));
}

TEST_F(TraceMine, AKindOfTheOtherSideIsRefusedWithTheWayThere) {
  EXPECT_NE(complaint("trace mine wrap " + kBlob + " " + file("hand.trace") + " -o " + file("no.trace")).find("isotouch trace wire"),
            std::string::npos);
  EXPECT_NE(complaint("trace mine dwell " + kBlob + " " + file("wire.trace") + " -o " + file("no.trace")).find("mine the hand first"),
            std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(file("no.trace")));
}

TEST_F(TraceMine, AMotionIsImportedIntoTheBlobsBox) {
  std::ofstream(file("motion.csv")) << "t_s,x_mm,y_mm,z_mm\n0,1000,5,7\n0.5,1100,25,7\n1,1000,5,57\n";
  run_command("trace import " + file("motion.csv") + " --into " + kBlob + " -o " + file("motion.trace"));
  const evaluate::OpenBlob blob = evaluate::open_blob(kBlob);
  const evaluate::FeltSurface object(blob.view);
  const auto trace = evaluate::Trace::read(file("motion.trace"));
  Eigen::Vector3d low = evaluate::real(trace.record(0).input.hip), high = low;
  for (std::size_t tick = 0; tick < trace.size(); ++tick) {
    low = low.cwiseMin(evaluate::real(trace.record(tick).input.hip));
    high = high.cwiseMax(evaluate::real(trace.record(tick).input.hip));
  }
  const double longest = object.voxel_mm() * (*std::max_element(blob.view.size.begin(), blob.view.size.end()) - 1);
  EXPECT_NEAR((high - low).x(), longest, 0.01);
  EXPECT_NEAR((high - low).z(), longest / 2, 0.01);
  EXPECT_LT(((high + low) / 2 - object.centre()).norm(), 0.01);

  std::ofstream(file("rest.csv")) << "t_s,x_mm,y_mm,z_mm\n0,1,5,7\n0.5,1,5,7\n";
  EXPECT_NE(complaint("trace import " + file("rest.csv") + " --into " + kBlob + " -o " + file("no.trace")).find("stays at one place"),
            std::string::npos);
}

}  // namespace
}  // namespace isotouch::commands
