#include <gtest/gtest.h>

#include <filesystem>
#include <string>

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

TEST_F(TraceInABag, AnOptionThatWouldHaveNoEffectIsRefusedByItsName) {
  for (const std::string option : {"--scale 2", "--stiffness 0.5", "--forces"}) {
    const std::string sentence = complaint_on("trace import " + file("hand.mcap") + " " + option + " -o " + file("no.trace"));
    EXPECT_NE(sentence.find("leave " + option.substr(0, option.find(' ')) + " out"), std::string::npos) << sentence;
    EXPECT_FALSE(std::filesystem::exists(file("no.trace")));
  }
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
