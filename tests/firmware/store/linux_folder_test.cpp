#include "firmware/store/linux_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <filesystem>
#include <string>
#include <vector>

#include "tests/support/scratch_folder.h"

namespace {

std::vector<ino_t> synced;  ///< files and folders, in order

}  // namespace

/// Comes before the C library's.
extern "C" int fsync(int file) {
  struct stat about {};
  if (::fstat(file, &about) == 0) synced.push_back(about.st_ino);
  return static_cast<int>(::syscall(SYS_fsync, file));
}

namespace isotouch::store {
namespace {

ino_t number_of(const std::filesystem::path& path) {
  struct stat about {};
  return ::stat(path.c_str(), &about) == 0 ? about.st_ino : 0;
}

const std::vector<std::uint8_t> kBytes = {1, 2, 3};

TEST(LinuxFolder, BelongsToOneAtATime) {
  const ScratchFolder scratch;
  const std::string path = (scratch.path() / "state").string();
  {
    const LinuxFolder first(path);
    ASSERT_TRUE(first.is_open());
    const LinuxFolder second(path);
    EXPECT_FALSE(second.is_open());
    EXPECT_EQ(second.trouble(), StoreError::kInUse);
  }
  EXPECT_TRUE(LinuxFolder(path).is_open());
}

TEST(LinuxFolder, DoesWhatItSays) {
  const ScratchFolder scratch;
  LinuxFolder folder((scratch.path() / "state").string());
  ASSERT_TRUE(folder.is_open());
  ASSERT_TRUE(folder.write("a", kBytes));
  ASSERT_TRUE(folder.sync("a"));
  ASSERT_TRUE(folder.write("b", std::vector<std::uint8_t>(10)));
  ASSERT_TRUE(folder.rename("a", "b"));
  ASSERT_TRUE(folder.sync_names());
  std::filesystem::create_directory(scratch.path() / "state" / "folder");
  EXPECT_THAT(folder.names(), testing::ElementsAre("b"));
  std::vector<std::uint8_t> out(5);
  EXPECT_EQ(folder.read("b", out).value(), 3U);
  out.resize(3);
  EXPECT_EQ(out, kBytes);
  EXPECT_EQ(folder.read("b", std::span(out).first(2)).error(), StoreError::kTooLarge);
  EXPECT_EQ(folder.size("a").error(), StoreError::kNotFound);
  EXPECT_EQ(folder.sync("a").error(), StoreError::kNotFound);
  ASSERT_TRUE(folder.remove("b"));
  EXPECT_EQ(folder.remove("b").error(), StoreError::kNotFound);
  struct stat about {};
  ASSERT_EQ(::stat((scratch.path() / "state").c_str(), &about), 0);
  EXPECT_EQ(about.st_mode & 0777U, 0700U) << "nobody else reads it";
}

TEST(LinuxFolder, AFileIsItsOwnersAlone) {
  const ScratchFolder scratch;
  LinuxFolder folder((scratch.path() / "state").string());
  const mode_t mask = ::umask(0);
  ASSERT_TRUE(folder.write("a", kBytes));
  ::umask(mask);
  EXPECT_EQ(std::filesystem::status(scratch.path() / "state" / "a").permissions(), std::filesystem::perms(0600));
}

TEST(LinuxFolder, WhatIsSyncedIsOnTheDisk) {
  const ScratchFolder scratch;
  LinuxFolder folder((scratch.path() / "state").string());
  ASSERT_TRUE(folder.write("a", kBytes));
  ASSERT_TRUE(folder.write("b", kBytes));
  synced.clear();
  ASSERT_TRUE(folder.sync("a"));
  EXPECT_THAT(synced, testing::ElementsAre(number_of(scratch.path() / "state" / "a")));
  synced.clear();
  ASSERT_TRUE(folder.sync_names());
  EXPECT_THAT(synced, testing::ElementsAre(number_of(scratch.path() / "state")));
}

TEST(LinuxFolder, NoLinkLeadsOutOfIt) {
  const ScratchFolder scratch;
  const std::string outside = scratch.write("outside", "untouched").string();
  LinuxFolder folder((scratch.path() / "state").string());
  std::filesystem::create_symlink(outside, scratch.path() / "state" / "link");
  EXPECT_FALSE(folder.write("link", kBytes));
  std::vector<std::uint8_t> out(50);
  EXPECT_FALSE(folder.read("link", out));
  EXPECT_EQ(std::filesystem::file_size(outside), 9U);
}

TEST(LinuxFolder, AFolderThatCannotBeIsNotOpen) {
  const ScratchFolder scratch;
  const LinuxFolder without_parent((scratch.path() / "no" / "state").string());
  EXPECT_FALSE(without_parent.is_open());
  EXPECT_EQ(without_parent.trouble(), StoreError::kNotFound);
  const LinuxFolder file(scratch.write("file", "").string());
  EXPECT_FALSE(file.is_open());
}

}  // namespace
}  // namespace isotouch::store
