/// isotouch render and demo: which touch they show, and what they refuse.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <string>

#include "host/commands/recorded_ticks.h"
#include "host/error.h"
#include "host/field_file/open_field.h"
#include "host/files/whole_file.h"
#include "host/trace/replay.h"
#include "host/trace/trace_file.h"
#include "host/view/touch_view.h"
#include "tests/host/commands/run_command.h"
#include "tests/support/chained.h"
#include "tests/support/no_more_threads.h"
#include "tests/support/scratch_folder.h"

namespace isotouch::commands {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

const fs::path kField = ISOTOUCH_GOLDEN "/field_1_1.itf";

class Render : public ::testing::Test {
 protected:
  std::string file(const char* name) const { return (folder_.path() / name).string(); }
  std::string felt() const {
    run_command("trace make tour " + kField.string() + " -o " + file("hand.trace"));
    return file("hand.trace");
  }

 private:
  ScratchFolder folder_;
};

TEST_F(Render, TheClearTouchIsAMillimetreOrTwoDeepAndNothingHidesIt) {
  const trace::Trace trace = trace::read_trace(felt());
  const field_file::OpenField field = field_file::open_field(kField);
  const view::FieldRays rays(field.view);
  const view::Touch deepest = deepest_touch(trace, field.view);
  EXPECT_GT(deepest.depth_mm(), 5) << "a hand that stabs goes through: nothing to show to a person";
  for (const char up : {'x', 'y', 'z'}) {
    const view::Touch clear = clear_touch(trace, field.view, up);
    EXPECT_GE(clear.depth_mm(), 1.2);
    EXPECT_LE(clear.depth_mm(), 1.8);
    EXPECT_LT(view::view_cost(clear, {.up = up}, rays), 10);
    EXPECT_GT(clear.force.dot(clear.out()), 0) << "the force pushes the hand out";
    EXPECT_EQ(touch_at(trace, field.view, clear.tick).proxy, clear.proxy);
  }
}

TEST_F(Render, WritesTheTouchThatIsAskedFor) {
  const std::string start = "render surface " + kField.string() + " --trace " + felt() + " --size 320x320 -o ";
  run_command(start + file("clear.png"));
  run_command(start + file("same.png") + " --tick clear");
  run_command(start + file("deepest.png") + " --tick deepest");
  const auto bytes = [&](const char* name) { return read_file(file(name)); };
  EXPECT_EQ(bytes("clear.png"), bytes("same.png"));
  EXPECT_NE(bytes("clear.png"), bytes("deepest.png"));
  try {
    run_command(start + file("x.png") + " --tick 123456789");
    FAIL();
  } catch (const InputError& e) {
    EXPECT_THAT(e.what(), HasSubstr("there is no tick '123456789'"));
  }
  EXPECT_FALSE(fs::exists(file("x.png")));
}

TEST_F(Render, ThePictureIsTheSameWithoutMoreThreads) {
  const std::string start = "render surface " + kField.string() + " --size 320x320 -o ";
  run_command(start + file("with.png"));
  const test::NoMoreThreads none;
  run_command(start + file("without.png"));
  EXPECT_EQ(read_file(file("with.png")), read_file(file("without.png")));
}

TEST_F(Render, ATouchOfAnotherFieldIsRefused) {
  const std::string other = ISOTOUCH_GOLDEN "/field_1_2.itf", to = " --size 320x320 -o " + file("x.png");
  run_command("trace make tour " + kField.string() + " -o " + file("hand.trace"));
  const field_file::OpenField field = field_file::open_field(kField);
  const auto record_on = [&](const char* name, std::uint64_t hash) {
    const trace::Trace hand = trace::read_trace(file("hand.trace"));
    TraceHeader header = trace::replay_header(field.view, hand.header());
    header.field_hash = hash;
    trace::TraceWriter writer(file(name), header);
    trace::replay(field.view, hand, false, &writer);
    writer.finish();
  };
  record_on("felt.trace", field.view.hash());
  record_on("any.trace", 0);
  for (const std::string kind : {"surface ", "slice "}) {
    const std::string on_other = "render " + kind + other + to + " --trace ";
    EXPECT_THAT(complaint_on(on_other + file("felt.trace")), HasSubstr("felt.trace: the trace was recorded on another field"));
    EXPECT_FALSE(fs::exists(file("x.png")));
    EXPECT_EQ(complaint_on("render " + kind + kField.string() + to + " --trace " + file("felt.trace")), "");
    EXPECT_EQ(complaint_on(on_other + file("any.trace")), "");
    fs::remove(file("x.png"));
  }
}

TEST_F(Render, ASliceGoesThroughTheTouch) {
  const std::string start = "render slice " + kField.string() + " --size 320x320 -o ";
  run_command(start + file("touch.png") + " --trace " + felt());
  run_command(start + file("plain.png"));
  EXPECT_NE(read_file(file("touch.png")), read_file(file("plain.png")));
  EXPECT_THROW(run_command(start + file("x.png") + " --at 3 --trace " + file("hand.trace")), CLI::ParseError);
  EXPECT_THROW(run_command(start + file("x.png") + " --tick 3"), CLI::ParseError) << "of no trace";
}

/// The field that a tick of the golden recording of a patched field felt, in a file.
void write_felt(const fs::path& file, const trace::Trace& trace, const FieldView& first, std::size_t tick) {
  const trace::FeltField felt = felt_at(trace, first, tick);
  write_file(file, felt.now()->image.data(), felt.now()->image.size());
}

TEST_F(Render, DrawsThePatchedFieldThatTheTickFelt) {
  const fs::path first = ISOTOUCH_GOLDEN "/field_1_3.itf", recorded = ISOTOUCH_GOLDEN "/positions_patches.trace";
  const trace::Trace trace = trace::read_trace(recorded);
  const field_file::OpenField field = field_file::open_field(first);
  constexpr std::size_t kTick = 460;  // six patches later
  const view::Touch touch = touch_at(trace, field.view, kTick);
  const trace::FeltField felt = felt_at(trace, field.view, kTick);
  const view::FieldRays rays(*felt.now()), first_rays(field.view);
  EXPECT_LT(std::fabs(rays.value(touch.proxy).distance), 0.05) << "the proxy is on the surface that it felt";
  EXPECT_GT(std::fabs(first_rays.value(touch.proxy).distance), 0.3);

  write_felt(file("field_1_3.itf"), trace, field.view, kTick);  // the same name: it is the title
  for (const std::string kind : {"surface ", "slice "}) {
    const std::string rest = " --trace " + recorded.string() + " --size 320x320 -o ", at = " --tick " + std::to_string(kTick);
    run_command("render " + kind + first.string() + rest + file("of_first.png") + at);
    run_command("render " + kind + file("field_1_3.itf") + rest + file("of_felt.png") + at);
    EXPECT_EQ(read_file(file("of_first.png")), read_file(file("of_felt.png"))) << kind;
    EXPECT_THAT(complaint_on("render " + kind + file("field_1_3.itf") + rest + file("x.png") + " --tick 390"),
                HasSubstr("at tick 390 the hand felt what this field was before a patch"));
  }

  // What a controller saves at a fault may begin with the patch's tick, and has no patches beside it.
  constexpr std::size_t kPatched = 395;
  TraceHeader header = trace.header();
  header.field_hash = felt.now()->hash();
  trace::TraceWriter writer(file("fault-1.trace"), header);
  Chain chain(header);
  for (std::size_t tick = kPatched; tick <= kTick; ++tick) writer.append(test::chained(chain, trace.record(tick)));
  writer.finish();
  const std::string at = " --tick " + std::to_string(kTick - kPatched);
  EXPECT_EQ(complaint_on("render surface " + file("field_1_3.itf") + " --size 320x320 -o " + file("x.png") + " --trace " +
                         file("fault-1.trace") + at),
            "");
}

}  // namespace
}  // namespace isotouch::commands
