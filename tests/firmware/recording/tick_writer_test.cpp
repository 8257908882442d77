#include "firmware/recording/tick_writer.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

#include "shared/files/trace_file.h"
#include "tests/support/full_disk.h"
#include "tests/support/scratch_folder.h"

namespace isotouch::recording {
namespace {

namespace fs = std::filesystem;

TraceHeader header() {
  TraceHeader header;
  header.device = martin_hillier_model();
  header.period_ns = 500'000;
  return header;
}

loop::TickRecord tick(std::uint64_t number) {
  loop::TickRecord record;
  record.number = number;
  record.arrival_ns = std::int64_t(number) * 500'000 + 77;
  record.in.fresh = number % 4 != 0;
  record.in.age = record.in.fresh ? 0 : 1;
  record.in.packet = encode(FalconReply{{std::int16_t(number / 4 * 4), 0, 0}, 0, 7});
  record.out.commands = {std::int16_t(number), 2, 3};
  return record;
}

TEST(TickWriter, WhatIsWrittenIsReadBack) {
  const ScratchFolder folder;
  const std::string path = (folder.path() / "a.trace").string();
  TickWriter writer;
  ASSERT_EQ(writer.begin(path, header()).sentence(), "");
  for (std::uint64_t i = 1; i <= 100; ++i) ASSERT_EQ(writer.append(tick(i)).sentence(), "");
  EXPECT_FALSE(fs::exists(path)) << "before it is complete";
  ASSERT_EQ(writer.finish(42).sentence(), "");
  files::TraceFile trace;
  ASSERT_EQ(files::read_trace(path, trace).sentence(), "");
  EXPECT_EQ(trace.header().device, martin_hillier_model());
  EXPECT_EQ(trace.header().period_ns, 500'000U);
  EXPECT_EQ(trace.header().field_hash, 42U);
  EXPECT_TRUE(trace.header().has_outputs);
  ASSERT_EQ(trace.size(), 100U);
  Chain chain(trace.header());
  for (std::uint64_t i = 1; i <= 100; ++i) {
    const TraceRecord record = trace.record(i - 1);
    EXPECT_EQ(record.input, tick(i).in);
    EXPECT_EQ(record.output, tick(i).out);
    EXPECT_EQ(record.arrival_ns, (i - 1) * 500'000);
    EXPECT_EQ(record.chain, chain.extend(record.input, record.output));
  }
}

TEST(TickWriter, ARecordingWithoutTicksLeavesNoFile) {
  const ScratchFolder folder;
  const std::string path = (folder.path() / "a.trace").string();
  TickWriter writer;
  ASSERT_EQ(writer.begin(path, header()).sentence(), "");
  EXPECT_EQ(writer.finish(0).sentence(), "");
  EXPECT_TRUE(fs::is_empty(folder.path()));
}

TEST(TickWriter, AFolderThatIsNotThereIsToldInOneSentence) {
  TickWriter writer;
  EXPECT_EQ(writer.begin("/nowhere/a.trace", header()).sentence(),
            "/nowhere/a.trace: there is no folder /nowhere; make it, or name another one");
  EXPECT_FALSE(writer.is_open());
  EXPECT_EQ(writer.append(tick(1)).sentence(), "");
}

using trace_layout::kHeaderBytes;
using trace_layout::kRecordBytes;

/// Appends ticks to a recording on a disk that ends behind so many bytes of it, as the recorder does: until the first complaint, then it is finished.
struct OnFullDisk {
  OnFullDisk(const std::string& path, std::uint64_t bytes, std::uint64_t ticks) {
    const FullDisk disk(bytes);
    TickWriter writer;
    begun = writer.begin(path, header()).sentence();
    for (std::uint64_t i = 1; i <= ticks && appended.empty(); ++i) appended = writer.append(tick(i)).sentence();
    finished = writer.finish(42).sentence();
    records = writer.records();
  }
  std::string begun, appended, finished;
  std::uint64_t records = 0;
};

TEST(TickWriter, AFullDiskKeepsExactlyTheRecordsThatArrivedWhole) {
  const ScratchFolder folder;
  const std::string path = (folder.path() / "a.trace").string();
  for (const std::uint64_t whole : {1U, 37U, 200U, 1000U, 1999U}) {
    for (const std::uint64_t torn : {std::uint64_t{0}, std::uint64_t{1}, std::uint64_t{kRecordBytes - 1}}) {
      for (const std::uint64_t ticks : {whole + 1, std::uint64_t{2000}}) {  // noticed at the end, or on the way
        SCOPED_TRACE(std::to_string(whole) + " records and " + std::to_string(torn) + " bytes, of " + std::to_string(ticks));
        const OnFullDisk full(path, kHeaderBytes + whole * kRecordBytes + torn, ticks);
        EXPECT_EQ(full.begun, "");
        EXPECT_EQ(full.finished, path + ": the trace ends after " + std::to_string(whole) + " ticks: File too large; make room there");
        EXPECT_EQ(full.records, whole);
        EXPECT_EQ(fs::file_size(path), kHeaderBytes + whole * kRecordBytes);
        EXPECT_FALSE(fs::exists(path + ".part"));
        files::TraceFile trace;
        ASSERT_EQ(files::read_trace(path, trace).sentence(), "");
        ASSERT_EQ(trace.size(), whole);
        EXPECT_EQ(trace.header().field_hash, 42U);
        Chain chain(trace.header());
        for (std::uint64_t i = 1; i <= whole; ++i) {
          const TraceRecord record = trace.record(i - 1);
          ASSERT_EQ(record.input, tick(i).in) << i;
          ASSERT_EQ(record.chain, chain.extend(tick(i).in, tick(i).out)) << i;
        }
        fs::remove(path);
      }
    }
  }
}

TEST(TickWriter, AFullDiskIsNoticedOnTheWay) {
  const ScratchFolder folder;
  const std::string path = (folder.path() / "a.trace").string();
  EXPECT_EQ(OnFullDisk(path, kHeaderBytes + 100 * kRecordBytes, 2000).appended, path + ": the trace ends here: File too large");
}

TEST(TickWriter, ADiskWithoutRoomForARecordLeavesNoFile) {
  const ScratchFolder folder;
  const std::string path = (folder.path() / "a.trace").string();
  const OnFullDisk full(path, kHeaderBytes + kRecordBytes - 1, 10);
  EXPECT_EQ(full.finished, path + ": nothing was recorded: File too large; make room there");
  EXPECT_TRUE(fs::is_empty(folder.path()));
  const OnFullDisk fuller(path, kHeaderBytes - 1, 10);
  EXPECT_EQ(fuller.begun, path + ": the trace cannot be written: File too large");
  EXPECT_EQ(fuller.appended + fuller.finished, "") << "it did not begin";
  EXPECT_TRUE(fs::is_empty(folder.path()));
}

TEST(TickWriter, DamagedFilesAreRefusedWithTheirPlace) {
  const ScratchFolder folder;
  const std::string path = (folder.path() / "a.trace").string();
  TickWriter writer;
  ASSERT_EQ(writer.begin(path, header()).sentence(), "");
  for (std::uint64_t i = 1; i <= 5; ++i) ASSERT_EQ(writer.append(tick(i)).sentence(), "");
  ASSERT_EQ(writer.finish(0).sentence(), "");
  std::ifstream file(path, std::ios::binary);
  const std::string good((std::istreambuf_iterator<char>(file)), {});
  files::TraceFile trace;
  const auto complaint = [&](const std::string& bytes) {
    return files::read_trace(folder.write("b.trace", bytes).string(), trace).sentence();
  };
  EXPECT_EQ(complaint(good), "");
  EXPECT_EQ(complaint(good.substr(0, good.size() - 1)), "") << "a file that was cut off is read up to its last whole record";
  EXPECT_EQ(trace.size(), 4U);
  EXPECT_NE(trace.cut_off().find("; 1 ticks are missing"), std::string::npos);
  EXPECT_NE(complaint("").find("not usable as a trace"), std::string::npos);
  std::string bad = good;
  bad[kHeaderBytes + 3 * kRecordBytes + 4] = '\x80';
  EXPECT_NE(complaint(bad).find("record 3 at byte 568 holds an undefined value"), std::string::npos);
  EXPECT_NE(files::read_trace((folder.path() / "none").string(), trace).sentence().find("cannot be read"), std::string::npos);
}

}  // namespace
}  // namespace isotouch::recording
