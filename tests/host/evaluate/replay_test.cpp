#include "host/evaluate/replay.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <string>

#include "host/error.h"
#include "host/evaluate/motion.h"
#include "tests/support/field_image.h"
#include "tests/support/scratch_folder.h"

namespace isotouch::evaluate {
namespace {

test::FieldImage ball(double radius) {
  return {{61, 61, 61}, [=](const test::Point& p) {
            return std::sqrt((p[0] - 30.2) * (p[0] - 30.2) + (p[1] - 29.7) * (p[1] - 29.7) + (p[2] - 30.4) * (p[2] - 30.4)) - radius;
          }};
}

std::filesystem::path inputs(const ScratchFolder& folder, const BlobView& field) {
  const std::filesystem::path file = folder.path() / "in.trace";
  TraceWriter writer(file, {});
  make_motion(&field, {.kind = "tour", .ticks = 5000}, [&](const TickInput& input) { writer.append({input, {}, 0, 0}); });
  writer.finish();
  return file;
}

std::filesystem::path recorded(const ScratchFolder& folder, const BlobView& field) {
  const Trace trace = Trace::read(inputs(folder, field));
  const std::filesystem::path file = folder.path() / "out.trace";
  TraceWriter writer(file, replay_header(field, trace.header()));
  replay(field, trace, false, &writer);
  writer.finish();
  return file;
}

std::string bytes_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// The recording with one bit of one byte of a record's flipped, checked again.
Difference after_flip(const ScratchFolder& folder, const BlobView& field, std::string bytes, std::size_t tick, std::size_t byte,
                      int bit = 0) {
  char& target = bytes[96 + 72 * tick + byte];
  target = static_cast<char>(target ^ (1 << bit));
  const ReplayReport report = replay(field, Trace::read(folder.write("flipped.trace", bytes)), true);
  return report.first_difference.value_or(Difference{0, "none"});
}

TEST(Replay, EqualsWhatItRecorded) {
  const ScratchFolder folder;
  const test::FieldImage image = ball(20);
  const Trace trace = Trace::read(recorded(folder, image.view()));
  const ReplayReport report = replay(image.view(), trace, true);
  EXPECT_FALSE(report.first_difference.has_value());
  EXPECT_EQ(report.ticks, 5000U);
  EXPECT_EQ(report.hash, trace.chain(4999));
  EXPECT_EQ(replay(image.view(), Trace::read(inputs(folder, image.view())), false).hash, report.hash) << "inputs alone give the same run";
}

TEST(Replay, NamesTickAndFieldOfAChangedOutput) {
  const ScratchFolder folder;
  const test::FieldImage image = ball(20);
  const std::string bytes = bytes_of(recorded(folder, image.view()));
  const std::pair<std::size_t, const char*> fields[] = {{16, "proxy.x"},  {22, "proxy.y"}, {24, "proxy.z"},  {28, "force.x"},
                                                        {32, "force.y"},  {36, "force.z"}, {40, "words[0]"}, {42, "words[1]"},
                                                        {44, "words[2]"}, {46, "state"},   {48, "status"}};
  for (const auto& [byte, name] : fields) {
    for (const std::size_t tick : {0U, 1234U, 4999U}) {
      const Difference difference = after_flip(folder, image.view(), bytes, tick, byte);
      EXPECT_EQ(difference.tick, tick) << name;
      EXPECT_EQ(difference.field, name);
    }
  }
}

TEST(Replay, NamesTickOfAChangedInputAndOfAChangedChain) {
  const ScratchFolder folder;
  const test::FieldImage image = ball(20);
  const std::string bytes = bytes_of(recorded(folder, image.view()));
  for (const std::size_t tick : {0U, 1234U, 4999U}) {
    for (const std::size_t byte : {0U, 6U, 9U, 12U}) {
      const Difference difference = after_flip(folder, image.view(), bytes, tick, byte);
      EXPECT_EQ(difference.tick, tick);
      EXPECT_EQ(difference.field, "input");
    }
  }
  const Difference chain = after_flip(folder, image.view(), bytes, 1234, 60);
  EXPECT_EQ(chain.tick, 1234U);
  EXPECT_EQ(chain.field, "chain");
}

TEST(Replay, ArrivalTimesAreOutsideTheComparison) {
  const ScratchFolder folder;
  const test::FieldImage image = ball(20);
  EXPECT_EQ(after_flip(folder, image.view(), bytes_of(recorded(folder, image.view())), 1234, 66).field, "none");
}

TEST(Replay, OtherSettingsAreAnotherRun) {
  const ScratchFolder folder;
  const test::FieldImage image = ball(20);
  const Trace trace = Trace::read(inputs(folder, image.view()));
  TraceHeader stiffer = trace.header();
  stiffer.settings.stiffness = Stiffness::of(1.5);
  evaluate::Run a(image.view(), trace.header());
  evaluate::Run b(image.view(), stiffer);
  EXPECT_NE(a.hash(), b.hash()) << "before the first tick";
}

TEST(Replay, RefusesToCheckWhatCannotBeCompared) {
  const ScratchFolder folder;
  const test::FieldImage image = ball(20);
  const test::FieldImage other = ball(20.01);
  const Trace trace = Trace::read(recorded(folder, image.view()));
  EXPECT_THROW(replay(other.view(), trace, true), InputError) << "another blob";
  EXPECT_NO_THROW(replay(other.view(), trace, false));
  EXPECT_THROW(replay(image.view(), Trace::read(inputs(folder, image.view())), true), InputError) << "no outputs";

  TraceHeader counts;
  counts.flags = trace_layout::kEncoderCounts;
  TraceWriter writer(folder.path() / "counts.trace", counts);
  writer.append({});
  writer.finish();
  EXPECT_THROW(replay(image.view(), Trace::read(folder.path() / "counts.trace"), false), InputError) << "encoder counts";

  TraceWriter empty(folder.path() / "empty.trace", replay_header(image.view(), {}));
  empty.finish();
  EXPECT_THROW(replay(image.view(), Trace::read(folder.path() / "empty.trace"), true), InputError) << "no records";
}

}  // namespace
}  // namespace isotouch::evaluate
