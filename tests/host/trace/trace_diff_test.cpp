#include "host/trace/trace_diff.h"

#include <gtest/gtest.h>

#include <fstream>
#include <functional>
#include <iterator>
#include <string>

#include "host/error.h"
#include "tests/support/scratch_folder.h"

namespace isotouch::trace {
namespace {

using Change = std::function<void(std::size_t, TraceRecord&)>;

/// A trace that tells the same story each time, but for what `change` does to its ticks before they enter the chain.
Trace story(const ScratchFolder& folder, const char* name, std::size_t ticks, const Change& change = {}, TraceHeader header = {}) {
  header.has_outputs = true;
  TraceWriter writer(folder.path() / name, header);
  Chain chain(header);
  for (std::size_t tick = 0; tick < ticks; ++tick) {
    TraceRecord record;
    record.input = position_input({});
    record.input.hip.x = Mm::from_raw(static_cast<std::int32_t>(tick * tick));
    record.output.force.z = Newton::from_raw(static_cast<std::int32_t>(7 * tick));
    record.arrival_ns = tick + static_cast<std::size_t>(name[0]);  // not the same twice, and not compared
    if (change) change(tick, record);
    record.chain = chain.extend(record.input, record.output);
    writer.append(record);
  }
  writer.finish();
  return read_trace(folder.path() / name);
}

TEST(TraceDiff, EqualRunsHaveNoDifferenceWhateverTheirArrivalTimes) {
  const ScratchFolder folder;
  EXPECT_FALSE(first_difference(story(folder, "a", 100), story(folder, "b", 100)).has_value());
}

TEST(TraceDiff, TheFirstTickAndFieldAreFoundWhereverTheyAre) {
  const ScratchFolder folder;
  const Trace a = story(folder, "a", 100);
  for (std::size_t where = 0; where < 100; ++where) {
    const Trace b = story(folder, "b", 100, [&](std::size_t tick, TraceRecord& record) {
      if (tick == where) record.output.force.y = Newton::from_raw(1);
      if (tick > where + 3) record.input.hip.z = Mm::from_raw(1);
    });
    const auto difference = first_difference(a, b);
    ASSERT_TRUE(difference.has_value());
    EXPECT_EQ(difference->tick, where);
    EXPECT_EQ(difference->field, "force.y");
  }
}

TEST(TraceDiff, EveryFieldHasItsName) {
  const ScratchFolder folder;
  const Trace a = story(folder, "a", 3);
  const std::pair<const char*, std::function<void(TraceRecord&)>> fields[] = {
      {"input.hip.x", [](TraceRecord& r) { r.input.hip.x = Mm::of(9); }},
      {"input.hip.y", [](TraceRecord& r) { r.input.hip.y = Mm::of(9); }},
      {"input.hip.z", [](TraceRecord& r) { r.input.hip.z = Mm::of(9); }},
      {"input.buttons", [](TraceRecord& r) { r.input.buttons = 1; }},
      {"input.fresh", [](TraceRecord& r) { r.input.fresh = false; }},
      {"proxy.x", [](TraceRecord& r) { r.output.proxy.x = Mm::of(9); }},
      {"proxy.y", [](TraceRecord& r) { r.output.proxy.y = Mm::of(9); }},
      {"proxy.z", [](TraceRecord& r) { r.output.proxy.z = Mm::of(9); }},
      {"force.x", [](TraceRecord& r) { r.output.force.x = Newton::of(9); }},
      {"force.y", [](TraceRecord& r) { r.output.force.y = Newton::of(9); }},
      {"force.z", [](TraceRecord& r) { r.output.force.z = Newton::of(9); }},
      {"commands[0]", [](TraceRecord& r) { r.output.commands[0] = 1; }},
      {"commands[1]", [](TraceRecord& r) { r.output.commands[1] = 1; }},
      {"commands[2]", [](TraceRecord& r) { r.output.commands[2] = 1; }},
      {"state", [](TraceRecord& r) { r.output.state = 1; }},
      {"status", [](TraceRecord& r) { r.output.status = 1; }},
  };
  for (const auto& [name, change] : fields) {
    const auto& apply = change;
    const Trace b = story(folder, "b", 3, [&](std::size_t tick, TraceRecord& r) { tick == 1 ? apply(r) : void(); });
    const auto difference = first_difference(a, b);
    ASSERT_TRUE(difference.has_value()) << name;
    EXPECT_EQ(difference->tick, 1U);
    EXPECT_EQ(difference->field, name);
  }
}

TEST(TraceDiff, HeadersThatDifferAreNamedBeforeAnyTick) {
  const ScratchFolder folder;
  const Trace a = story(folder, "a", 3);
  TraceHeader header;
  header.settings.stiffness = Stiffness::of(2);
  EXPECT_EQ(first_difference(a, story(folder, "b", 3, {}, header))->field, "settings");
  header = {};
  header.field_hash = 7;
  EXPECT_EQ(first_difference(a, story(folder, "b", 3, {}, header))->field, "field");
  header = {};
  header.period_ns = 500'000;
  EXPECT_EQ(first_difference(a, story(folder, "b", 3, {}, header))->field, "period");
  header = {};
  header.device.play = Mm{};
  EXPECT_EQ(first_difference(a, story(folder, "b", 3, {}, header))->field, "model");
}

TEST(TraceDiff, AShorterRunEndsWhereTheOtherGoesOn) {
  const ScratchFolder folder;
  const auto difference = first_difference(story(folder, "a", 10), story(folder, "b", 12));
  ASSERT_TRUE(difference.has_value());
  EXPECT_EQ(difference->tick, 10U);
  EXPECT_EQ(difference->field, "length");
}

/// Its chain is still that of the original.
TEST(TraceDiff, ARecordThatWasChangedAfterwardsIsFound) {
  const ScratchFolder folder;
  const Trace a = story(folder, "a", 100);
  std::ifstream in(a.path(), std::ios::binary);
  std::string bytes{std::istreambuf_iterator<char>(in), {}};
  const auto changed = [&](std::size_t byte) {
    std::string other = bytes;
    other[256 + 104 * 70 + byte] ^= 1;
    const Trace b = read_trace(folder.write("b", other), Damaged::kReport);
    const auto difference = first_difference(a, b);
    return difference ? std::to_string(difference->tick) + ' ' + difference->field : "none";
  };
  EXPECT_EQ(changed(56), "70 force.x");
  EXPECT_EQ(changed(90), "70 chain");
}

TEST(TraceDiff, NothingToCompareIsRefused) {
  const ScratchFolder folder;
  const Trace none = story(folder, "none", 0);
  const Trace some = story(folder, "some", 3);
  EXPECT_THROW((void)first_difference(none, none), InputError);
  TraceWriter writer(folder.path() / "inputs", {});
  writer.append({});
  writer.finish();
  EXPECT_THROW((void)first_difference(some, read_trace(folder.path() / "inputs")), InputError);
}

}  // namespace
}  // namespace isotouch::trace
