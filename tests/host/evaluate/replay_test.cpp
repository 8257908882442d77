#include "host/evaluate/replay.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <string>

#include "host/error.h"
#include "host/evaluate/motion.h"
#include "host/evaluate/trace_diff.h"
#include "host/evaluate/wire_hand.h"
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

  TraceWriter empty(folder.path() / "empty.trace", replay_header(image.view(), TraceHeader{}));
  empty.finish();
  EXPECT_THROW(replay(image.view(), Trace::read(folder.path() / "empty.trace"), true), InputError) << "no records";
}

/// The tour as packets of a device that is switched on, gets its field and loses some packets, with what its tick answered.
std::filesystem::path recorded_wire(const ScratchFolder& folder, const BlobView& field) {
  const Trace hand = Trace::read(inputs(folder, field));
  const DeviceTraceHeader header{hand.header(), libnifalcon_model()};
  DeviceRun run(field, header);
  WireHand wire(header.device);
  const std::filesystem::path file = folder.path() / "wire.trace";
  DeviceTraceWriter writer(file, run.header());
  for (std::size_t tick = 0; tick < hand.size(); ++tick) {
    DeviceInput input = wire(hand.record(tick).input, tick < 40 ? 0 : 7);
    if (tick < 10) input = DeviceInput{};
    if (tick % 500 > 495) input.fresh = false, input.age = static_cast<std::uint16_t>(tick % 500 - 495);
    if (tick == 3000) input.commands = kCommandStop;
    if (tick == 3100) input.commands = kCommandResume;
    writer.append(run.step(input));
  }
  writer.finish();
  return file;
}

TEST(Replay, OfADeviceEqualsWhatItRecorded) {
  const ScratchFolder folder;
  const test::FieldImage image = ball(20);
  const DeviceTrace trace = DeviceTrace::read(recorded_wire(folder, image.view()));
  const ReplayReport report = replay(image.view(), trace, true);
  EXPECT_FALSE(report.first_difference.has_value());
  EXPECT_EQ(report.ticks, 5000U);
  EXPECT_EQ(report.hash, trace.chain(4999));
  int touching = 0;
  for (std::size_t tick = 0; tick < trace.size(); ++tick) {
    const TickOutput out = trace.record(tick).output.tick;
    touching += (out.status & kContact) != 0 && out.words != TickOutput{}.words ? 1 : 0;
  }
  EXPECT_GT(touching, 500);
}

TEST(Replay, OfADeviceNamesTickAndFieldOfAChange) {
  const ScratchFolder folder;
  const test::FieldImage image = ball(20);
  const std::string bytes = bytes_of(recorded_wire(folder, image.view()));
  const std::pair<std::size_t, const char*> fields[] = {
      {0, "input"},    {16, "input"},   {24, "hip.x"},   {30, "hip.y"},   {32, "hip.z"},    {36, "proxy.x"},  {40, "proxy.y"},
      {44, "proxy.z"}, {48, "force.x"}, {52, "force.y"}, {56, "force.z"}, {60, "words[0]"}, {62, "words[1]"}, {64, "words[2]"},
      {66, "state"},   {68, "status"},  {72, "faults"},  {74, "flags"},   {75, "buttons"},  {80, "chain"}};
  for (const auto& [byte, name] : fields) {
    for (const std::size_t tick : {600U, 4000U}) {
      std::string flipped = bytes;
      char& target = flipped[224 + 96 * tick + byte];
      target = static_cast<char>(target ^ 1);
      const ReplayReport report = replay(image.view(), DeviceTrace::read(folder.write("flipped.trace", flipped)), true);
      ASSERT_TRUE(report.first_difference) << name;
      EXPECT_EQ(report.first_difference->tick, tick) << name;
      EXPECT_EQ(report.first_difference->field, name);
    }
  }
}

TEST(Replay, OfADeviceRefusesASecondFieldAndAnotherBlob) {
  const ScratchFolder folder;
  const test::FieldImage image = ball(20);
  const std::string bytes = bytes_of(recorded_wire(folder, image.view()));
  std::string swapped = bytes;
  swapped[224 + 96 * 300 + 20] = 8;
  const DeviceTrace trace = DeviceTrace::read(folder.write("swapped.trace", swapped));
  EXPECT_THROW(replay(image.view(), trace, false), InputError);
  const test::FieldImage other = ball(19);
  EXPECT_THROW(replay(other.view(), DeviceTrace::read(folder.write("whole.trace", bytes)), true), InputError);
}

TEST(Replay, ATraceOfTheOtherKindIsRefusedByName) {
  const ScratchFolder folder;
  const test::FieldImage image = ball(20);
  const std::filesystem::path wire = recorded_wire(folder, image.view());
  const std::filesystem::path hip = inputs(folder, image.view());
  EXPECT_EQ(trace_major(hip), 1);
  EXPECT_EQ(trace_major(wire), 2);
  EXPECT_THROW(Trace::read(wire), InputError);
  EXPECT_THROW(DeviceTrace::read(hip), InputError);
  EXPECT_THROW(trace_major(folder.write("empty.trace", "")), InputError);
  EXPECT_THROW(trace_major(folder.write("other.trace", "something else")), InputError);
}

TEST(Replay, TwoRecordingsOfADeviceAreComparedByTheirChains) {
  const ScratchFolder folder;
  const test::FieldImage image = ball(20);
  const DeviceTrace a = DeviceTrace::read(recorded_wire(folder, image.view()));
  DeviceRun run(image.view(), a.header());
  DeviceTraceWriter writer(folder.path() / "b.trace", run.header());
  for (std::size_t tick = 0; tick < a.size(); ++tick) {
    DeviceInput input = a.record(tick).input;
    if (tick == 2345) input.commands = kCommandStop;
    writer.append(run.step(input));
  }
  writer.finish();
  const DeviceTrace b = DeviceTrace::read(folder.path() / "b.trace");
  EXPECT_FALSE(first_difference(a, a).has_value());
  const auto difference = first_difference(a, b);
  ASSERT_TRUE(difference.has_value());
  EXPECT_EQ(difference->tick, 2345U);
  EXPECT_EQ(difference->field, "commands");
}

}  // namespace
}  // namespace isotouch::evaluate
