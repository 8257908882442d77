#include "firmware/io/wire_trace_file.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "firmware/io/replay_port.h"
#include "firmware/loop/virtual_clock.h"
#include "tests/support/scratch_folder.h"

namespace isotouch::io {
namespace {

namespace fs = std::filesystem;

DeviceTraceHeader header() {
  DeviceTraceHeader header;
  header.device = martin_hillier_model();
  header.run.period_ns = 500'000;
  return header;
}

loop::TickRecord tick(std::uint64_t number) {
  loop::TickRecord record;
  record.number = number;
  record.arrival_ns = std::int64_t(number) * 500'000 + 77;
  record.in.fresh = number % 4 != 0;
  record.in.age = record.in.fresh ? 0 : 1;
  record.in.packet = encode(FalconReply{{std::int16_t(number / 4 * 4), 0, 0}, 0, 7});
  record.out.tick.words = {std::int16_t(number), 2, 3};
  return record;
}

TEST(WireTraceFile, WhatIsWrittenIsReadBack) {
  const ScratchFolder folder;
  const std::string path = (folder.path() / "a.trace").string();
  WireTraceWriter writer;
  ASSERT_EQ(writer.begin(path, header()), "");
  for (std::uint64_t i = 1; i <= 100; ++i) ASSERT_EQ(writer.append(tick(i)), "");
  EXPECT_FALSE(fs::exists(path)) << "before it is complete";
  ASSERT_EQ(writer.finish(42), "");
  WireTrace trace;
  ASSERT_EQ(read_wire_trace(path, trace), "");
  EXPECT_EQ(trace.header.device, martin_hillier_model());
  EXPECT_EQ(trace.header.run.period_ns, 500'000U);
  EXPECT_EQ(trace.header.run.blob_hash, 42U);
  EXPECT_TRUE(trace.header.has_outputs());
  ASSERT_EQ(trace.records.size(), 100U);
  DeviceChain chain(trace.header);
  for (std::uint64_t i = 1; i <= 100; ++i) {
    const DeviceTraceRecord& record = trace.records[i - 1];
    EXPECT_EQ(record.input, tick(i).in);
    EXPECT_EQ(record.output, tick(i).out);
    EXPECT_EQ(record.arrival_ns, (i - 1) * 500'000);
    EXPECT_EQ(record.chain, chain.extend(record.input, record.output));
  }
}

TEST(WireTraceFile, ARecordingWithoutTicksLeavesNoFile) {
  const ScratchFolder folder;
  const std::string path = (folder.path() / "a.trace").string();
  WireTraceWriter writer;
  ASSERT_EQ(writer.begin(path, header()), "");
  EXPECT_EQ(writer.finish(0), "");
  EXPECT_TRUE(fs::is_empty(folder.path()));
}

TEST(WireTraceFile, AFolderThatIsNotThereIsToldInOneSentence) {
  WireTraceWriter writer;
  EXPECT_EQ(writer.begin("/nowhere/a.trace", header()), "/nowhere/a.trace: the recording cannot be written: No such file or directory");
  EXPECT_FALSE(writer.is_open());
  EXPECT_EQ(writer.append(tick(1)), "");
}

TEST(WireTraceFile, AFullDiskIsToldInOneSentenceAndLeavesNoFile) {
  const ScratchFolder folder;
  const fs::path path = folder.path() / "a.trace";
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "no /dev/full";
  fs::create_symlink("/dev/full", path.string() + ".part");
  WireTraceWriter writer;
  std::string complaint = writer.begin(path.string(), header());
  for (std::uint64_t i = 1; i <= 10'000 && complaint.empty(); ++i) complaint = writer.append(tick(i));
  EXPECT_EQ(complaint, path.string() + ": the recording ends here: No space left on device");
  EXPECT_NE(writer.finish(0) + "x", "");
  EXPECT_FALSE(fs::exists(path));
}

TEST(WireTraceFile, DamagedFilesAreRefusedWithTheirPlace) {
  const ScratchFolder folder;
  const std::string path = (folder.path() / "a.trace").string();
  WireTraceWriter writer;
  ASSERT_EQ(writer.begin(path, header()), "");
  for (std::uint64_t i = 1; i <= 5; ++i) writer.append(tick(i));
  ASSERT_EQ(writer.finish(0), "");
  std::ifstream file(path, std::ios::binary);
  const std::string good((std::istreambuf_iterator<char>(file)), {});
  WireTrace trace;
  const auto complaint = [&](const std::string& bytes) { return read_wire_trace(folder.write("b.trace", bytes).string(), trace); };
  EXPECT_EQ(complaint(good), "");
  EXPECT_NE(complaint(good.substr(0, good.size() - 1)).find("this is no recording of a device"), std::string::npos);
  EXPECT_NE(complaint("").find("this is no recording of a device"), std::string::npos);
  std::string bad = good;
  bad[device_trace_layout::kHeaderBytes + 3 * device_trace_layout::kRecordBytes + 17] = '\x80';
  EXPECT_NE(complaint(bad).find("record 3: "), std::string::npos);
  EXPECT_NE(read_wire_trace((folder.path() / "none").string(), trace).find("cannot be read"), std::string::npos);
}

TEST(ReplayPort, GivesFreshPacketsSilenceBetweenAndAnEnd) {
  WireTrace trace;
  trace.header = header();
  for (std::uint64_t i = 1; i <= 8; ++i) trace.records.push_back({tick(i).in, {}, 0, 0});
  loop::VirtualClock clock;
  ReplayPort port(trace, clock);
  for (std::uint64_t i = 1; i <= 8; ++i) {
    FalconPacket packet{};
    const loop::Answer answer = port.exchange({{9, 9, 9}, 0}, packet);
    EXPECT_EQ(answer, i % 4 == 0 ? loop::Answer::kSilent : loop::Answer::kReply);
    if (answer == loop::Answer::kReply) {
      EXPECT_EQ(packet, tick(i).in.packet);
    }
    EXPECT_EQ(clock.now_ns(), std::int64_t(i) * 500'000);
  }
  FalconPacket packet{};
  EXPECT_EQ(port.exchange({}, packet), loop::Answer::kEnd);
}

}  // namespace
}  // namespace isotouch::io
