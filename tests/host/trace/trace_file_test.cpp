#include "host/trace/trace_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <fstream>
#include <functional>
#include <iterator>
#include <string>
#include <utility>

#include "host/error.h"
#include "host/files/whole_file.h"
#include "shared/bytes.h"
#include "shared/crc32.h"
#include "tests/support/full_disk.h"
#include "tests/support/scratch_folder.h"

namespace isotouch::trace {
namespace {

using testing::HasSubstr;

TraceRecord record_at(std::size_t tick, bool outputs) {
  TraceRecord record;
  record.input.kind = InputKind::kPosition;
  record.input.hip = {Mm::from_raw(static_cast<std::int32_t>(1000 * tick)), Mm::of(-3.5), Mm::of(2047)};
  record.input.buttons = static_cast<std::uint8_t>(tick & 0xF);
  record.input.fresh = tick % 3 != 2;
  record.input.age = record.input.fresh ? 0 : 1;
  record.arrival_ns = 1'000'000 * tick;
  if (outputs) {
    record.output.force = {Newton::of(1), Newton::of(-2), Newton::from_raw(static_cast<std::int32_t>(tick))};
    record.output.status = kContact;
  }
  return record;
}

std::filesystem::path write_trace(const ScratchFolder& folder, std::size_t ticks, bool outputs) {
  TraceHeader header;
  header.field_hash = 42;
  header.has_outputs = outputs;
  const std::filesystem::path file = folder.path() / "a.trace";
  TraceWriter writer(file, header);
  Chain chain(header);
  for (std::size_t tick = 0; tick < ticks; ++tick) {
    TraceRecord record = record_at(tick, outputs);
    if (outputs) record.chain = chain.extend(record.input, record.output);
    writer.append(record);
  }
  writer.finish();
  return file;
}

std::string bytes_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

TEST(TraceFile, WhatWasWrittenIsRead) {
  const ScratchFolder folder;
  const Trace trace = read_trace(write_trace(folder, 100, true));
  ASSERT_EQ(trace.size(), 100U);
  EXPECT_EQ(trace.header().record_count, 100U);
  EXPECT_EQ(trace.header().field_hash, 42U);
  for (std::size_t tick = 0; tick < 100; ++tick) {
    const TraceRecord expected = record_at(tick, true);
    const TraceRecord read = trace.record(tick);
    EXPECT_EQ(read.input.hip, expected.input.hip);
    EXPECT_EQ(read.input.fresh, expected.input.fresh);
    EXPECT_EQ(read.output, expected.output);
    EXPECT_EQ(read.chain, trace.chain(tick));
    EXPECT_EQ(read.arrival_ns, expected.arrival_ns);
    EXPECT_TRUE(trace.chain_follows(tick));
  }
}

TEST(TraceFile, AnUnfinishedWriterLeavesTheOldFileAndNothingElse) {
  const ScratchFolder folder;
  const std::filesystem::path file = write_trace(folder, 5, true);
  const std::string before = bytes_of(file);
  {
    TraceWriter writer(file, {});
    writer.append(record_at(0, false));
  }
  EXPECT_EQ(bytes_of(file), before);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1);
}

TEST(TraceFile, WhatAKilledWriterLeavesIsReadUpToItsLastWholeRecord) {
  const ScratchFolder folder;
  const std::filesystem::path part = folder.path() / "a.trace.part";
  std::string left;
  {
    TraceHeader header;
    header.has_outputs = true;
    Chain chain(header);
    TraceWriter writer(folder.path() / "a.trace", header);
    for (std::size_t tick = 0; tick < 1000; ++tick) {
      TraceRecord record = record_at(tick, true);
      record.chain = chain.extend(record.input, record.output);
      writer.append(record);
    }
    left = bytes_of(part);  // as a kill leaves it
  }
  ASSERT_FALSE(left.empty());
  for (const std::size_t lost : {0U, 1U, 103U, 104U, 250U}) {
    const std::filesystem::path file = folder.write("left.trace", left.substr(0, left.size() - lost));
    const Trace trace = read_trace(file);
    const std::size_t whole = (left.size() - lost - 256) / 104;
    EXPECT_GE(whole, 700U) << lost;
    ASSERT_EQ(trace.size(), whole) << lost;
    EXPECT_EQ(trace.header().record_count, whole);
    EXPECT_TRUE(trace.chain_follows(whole - 1));
    EXPECT_THAT(trace.cut_off(), HasSubstr("it holds " + std::to_string(whole) + " whole ticks; it is not known how many are missing"))
        << lost;
  }
  std::string torn = left;  // a power cut may leave zeros, or the blocks of another file
  std::fill(torn.begin() + 256 + 104 * 500, torn.end(), '\0');
  EXPECT_EQ(read_trace(folder.write("torn.trace", torn)).size(), 500U);
  torn = left;
  torn[256 + 104 * 300 + 60] ^= 1;
  EXPECT_EQ(read_trace(folder.write("torn.trace", torn)).size(), 300U);
}

TEST(TraceFile, AFinishedFileThatWasCutSaysHowMuchIsMissing) {
  const ScratchFolder folder;
  EXPECT_EQ(read_trace(write_trace(folder, 10, true)).cut_off(), "");
  for (const bool outputs : {true, false}) {
    std::string bytes = bytes_of(write_trace(folder, 10, outputs));
    bytes.resize(bytes.size() - 130);
    const Trace trace = read_trace(folder.write("cut.trace", bytes));
    EXPECT_EQ(trace.size(), 8U);
    EXPECT_THAT(trace.cut_off(), HasSubstr("it holds 8 whole ticks; 2 ticks are missing"));
  }
}

TEST(TraceFile, APartThatIsASymbolicLinkIsNotFollowed) {
  const ScratchFolder folder;
  const std::filesystem::path victim = folder.write("victim", "precious");
  std::filesystem::create_symlink(victim, folder.path() / "a.trace.part");
  try {
    const TraceWriter writer(folder.path() / "a.trace", {});
    ADD_FAILURE() << "the link was followed";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("a.trace.part: is a symbolic link"));
  }
  EXPECT_EQ(bytes_of(victim), "precious");
}

TEST(TraceFile, ALinkStaysAndItsTargetIsReplaced) {
  const ScratchFolder folder;
  const std::filesystem::path there = folder.write("there", "old"), link = folder.path() / "a.trace";
  std::filesystem::create_symlink("there", link);
  write_trace(folder, 5, true);
  EXPECT_TRUE(std::filesystem::is_symlink(link));
  EXPECT_EQ(read_trace(there).size(), 5U);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 2);
}

TEST(TraceFile, TwoWritersOfOneTraceDoNotMeet) {
  const ScratchFolder folder;
  const std::filesystem::path file = folder.path() / "a.trace";
  TraceWriter first(file, {});
  first.append(record_at(0, false));
  for (const files::Leftover leftover : {files::Leftover::kReplace, files::Leftover::kRefuse}) {
    try {
      const TraceWriter second(file, {}, leftover);
      ADD_FAILURE() << "both write it";
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), HasSubstr("a.trace.part: another program is writing there"));
    }
  }
  first.finish();
  EXPECT_EQ(read_trace(file).size(), 1U);
  EXPECT_FALSE(std::filesystem::exists(file.string() + ".part"));
}

TEST(TraceFile, WhatAKillLeftOfARecordingIsNotWrittenOver) {
  const ScratchFolder folder;
  const std::filesystem::path file = folder.path() / "a.trace", part = folder.write("a.trace.part", "seven minutes");
  try {
    const TraceWriter writer(file, {}, files::Leftover::kRefuse);
    ADD_FAILURE() << "it is gone";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("a.trace.part: is left of a recording that was cut off; rename it to keep it, or remove it"));
  }
  EXPECT_EQ(bytes_of(part), "seven minutes");
  TraceWriter again(file, {});  // what can be made again
  again.append(record_at(0, false));
  again.finish();
  EXPECT_EQ(read_trace(file).size(), 1U);
}

TEST(TraceFile, APartOfAControllersRecordingIsWrittenOverByNobody) {
  const ScratchFolder folder;
  const std::filesystem::path file = folder.path() / "a.trace", part = folder.path() / "a.trace.part";
  const auto leave_part = [&](std::uint64_t settings_checksum, std::size_t ticks) {
    TraceHeader header;
    header.has_outputs = true;
    header.settings_checksum = settings_checksum;
    header.record_count = kUnfinished;
    std::ofstream out(part, std::ios::binary);
    const TraceHeaderBytes begin = encode(header);
    out.write(reinterpret_cast<const char*>(begin.data()), begin.size());
    for (std::size_t tick = 0; tick < ticks; ++tick) {
      const TraceRecordBytes record = encode(record_at(tick, true));
      out.write(reinterpret_cast<const char*>(record.data()), record.size());
    }
  };
  leave_part(7, 3);
  const std::string recorded = bytes_of(part);
  const std::string kept = "a.trace.part: is left of a recording that was cut off; rename it to keep it, or remove it";
  EXPECT_THAT([&] { const TraceWriter writer(file, {}); }, testing::ThrowsMessage<InputError>(HasSubstr(kept)));
  EXPECT_THAT([&] { write_file(file, "anything"); }, testing::ThrowsMessage<InputError>(HasSubstr(kept)));
  EXPECT_EQ(bytes_of(part), recorded);
  for (const auto& [settings_checksum, ticks] : {std::pair{0, 3}, {7, 0}}) {  // what no controller recorded, and what holds nothing
    leave_part(static_cast<std::uint64_t>(settings_checksum), static_cast<std::size_t>(ticks));
    write_file(file, "anything");
    EXPECT_EQ(bytes_of(file), "anything");
    EXPECT_FALSE(std::filesystem::exists(part));
  }
}

/// Whoever may write into /dev would otherwise have a file there instead of the device.
TEST(TraceFile, WhatIsNoFileIsNotReplaced) {
  const ScratchFolder folder;
  const std::string pipe = (folder.path() / "a.trace").string();
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  for (const std::string& name : {pipe, folder.path().string()}) {
    try {
      const TraceWriter writer(name, {});
      ADD_FAILURE() << name << " is written";
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), HasSubstr(name + ": is a folder, a device or a pipe; name a file for the trace"));
    }
  }
  EXPECT_TRUE(std::filesystem::is_fifo(pipe));
  EXPECT_FALSE(std::filesystem::exists(pipe + ".part"));
}

/// So many records on a disk with room for fewer.
struct CutTrace {
  CutTrace(const ScratchFolder& folder, std::size_t ticks, std::uint64_t room)
      : disk(room), file(folder.path() / "a.trace"), writer(file, header) {
    Chain chain(header);
    for (std::size_t tick = 0; tick < ticks; ++tick) {
      TraceRecord record = record_at(tick, true);
      record.chain = chain.extend(record.input, record.output);
      writer.append(record);
    }
  }
  FullDisk disk;
  TraceHeader header = [] {
    TraceHeader made;
    made.has_outputs = true;
    return made;
  }();
  std::filesystem::path file;
  TraceWriter writer;
};

std::uint64_t room_for(std::uint64_t records) { return trace_layout::kHeaderBytes + records * trace_layout::kRecordBytes; }

TEST(TraceFile, AFullDiskKeepsTheWholeRecordsThatItTook) {
  for (const std::size_t ticks : {701UL, 2000UL, 5000UL}) {  // noticed at the end, or on the way
    const ScratchFolder folder;
    const auto [records, chain] = CutTrace(folder, ticks, room_for(700) + 7).writer.finish_with_what_fits();
    EXPECT_EQ(records, 700U);
    const Trace trace = read_trace(folder.path() / "a.trace");
    ASSERT_EQ(trace.size(), 700U);
    for (std::size_t tick = 0; tick < 700; ++tick) ASSERT_TRUE(trace.chain_follows(tick)) << tick;
    EXPECT_EQ(trace.chain(699), chain);
  }
}

TEST(TraceFile, ADiskWithRoomForAllKeepsAll) {
  const ScratchFolder folder;
  const auto [records, chain] = CutTrace(folder, 700, room_for(700)).writer.finish_with_what_fits();
  EXPECT_EQ(records, 700U);
  EXPECT_EQ(read_trace(folder.path() / "a.trace").chain(699), chain);
}

TEST(TraceFile, AFullDiskIsAnErrorWhereAllOrNothingWasWantedOrNothingFits) {
  const ScratchFolder folder;
  EXPECT_THROW(CutTrace(folder, 2000, room_for(700)).writer.finish(), InputError);
  EXPECT_THROW(CutTrace(folder, 2000, room_for(1) - 1).writer.finish_with_what_fits(), InputError);
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(TraceFile, WhatGetsNoNameIsNotKept) {
  const ScratchFolder folder;
  const std::filesystem::path gone = folder.path() / "gone";
  std::filesystem::create_directory(gone);
  TraceWriter writer(gone / "a.trace", {});
  writer.append({});
  std::filesystem::remove_all(gone);
  try {
    const TraceWriter::Kept kept = writer.finish_with_what_fits();
    ADD_FAILURE() << kept.records << " records are said to be kept";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("a.trace: the trace cannot be completed: No such file or directory"));
  }
}

TEST(TraceFile, AHeaderThatCouldNotBeReadAgainIsRefused) {
  const ScratchFolder folder;
  TraceHeader header;
  header.settings.force_limit = Newton::of(50.1);
  EXPECT_THROW(TraceWriter(folder.path() / "a.trace", header), InputError);
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(TraceFile, AWriterWithoutItsFolderSaysSo) {
  const ScratchFolder folder;
  EXPECT_THROW(TraceWriter(folder.path() / "missing" / "a.trace", {}), InputError);
}

TEST(TraceFile, ARecordedChainBreaksWhereABitWasFlipped) {
  const ScratchFolder folder;
  const std::filesystem::path file = write_trace(folder, 50, true);
  std::string bytes = bytes_of(file);
  bytes[256 + 104 * 17 + 46] ^= 1;
  const std::string sentence = (folder.path() / "b.trace").string() +
                               ": the chain breaks at record 17: its bytes were changed after they were recorded; use the original file";
  EXPECT_THAT([&] { (void)read_trace(folder.write("b.trace", bytes)); }, testing::ThrowsMessage<InputError>(sentence));
  testing::internal::CaptureStderr();
  const Trace trace = read_trace(folder.write("b.trace", bytes), Damaged::kReport);
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "isotouch: " + sentence + '\n');
  EXPECT_EQ(trace.damage(), sentence);
  for (std::size_t tick = 0; tick < 50; ++tick) EXPECT_EQ(trace.chain_follows(tick), tick != 17) << tick;
  EXPECT_EQ(read_trace(file).damage(), "");
  EXPECT_EQ(read_trace(write_trace(folder, 50, false)).damage(), "") << "without outputs there is no chain";
}

/// Restates the header's checksum, so that the refusal is about the field itself.
void seal(std::string& bytes) {
  auto* at = reinterpret_cast<std::uint8_t*>(bytes.data());
  store_le(at + 252, crc32(at, 252));
}

struct Malformed {
  const char* name;
  std::function<void(std::string&)> damage;
  bool outputs;
  const char* sentence;
};

TEST(TraceFile, EveryMalformedTraceGetsItsSentence) {
  const Malformed cases[] = {
      {"empty", [](std::string& b) { b.clear(); }, true, "not a file of this kind"},
      {"not a trace", [](std::string& b) { b[0] = 'X'; }, true, "not a file of this kind"},
      {"half a header", [](std::string& b) { b.resize(50); }, true, "ends before"},
      {"newer major", [](std::string& b) { b[4] = 4; }, true, "another format version"},
      {"older major", [](std::string& b) { b[4] = 2; }, true, "another format version"},
      {"flipped header bit", [](std::string& b) { b[40] = static_cast<char>(b[40] ^ 4); }, true, "checksum"},
      {"period of zero", [](std::string& b) { store_le(reinterpret_cast<std::uint8_t*>(b.data()) + 36, 0U), seal(b); }, true,
       "header field"},
      {"no whole record", [](std::string& b) { b.resize(256 + 103); }, true, "ends before"},
      {"no record that is whole", [](std::string& b) { b.resize(256 + 104), b[256 + 1] = 2; }, true, "cut off before its first tick"},
      {"bytes after the last record", [](std::string& b) { b += "trailing"; }, true, "contradict"},
      {"undefined button", [](std::string& b) { b[256 + 104 * 3 + 28] = 0x40; }, true, "record 3 at byte 568"},
      {"fresh with an age", [](std::string& b) { b[256 + 104 * 4 + 6] = 1; }, true, "record 4 at byte 672"},
      {"packets among positions", [](std::string& b) { b[256 + 104 * 5] = 1; }, true, "record 5 at byte 776"},
      {"outputs that the header denies", [](std::string& b) { b[256 + 104 * 2 + 46] = 1; }, false, "record 2 at byte 464"},
  };
  for (const Malformed& malformed : cases) {
    const ScratchFolder folder;
    std::string bytes = bytes_of(write_trace(folder, 10, malformed.outputs));
    malformed.damage(bytes);
    const std::filesystem::path file = folder.write("bad.trace", bytes);
    try {
      read_trace(file);
      ADD_FAILURE() << malformed.name << " was accepted";
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), HasSubstr(file.string())) << malformed.name;
      EXPECT_THAT(error.what(), HasSubstr(malformed.sentence)) << malformed.name;
    }
  }
  const ScratchFolder folder;
  EXPECT_THROW(read_trace(folder.path() / "missing.trace"), InputError);
  EXPECT_THROW(read_trace(folder.path()), InputError);
}

}  // namespace
}  // namespace isotouch::trace
