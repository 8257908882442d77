#include "host/server/recording.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "host/error.h"
#include "host/files/whole_file.h"
#include "host/server/tick_rows.h"
#include "shared/bytes.h"
#include "tests/support/scratch_folder.h"

namespace isotouch::server {
namespace {

/// A hand that presses along z: the proxy stays at 0, the force is a newton a millimetre.
TraceRecord pressed(double depth_mm) {
  TraceRecord record;
  record.input = position_input({});
  record.output.hip.z = Mm::from_raw(static_cast<std::int32_t>(std::lround(-depth_mm * (1 << Mm::kFractionBits))));
  if (depth_mm <= 0) {
    record.output.proxy = record.output.hip;
    return record;
  }
  record.output.force.z = Newton::from_raw(static_cast<std::int32_t>(std::lround(depth_mm * (1 << Newton::kFractionBits))));
  record.output.status = kContact;
  return record;
}

trace::Trace trace_of(const std::vector<TraceRecord>& records) {
  TraceHeader header;
  header.has_outputs = true;
  return {"felt.trace", header, records};
}

/// In and out again, twice, with a pause between.
std::vector<TraceRecord> two_presses() {
  std::vector<TraceRecord> records;
  for (int press = 0; press < 2; ++press) {
    for (int i = 0; i < 100; ++i) records.push_back(pressed(-1));
    for (int i = 0; i <= 100; ++i) records.push_back(pressed(2 * std::sin(i * M_PI / 100)));
  }
  return records;
}

float float_at(const std::string& bytes, std::size_t at) {
  return std::bit_cast<float>(load_le<std::uint32_t>(reinterpret_cast<const std::uint8_t*>(bytes.data()) + at));
}

TEST(Recording, ARowHoldsWhatTheTickHeld) {
  const Recording recording(trace_of({pressed(0.5), pressed(1.5)}), nullptr);
  const std::string rows = recording.rows(0, 10);
  ASSERT_EQ(rows.size(), 2 * kRowBytes);
  EXPECT_FLOAT_EQ(float_at(rows, kRowBytes + 8), -1.5F);
  EXPECT_FLOAT_EQ(float_at(rows, kRowBytes + 32), 1.5F);
  EXPECT_FLOAT_EQ(float_at(rows, kRowBytes + 36), 1.5F);
  EXPECT_EQ(recording.rows(1, 10), rows.substr(kRowBytes));
  EXPECT_EQ(recording.rows(2, 10), "");
  EXPECT_EQ(recording.rows(~std::size_t{0}, 10), "");
}

/// A device's tick says zeros as long as nobody knows where the hand is: before homing, and while its pose is uncertain.
TEST(Recording, APlaceThatIsNotKnownIsNoPlace) {
  std::vector<TraceRecord> records{pressed(0), pressed(1), pressed(1), pressed(0)};
  for (TraceRecord& record : records) {
    record.input.kind = InputKind::kPacket;
    record.output.state = static_cast<std::uint16_t>(SupervisorState::kActive);
    record.output.hip.x = record.output.proxy.x = Mm::of(30);
  }
  records[2].output = {};
  records[2].output.state = static_cast<std::uint16_t>(SupervisorState::kHold);
  records[2].output.status = kPoseUncertain;
  const std::string rows = Recording(trace_of(records), nullptr).rows(0, 4);
  for (const std::size_t row : {0U, 1U, 2U, 3U}) {
    for (std::size_t column = 0; column < 6; ++column) EXPECT_EQ(std::isnan(float_at(rows, row * kRowBytes + 4 * column)), row == 2);
    EXPECT_FLOAT_EQ(float_at(rows, row * kRowBytes + 40), 0) << "a way from or to nowhere is no work";
  }
  const std::string of_a_position = Recording(trace_of({pressed(0)}), nullptr).rows(0, 1);
  EXPECT_FLOAT_EQ(float_at(of_a_position, 0), 0);
}

TEST(Recording, AHandThatPressesGivesEnergyAndGetsItBack) {
  const Recording recording(trace_of(two_presses()), nullptr);
  const std::string rows = recording.rows(0, recording.ticks());
  const auto energy = [&](std::size_t tick) { return float_at(rows, tick * kRowBytes + 40); };
  EXPECT_NEAR(energy(150), -2.0F, 0.1F);  // half of k x², x = 2 mm
  EXPECT_NEAR(energy(recording.ticks() - 1), 0.0F, 0.2F);
}

TEST(Recording, EachContactIsOneEvent) {
  const nlohmann::ordered_json summary = Recording(trace_of(two_presses()), nullptr).summary();
  ASSERT_EQ(summary["events"].size(), 2U);
  EXPECT_EQ(summary["events"][0]["kind"], "contact");
  EXPECT_EQ(summary["events"][0]["tick"], 101);
  EXPECT_EQ(summary["events"][1]["tick"], 302);
}

TEST(Recording, AnotherFieldIsAnEventAndAPatchIsOneOfItsOwn) {
  std::vector<TraceRecord> records(10);
  for (std::size_t i = 0; i < 10; ++i) records[i].input.field_generation = i < 3 ? 1 : i < 6 ? 2 : 3;
  records[3].input.requests = kRequestMoved;
  const nlohmann::ordered_json summary = Recording(trace_of(records), nullptr).summary(), events = summary["events"];
  std::size_t fields = 0;
  for (const auto& event : events) fields += event["kind"] == "field" ? 1U : 0U;
  EXPECT_EQ(fields, 1U) << events;
  EXPECT_EQ(events.back()["tick"], 6) << events;
  EXPECT_EQ(summary["is_patched"], true);
  EXPECT_EQ(events[events.size() - 2]["kind"], "patch") << events;
  EXPECT_EQ(events[events.size() - 2]["tick"], 3) << events;
  EXPECT_EQ(Recording(trace_of(two_presses()), nullptr).summary()["is_patched"], false);
}

TEST(Recording, WhatBeginsWithAPatchIsOfOneField) {
  std::vector<TraceRecord> records(10, pressed(-1));
  for (TraceRecord& record : records) record.input.field_generation = 3;
  records[0].input.requests = kRequestMoved;
  records[0].input.moved_to = 7;
  const auto summary_of = [&](std::uint64_t field) {
    TraceHeader header;
    header.has_outputs = true;
    header.field_hash = field;
    return Recording({"fault-1.trace", header, records}, nullptr).summary();
  };
  EXPECT_EQ(summary_of(0x900000007)["is_patched"], false);
  EXPECT_EQ(summary_of(0x900000007)["events"].size(), 0U) << summary_of(0x900000007);
  EXPECT_EQ(summary_of(0x900000008)["is_patched"], true);
  EXPECT_EQ(summary_of(0x900000008)["events"][0]["kind"], "patch");
}

TEST(Recording, PatchesThatFollowEachOtherAreOneEvent) {
  std::vector<TraceRecord> records(4000);
  for (TraceRecord& record : records) record.input.field_generation = 1;
  for (const std::size_t tick : {500U, 600U, 1400U, 3000U}) records[tick].input.requests = kRequestMoved;
  std::vector<std::uint64_t> patched;
  const nlohmann::ordered_json summary = Recording(trace_of(records), nullptr).summary();
  for (const auto& event : summary["events"]) {
    if (event["kind"] == "patch") patched.push_back(event["tick"]);
  }
  EXPECT_EQ(patched, (std::vector<std::uint64_t>{500, 3000})) << summary;
}

TEST(Recording, SaysThatItsFileIsCutOff) {
  const ScratchFolder folder;
  const std::filesystem::path file = folder.path() / "hand.trace";
  TraceHeader header;
  header.has_outputs = true;
  trace::TraceWriter writer(file, header);
  Chain chain(header);  // tells how much of what is left is whole
  for (TraceRecord record : two_presses()) {
    record.chain = chain.extend(record.input, record.output);
    writer.append(record);
  }
  writer.finish();
  const std::vector<std::uint8_t> bytes = read_file(file);
  const auto is_cut_off = [&](std::size_t size) {
    write_file(file, bytes.data(), size);
    return Recording(trace::read_trace(file), nullptr).summary()["is_cut_off"].get<bool>();
  };
  EXPECT_FALSE(is_cut_off(bytes.size()));
  EXPECT_TRUE(is_cut_off(bytes.size() - 50));
}

TEST(Recording, SettingsFaultsAndStopsAreEvents) {
  std::vector<TraceRecord> records(10);
  for (TraceRecord& record : records) {
    record.input.field_generation = 1;
    record.output.state = static_cast<std::uint16_t>(SupervisorState::kActive);
  }
  records[3].input.change = {TickSetting::kFriction, Ratio::of(0.5).raw()};
  records[5].input.requests = kRequestStop;
  for (std::size_t i = 5; i < 10; ++i) {
    records[i].output.state = static_cast<std::uint16_t>(SupervisorState::kFault);
    records[i].output.faults = kFaultStopped;
  }
  const Recording recording(trace_of(records), nullptr);
  const nlohmann::ordered_json events = recording.summary()["events"];
  ASSERT_EQ(events.size(), 4U) << events;
  EXPECT_EQ(events[0]["kind"], "state");
  EXPECT_EQ(events[1]["text"], "friction = 0.5 ");
  EXPECT_EQ(events[2]["kind"], "stop");
  EXPECT_EQ(events[3]["kind"], "fault");
  EXPECT_EQ(recording.words(9)["fault"], true);
  EXPECT_NE(recording.words(9)["sentence"].get<std::string>().find("isotouch resume"), std::string::npos);
  EXPECT_EQ(recording.words(0)["state"], "active");
}

TEST(Recording, CurvesKeepTheLargest) {
  const Recording recording(trace_of(two_presses()), nullptr);
  for (const std::size_t pieces : {std::size_t{1}, std::size_t{7}, std::size_t{402}, std::size_t{5000}}) {
    const std::string curves = recording.curves(0, ~std::size_t{0}, pieces);
    const auto whole = [&](std::size_t at) { return load_le<std::uint32_t>(reinterpret_cast<const std::uint8_t*>(curves.data()) + at); };
    const std::size_t length = whole(4), count = whole(8);
    EXPECT_LE(count, pieces);
    EXPECT_GE(length * count, recording.ticks());
    ASSERT_EQ(curves.size(), 12 + 16 * count);
    float largest = 0;
    for (std::size_t i = 0; i < count; ++i) largest = std::max(largest, float_at(curves, 12 + 16 * i));
    EXPECT_FLOAT_EQ(largest, 2.0F);
  }
  EXPECT_EQ(recording.curves(50, 50, 10).size(), 12U);
}

TEST(Recording, InputsAloneNeedTheirField) {
  TraceHeader header;
  const std::vector<TraceRecord> records(3, [] {
    TraceRecord record;
    record.input = position_input({});
    return record;
  }());
  EXPECT_THROW(Recording(trace::Trace("hand.trace", header, records), nullptr), InputError);
  EXPECT_THROW(Recording(trace_of({}), nullptr), InputError);
}

}  // namespace
}  // namespace isotouch::server
