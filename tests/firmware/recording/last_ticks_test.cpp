#include "firmware/recording/last_ticks.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>

#include "tests/support/scratch_folder.h"

namespace isotouch::recording {
namespace {

LastTick tick(std::uint64_t number) {
  LastTick last;
  last.tick.number = number;
  last.tick.arrival_ns = static_cast<std::int64_t>(number) * 1'000'000;
  last.tick.in.packet = encode(FalconReply{{static_cast<std::int16_t>(number), 0, 0}, 0, 7});
  last.tick.in.fresh = true;
  last.tick.in.field_generation = 3;
  last.tick.out.commands = {static_cast<std::int16_t>(number), 2, 3};
  last.field_hash = 4711;
  return last;
}

TraceHeader some_header() {
  TraceHeader header;
  header.period_ns = 500'000;
  header.has_outputs = true;
  return header;
}

void expect_ticks(const std::string& path, std::uint64_t first, std::uint64_t last) {
  TraceHeader header;
  const std::vector<LastTick> ticks = LastTicks::read(path, header);
  ASSERT_EQ(ticks.size(), last - first + 1);
  EXPECT_EQ(header.period_ns, 500'000U);
  for (const LastTick& found : ticks) {
    const LastTick expected = tick(first++);
    EXPECT_EQ(found.tick.number, expected.tick.number);
    EXPECT_EQ(found.tick.arrival_ns, expected.tick.arrival_ns);
    EXPECT_EQ(found.tick.in, expected.tick.in);
    EXPECT_EQ(found.tick.out, expected.tick.out);
    EXPECT_EQ(found.field_hash, 4711U);
  }
}

TEST(LastTicks, AFileSystemWithoutRoomForAWriteEndsNothing) {
  const ScratchFolder folder;
  const std::string path = (folder.path() / "last").string();
  LastTicks last;
  ASSERT_FALSE(last.begin(path, some_header(), 50));
  std::filesystem::resize_file(path, 0);  // it takes the room away
  last.put(tick(1));
  last.end();
  EXPECT_FALSE(std::filesystem::exists(path));
}

TEST(LastTicks, SurviveAKill) {
  const ScratchFolder folder;
  const std::string path = (folder.path() / "last").string();
  const pid_t child = ::fork();
  if (child == 0) {
    LastTicks last;
    if (last.begin(path, some_header(), 50)) ::_exit(1);
    for (std::uint64_t number = 1; number <= 120; ++number) last.put(tick(number));
    ::kill(::getpid(), SIGKILL);
  }
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  ASSERT_TRUE(WIFSIGNALED(status));
  expect_ticks(path, 71, 120);
}

TEST(LastTicks, EndWithTheRunAndBeginWithoutTheOld) {
  const ScratchFolder folder;
  const std::string path = (folder.path() / "last").string();
  TraceHeader header;
  EXPECT_TRUE(LastTicks::read(path, header).empty());
  LastTicks last;
  ASSERT_EQ(last.begin(path, some_header(), 50).sentence(), "");
  EXPECT_TRUE(LastTicks::read(path, header).empty());
  for (std::uint64_t number = 1; number <= 20; ++number) last.put(tick(number));
  expect_ticks(path, 1, 20);
  ASSERT_EQ(last.begin(path, some_header(), 50).sentence(), "");
  EXPECT_TRUE(LastTicks::read(path, header).empty());
  last.end();
  EXPECT_FALSE(std::filesystem::exists(path));
  last.put(tick(1));
}

TEST(LastTicks, OnlyWholeTicksThatFollowEachOtherCount) {
  const ScratchFolder folder;
  const std::string path = (folder.path() / "last").string();
  LastTicks last;
  ASSERT_EQ(last.begin(path, some_header(), 50).sentence(), "");
  for (std::uint64_t number = 1; number <= 30; ++number) {
    if (number != 10) last.put(tick(number));
  }
  expect_ticks(path, 11, 30);
  std::fstream file(path, std::ios::binary | std::ios::in | std::ios::out);  // a tick is half written at the kill
  file.seekp(256 + 120 * 18 + 90);
  file.put('x');
  file.close();
  expect_ticks(path, 21, 30);
}

TEST(LastTicks, OnlyTheLastFieldCountsEvenIfItWasSentTwice) {
  const ScratchFolder folder;
  const std::string path = (folder.path() / "last").string();
  LastTicks last;
  ASSERT_EQ(last.begin(path, some_header(), 50).sentence(), "");
  for (std::uint64_t number = 1; number <= 20; ++number) {
    LastTick put = tick(number);  // generations 2 and 3 of one hash
    if (number <= 10) put.tick.in.field_generation = 2;
    last.put(put);
  }
  expect_ticks(path, 11, 20);
}

TEST(LastTicks, ALinkIsReplacedAndAFolderThatIsNotThereIsSaid) {
  const ScratchFolder folder;
  const std::filesystem::path victim = folder.write("victim", "precious");
  const std::string path = (folder.path() / "last").string();
  std::filesystem::create_symlink(victim, path);
  TraceHeader header;
  EXPECT_TRUE(LastTicks::read(path, header).empty());
  LastTicks last;
  ASSERT_EQ(last.begin(path, some_header(), 5).sentence(), "");
  EXPECT_EQ(std::filesystem::file_size(victim), 8U);
  EXPECT_NE(last.begin((folder.path() / "none" / "last").string(), some_header(), 5).sentence().find("cannot be kept"), std::string::npos);
}

}  // namespace
}  // namespace isotouch::recording
