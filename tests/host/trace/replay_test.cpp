#include "host/trace/replay.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <string>

#include "host/error.h"
#include "host/motion/device_in_hand.h"
#include "host/motion/motion.h"
#include "host/trace/trace_diff.h"
#include "tests/support/chained.h"
#include "tests/support/field_image.h"
#include "tests/support/scratch_folder.h"

namespace isotouch::trace {
namespace {

test::FieldImage ball(double radius) {
  return {{61, 61, 61}, [=](const test::Point& p) {
            return std::sqrt((p[0] - 30.2) * (p[0] - 30.2) + (p[1] - 29.7) * (p[1] - 29.7) + (p[2] - 30.4) * (p[2] - 30.4)) - radius;
          }};
}

std::filesystem::path inputs(const ScratchFolder& folder, const FieldView& field) {
  const std::filesystem::path file = folder.path() / "in.trace";
  TraceWriter writer(file, {});
  motion::make_motion(&field, {.kind = "tour", .ticks = 5000}, [&](const Input& input) { writer.append({input, {}, 0, 0}); });
  writer.finish();
  return file;
}

std::filesystem::path recorded(const ScratchFolder& folder, const FieldView& field) {
  const Trace trace = read_trace(inputs(folder, field));
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
Difference after_flip(const ScratchFolder& folder, const FieldView& field, std::string bytes, std::size_t tick, std::size_t byte,
                      int bit = 0) {
  char& target = bytes[256 + 104 * tick + byte];
  target = static_cast<char>(target ^ (1 << bit));
  const ReplayReport report = replay(field, read_trace(folder.write("flipped.trace", bytes), Damaged::kReport), true);
  return report.first_difference.value_or(Difference{0, "none"});
}

TEST(Replay, EqualsWhatItRecorded) {
  const ScratchFolder folder;
  const test::FieldImage image = ball(20);
  const Trace trace = read_trace(recorded(folder, image.view()));
  const ReplayReport report = replay(image.view(), trace, true);
  EXPECT_FALSE(report.first_difference.has_value());
  EXPECT_EQ(report.ticks, 5000U);
  EXPECT_EQ(report.hash, trace.chain(4999));
  EXPECT_EQ(replay(image.view(), read_trace(inputs(folder, image.view())), false).hash, report.hash) << "inputs alone give the same run";
}

TEST(Replay, NamesTickAndFieldOfAChangedOutput) {
  const ScratchFolder folder;
  const test::FieldImage image = ball(20);
  const std::string bytes = bytes_of(recorded(folder, image.view()));
  const std::pair<std::size_t, const char*> fields[] = {
      {32, "hip.x"},       {44, "proxy.x"},     {50, "proxy.y"},     {52, "proxy.z"}, {56, "force.x"}, {60, "force.y"}, {64, "force.z"},
      {68, "commands[0]"}, {70, "commands[1]"}, {72, "commands[2]"}, {74, "state"},   {76, "status"},  {80, "faults"},  {83, "buttons"}};
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
    for (const std::size_t byte : {16U, 22U, 25U, 28U}) {
      const Difference difference = after_flip(folder, image.view(), bytes, tick, byte);
      EXPECT_EQ(difference.tick, tick);
      EXPECT_EQ(difference.field, "input");
    }
  }
  const Difference chain = after_flip(folder, image.view(), bytes, 1234, 90);
  EXPECT_EQ(chain.tick, 1234U);
  EXPECT_EQ(chain.field, "chain");
}

TEST(Replay, ArrivalTimesAreOutsideTheComparison) {
  const ScratchFolder folder;
  const test::FieldImage image = ball(20);
  EXPECT_EQ(after_flip(folder, image.view(), bytes_of(recorded(folder, image.view())), 1234, 98).field, "none");
}

TEST(Replay, OtherSettingsAreAnotherRun) {
  const ScratchFolder folder;
  const test::FieldImage image = ball(20);
  const Trace trace = read_trace(inputs(folder, image.view()));
  TraceHeader stiffer = trace.header();
  stiffer.settings.stiffness = Stiffness::of(1.5);
  trace::Run a(image.view(), trace.header());
  trace::Run b(image.view(), stiffer);
  EXPECT_NE(a.hash(), b.hash()) << "before the first tick";
}

TEST(Replay, RefusesToCheckWhatCannotBeCompared) {
  const ScratchFolder folder;
  const test::FieldImage image = ball(20);
  const test::FieldImage other = ball(20.01);
  const Trace trace = read_trace(recorded(folder, image.view()));
  EXPECT_THROW(replay(other.view(), trace, true), InputError) << "another field";
  EXPECT_NO_THROW(replay(other.view(), trace, false));
  EXPECT_THROW(replay(image.view(), read_trace(inputs(folder, image.view())), true), InputError) << "no outputs";

  TraceWriter empty(folder.path() / "empty.trace", replay_header(image.view(), TraceHeader{}));
  empty.finish();
  EXPECT_THROW(replay(image.view(), read_trace(folder.path() / "empty.trace"), true), InputError) << "no records";
}

Input unhomed(Input input) {
  FalconReply reply = *decode_reply(input.packet);
  reply.homed = 0;
  input.packet = encode(reply);
  return input;
}

/// The tour as packets of a device that is switched on, homed, gets its field and loses some packets, with what its tick answered.
std::filesystem::path recorded_packets(const ScratchFolder& folder, const FieldView& field) {
  const Trace hand = read_trace(inputs(folder, field));
  const TraceHeader& header = hand.header();
  trace::Run run(field, header);
  motion::DeviceInHand device(header.device);
  const std::filesystem::path file = folder.path() / "packets.trace";
  TraceWriter writer(file, run.header());
  for (std::size_t tick = 0; tick < hand.size(); ++tick) {
    Input input = device(hand.record(tick).input);
    input.field_generation = tick < 40 ? 0 : 7;
    if (tick < 30) input = unhomed(input);
    if (tick < 10) input = Input{};
    if (tick % 500 > 495) input.fresh = false, input.age = static_cast<std::uint16_t>(tick % 500 - 495);
    if (tick == 3000) input.requests = kRequestStop;
    if (tick == 3100) input.requests = kRequestResume;
    writer.append(run.step(input));
  }
  writer.finish();
  return file;
}

TEST(Replay, OfADeviceEqualsWhatItRecorded) {
  const ScratchFolder folder;
  const test::FieldImage image = ball(20);
  const Trace trace = read_trace(recorded_packets(folder, image.view()));
  const ReplayReport report = replay(image.view(), trace, true);
  EXPECT_FALSE(report.first_difference.has_value());
  EXPECT_EQ(report.ticks, 5000U);
  EXPECT_EQ(report.hash, trace.chain(4999));
  int touching = 0;
  for (std::size_t tick = 0; tick < trace.size(); ++tick) {
    const Output out = trace.record(tick).output;
    touching += (out.status & kContact) != 0 && out.commands != MotorCommands{} ? 1 : 0;
  }
  EXPECT_GT(touching, 500);
}

TEST(Replay, OfADeviceNamesTickAndFieldOfAChange) {
  const ScratchFolder folder;
  const test::FieldImage image = ball(20);
  const std::string bytes = bytes_of(recorded_packets(folder, image.view()));
  const std::pair<std::size_t, const char*> fields[] = {{1, "input"},        {16, "input"},        {32, "hip.x"},   {38, "hip.y"},
                                                        {40, "hip.z"},       {44, "proxy.x"},      {48, "proxy.y"}, {52, "proxy.z"},
                                                        {56, "force.x"},     {60, "force.y"},      {64, "force.z"}, {68, "commands[0]"},
                                                        {70, "commands[1]"}, {72, "commands[2]"},  {74, "state"},   {76, "status"},
                                                        {80, "faults"},      {82, "packet_flags"}, {83, "buttons"}, {88, "chain"}};
  for (const auto& [byte, name] : fields) {
    for (const std::size_t tick : {600U, 4000U}) {
      std::string flipped = bytes;
      char& target = flipped[256 + 104 * tick + byte];
      target = static_cast<char>(target ^ 1);
      const ReplayReport report = replay(image.view(), read_trace(folder.write("flipped.trace", flipped), Damaged::kReport), true);
      ASSERT_TRUE(report.first_difference) << name;
      EXPECT_EQ(report.first_difference->tick, tick) << name;
      EXPECT_EQ(report.first_difference->field, name);
    }
  }
}

TEST(Replay, OfADeviceRefusesASecondFieldAndAnotherFirstField) {
  const ScratchFolder folder;
  const test::FieldImage image = ball(20);
  const std::string bytes = bytes_of(recorded_packets(folder, image.view()));
  std::string swapped = bytes;
  swapped[256 + 104 * 300 + 12] = 8;
  const Trace trace = read_trace(folder.write("swapped.trace", swapped), Damaged::kReport);
  EXPECT_THROW(replay(image.view(), trace, false), InputError);
  const test::FieldImage other = ball(19);
  EXPECT_THROW(replay(other.view(), read_trace(folder.write("whole.trace", bytes)), true), InputError);
}

TEST(Replay, WhatStandsInATracesPlaceIsNamed) {
  const ScratchFolder folder;
  const auto refusal_of = [](const std::filesystem::path& file) -> std::string {
    try {
      (void)read_trace(file);
    } catch (const InputError& error) {
      return std::string(error.what()).substr(file.string().size());
    }
    return "it was read";
  };
  EXPECT_EQ(refusal_of(folder.write("a.itf", "ITFB")), ": is a field, no trace; name a recording");
  EXPECT_EQ(refusal_of(folder.write("a.patches", "ITFD")), ": holds patches, no trace; name the recording beside it");
  EXPECT_EQ(refusal_of(folder.write("a.trace", "version https://git-lfs.github.com/spec/v1\n")),
            ": is a Git LFS pointer; fetch the file with git lfs pull");
}

TEST(Replay, PacketsFromTheMiddleOfARunAreRefused) {
  const ScratchFolder folder;
  const test::FieldImage image = ball(20);
  const Trace whole = read_trace(recorded_packets(folder, image.view()));
  const auto from = [&](std::size_t begin, std::uint8_t requests) {
    const std::filesystem::path file = folder.path() / "part.trace";
    TraceWriter writer(file, whole.header());
    Chain chain(whole.header());
    for (std::size_t tick = begin; tick < whole.size(); ++tick) {
      TraceRecord record = whole.record(tick);
      if (tick == begin) record.input.requests |= requests;
      writer.append(test::chained(chain, record));
    }
    writer.finish();
    return read_trace(file);
  };
  EXPECT_NO_THROW(replay(image.view(), from(0, 0), false));
  EXPECT_NO_THROW(replay(image.view(), from(4000, kRequestRestart), false));
  EXPECT_NO_THROW(replay(image.view(), from(10, 0), false)) << "the first packet";
  ASSERT_EQ(whole.record(20).output.state, static_cast<std::uint16_t>(SupervisorState::kHoming));
  for (const std::size_t begin : {20U, 4000U}) {
    const Trace middle = from(begin, 0);
    for (const bool check : {false, true}) {
      try {
        replay(image.view(), middle, check);
        ADD_FAILURE() << "it was replayed from record " << begin;
      } catch (const InputError& error) {
        EXPECT_EQ(std::string(error.what()),
                  middle.path() + ": begins in the middle of a run, so it cannot be replayed; look at it with isotouch trace show");
      }
    }
  }
}

TEST(Replay, ATraceOfTheOtherKindIsRefusedByName) {
  const ScratchFolder folder;
  const test::FieldImage image = ball(20);
  const std::filesystem::path packets = recorded_packets(folder, image.view());
  const std::filesystem::path positions = inputs(folder, image.view());
  EXPECT_EQ(read_trace(positions).kind(), InputKind::kPosition);
  EXPECT_EQ(read_trace(packets).kind(), InputKind::kPacket);
  EXPECT_EQ(read_trace(packets, InputKind::kPacket).size(), 5000U);
  EXPECT_THROW(read_trace(packets, InputKind::kPosition), InputError);
  EXPECT_THROW(read_trace(positions, InputKind::kPacket), InputError);
}

TEST(Replay, TwoRecordingsOfADeviceAreComparedByTheirChains) {
  const ScratchFolder folder;
  const test::FieldImage image = ball(20);
  const Trace a = read_trace(recorded_packets(folder, image.view()));
  trace::Run run(image.view(), a.header());
  TraceWriter writer(folder.path() / "b.trace", run.header());
  for (std::size_t tick = 0; tick < a.size(); ++tick) {
    Input input = a.record(tick).input;
    if (tick == 2345) input.requests = kRequestStop;
    writer.append(run.step(input));
  }
  writer.finish();
  const Trace b = read_trace(folder.path() / "b.trace");
  EXPECT_FALSE(first_difference(a, a).has_value());
  const auto difference = first_difference(a, b);
  ASSERT_TRUE(difference.has_value());
  EXPECT_EQ(difference->tick, 2345U);
  EXPECT_EQ(difference->field, "input.requests");
}

}  // namespace
}  // namespace isotouch::trace
