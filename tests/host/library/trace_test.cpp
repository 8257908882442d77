#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "host/library/isotouch.h"
#include "shared/trace.h"
#include "tests/host/library/golden.h"
#include "tests/support/scratch_folder.h"

namespace isotouch {
namespace {

/// A trace that ends with the test.
class Trace {
 public:
  explicit Trace(const std::string& name) {
    EXPECT_EQ(isotouch_trace_load(test::golden(name).c_str(), &handle), ISOTOUCH_OK) << isotouch_last_error();
    EXPECT_EQ(isotouch_trace_describe(handle, &facts, sizeof facts), ISOTOUCH_OK) << isotouch_last_error();
  }
  ~Trace() { isotouch_free(handle); }
  Trace(const Trace&) = delete;
  Trace& operator=(const Trace&) = delete;

  isotouch_trace handle = 0;
  isotouch_trace_facts facts{};
};

TEST(LibraryTrace, SaysWhatItHolds) {
  const Trace positions("positions.trace"), packets("packets.trace");
  EXPECT_GT(positions.facts.ticks, 100U);
  EXPECT_EQ(positions.facts.has_packets, 0U);
  EXPECT_EQ(packets.facts.has_packets, 1U);
  EXPECT_EQ(packets.facts.has_outputs, 1U);
  EXPECT_EQ(packets.facts.period_ns, 1'000'000U);
  EXPECT_NE(packets.facts.replay_hash, 0U);
  std::int64_t chain = 0;
  EXPECT_DONE(isotouch_trace_integers(packets.handle, "chain", packets.facts.ticks - 1, 1, &chain));
  EXPECT_EQ(static_cast<std::uint64_t>(chain), packets.facts.replay_hash);
}

TEST(LibraryTrace, EveryColumnOfADeviceIsThereInBothForms) {
  const Trace packets("packets_faults.trace");
  const auto ticks = static_cast<std::size_t>(packets.facts.ticks);
  std::vector<double> reals(ticks);
  std::vector<std::int64_t> wholes(ticks);
  ASSERT_EQ(isotouch_trace_columns(), 33U);
  for (std::size_t column = 0; column < isotouch_trace_columns(); ++column) {
    std::uint32_t is_integer = 2;
    const char* const name = isotouch_trace_column(column, &is_integer);
    ASSERT_DONE(isotouch_trace_doubles(packets.handle, name, 0, ticks, reals.data())) << name;
    if (is_integer == 0) {
      EXPECT_REFUSED(isotouch_trace_integers(packets.handle, name, 0, ticks, wholes.data()), ISOTOUCH_BAD_ARGUMENT, "ask for doubles");
      continue;
    }
    ASSERT_DONE(isotouch_trace_integers(packets.handle, name, 0, ticks, wholes.data())) << name;
    for (std::size_t tick = 0; tick < ticks; ++tick) {
      if (std::isnan(reals[tick]))
        ASSERT_EQ(wholes[tick], -1) << name;
      else
        ASSERT_EQ(static_cast<double>(wholes[tick]), reals[tick]) << name;
    }
  }
  EXPECT_EQ(isotouch_trace_column(33, nullptr), nullptr);
  EXPECT_EQ(isotouch_trace_column(SIZE_MAX, nullptr), nullptr);
}

TEST(LibraryTrace, WhatPositionsLackIsSaid) {
  const Trace positions("positions.trace");
  double value = 0;
  EXPECT_REFUSED(isotouch_trace_doubles(positions.handle, "state", 0, 1, &value), ISOTOUCH_MISSING, "positions of a hand");
  EXPECT_DONE(isotouch_trace_doubles(positions.handle, "force_x_n", 0, 1, &value));
}

/// A replay of positions computes forces, but never a device's numbers.
TEST(LibraryTrace, WhatInputsLackIsSaidWithWhatHelps) {
  const ScratchFolder folder;
  const std::string path = (folder.path() / "inputs.trace").string();
  TraceHeader header;
  header.record_count = 1;
  const TraceHeaderBytes head = encode(header);
  const TraceRecordBytes tick = encode(TraceRecord{position_input({}), {}, 0, 0});
  std::ofstream(path, std::ios::binary)
      .write(reinterpret_cast<const char*>(head.data()), head.size())
      .write(reinterpret_cast<const char*>(tick.data()), tick.size());
  isotouch_trace inputs = 0;
  ASSERT_DONE(isotouch_trace_load(path.c_str(), &inputs));
  double value = 0;
  EXPECT_REFUSED(isotouch_trace_doubles(inputs, "force_x_n", 0, 1, &value), ISOTOUCH_MISSING, "isotouch replay FIELD TRACE -o");
  for (const char* column : {"homed", "state", "packet_flags", "command_1"})
    EXPECT_REFUSED(isotouch_trace_doubles(inputs, column, 0, 1, &value), ISOTOUCH_MISSING, "positions of a hand; record a device");
  EXPECT_DONE(isotouch_free(inputs));
}

TEST(LibraryTrace, WrongNamesAndRangesAreErrors) {
  const Trace trace("positions.trace");
  const std::uint64_t ticks = trace.facts.ticks;
  std::vector<double> values(4);
  EXPECT_REFUSED(isotouch_trace_doubles(trace.handle, "colour", 0, 1, values.data()), ISOTOUCH_BAD_ARGUMENT,
                 "choose one of tick, hip_x_mm");
  EXPECT_REFUSED(isotouch_trace_doubles(trace.handle, nullptr, 0, 1, values.data()), ISOTOUCH_BAD_ARGUMENT, "column");
  EXPECT_REFUSED(isotouch_trace_doubles(trace.handle, "tick", 0, 1, nullptr), ISOTOUCH_BAD_ARGUMENT, "values");
  EXPECT_REFUSED(isotouch_trace_doubles(trace.handle, "tick", ticks - 1, 2, values.data()), ISOTOUCH_BAD_ARGUMENT, "ticks");
  EXPECT_REFUSED(isotouch_trace_doubles(trace.handle, "tick", ticks + 1, 0, values.data()), ISOTOUCH_BAD_ARGUMENT, "ticks");
  EXPECT_REFUSED(isotouch_trace_doubles(trace.handle, "tick", UINT64_MAX, SIZE_MAX, values.data()), ISOTOUCH_BAD_ARGUMENT, "ticks");
  EXPECT_DONE(isotouch_trace_doubles(trace.handle, "tick", ticks, 0, nullptr));
  isotouch_trace other = 0;
  EXPECT_REFUSED(isotouch_trace_load(test::golden("field_1_1.itf").c_str(), &other), ISOTOUCH_BAD_DATA, "not usable as a trace");
  EXPECT_REFUSED(isotouch_trace_load("/nowhere.trace", &other), ISOTOUCH_BAD_DATA, "/nowhere.trace");
  const ScratchFolder folder;
  const auto changed = folder.path() / "changed.trace";
  std::filesystem::copy_file(test::golden("positions.trace"), changed);
  std::fstream(changed, std::ios::binary | std::ios::in | std::ios::out).seekp(256 + 104 * 3 + 88).put(1);
  EXPECT_REFUSED(isotouch_trace_load(changed.c_str(), &other), ISOTOUCH_BAD_DATA, "the chain breaks at record 3");
  isotouch_trace_facts facts{};
  EXPECT_REFUSED(isotouch_trace_describe(trace.handle, &facts, 3), ISOTOUCH_BAD_ARGUMENT, "isotouch_trace_facts");
}

}  // namespace
}  // namespace isotouch
