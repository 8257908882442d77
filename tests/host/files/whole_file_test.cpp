#include "host/files/whole_file.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <string>

#include "host/error.h"
#include "shared/files/part_file.h"
#include "shared/files/scoped_file.h"
#include "tests/support/scratch_folder.h"

namespace isotouch {
namespace {

TEST(Files, WhatIsWrittenIsReadAndNoTemporaryStays) {
  const ScratchFolder folder;
  std::vector<std::uint8_t> bytes(200000);
  for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<std::uint8_t>(i * 31);
  const auto file = folder.write("data", "what was there before");
  write_file(file, bytes.data(), bytes.size());
  EXPECT_EQ(read_file(file), bytes);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1);
  write_file(file, nullptr, 0);
  EXPECT_TRUE(read_file(file).empty());
}

TEST(Files, FirstBytesAreThoseOfAFileAndTakeNoneOfAPipe) {
  const ScratchFolder folder;
  const auto begins = [](const std::filesystem::path& file) {
    const auto bytes = first_bytes(file);
    return std::string(bytes.begin(), bytes.end());
  };
  EXPECT_EQ(begins(folder.write("long", std::string(47, 'a') + "bc")), std::string(47, 'a') + "b");
  EXPECT_EQ(begins(folder.write("short", "abc")), "abc" + std::string(45, '\0'));
  const std::string none(48, '\0');
  EXPECT_EQ(begins(folder.path() / "missing"), none);
  EXPECT_EQ(begins(folder.path()), none);
  const std::string pipe = (folder.path() / "pipe").string();
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_EQ(begins(pipe), none) << "it does not even wait for a writer";
}

TEST(Files, ARefusalNamesTheFileAndTheReason) {
  const ScratchFolder folder;
  const std::string missing = (folder.path() / "missing").string();
  const std::string beneath = (folder.path() / "missing" / "file").string();
  const auto sentence = [](const auto& action) -> std::string {
    try {
      action();
    } catch (const InputError& e) {
      return e.what();
    }
    return "no refusal";
  };
  EXPECT_EQ(sentence([&] { read_file(missing); }), missing + ": cannot be read: No such file or directory");
  EXPECT_EQ(sentence([&] { read_file(folder.path()); }), folder.path().string() + ": cannot be read: it is a folder, name a file");
  EXPECT_EQ(sentence([&] { write_file(beneath, nullptr, 0); }), beneath + ": cannot be written: No such file or directory");
  EXPECT_EQ(sentence([&] { write_file(folder.path(), nullptr, 0); }),
            folder.path().string() + ": cannot be written: it is a folder, name a file");
}

TEST(Files, ALinkThatSomebodyLaidInTheWayIsNotFollowed) {
  const ScratchFolder folder;
  const std::filesystem::path victim = folder.path() / "victim", file = folder.path() / "file";
  write_file(victim, "kept");
  std::filesystem::create_symlink(victim, file.string() + ".part");
  EXPECT_THROW(write_file(file, "new"), InputError);
  EXPECT_EQ(std::filesystem::file_size(victim), 4U);
  EXPECT_FALSE(std::filesystem::exists(file));
}

TEST(Files, ALinkStaysAndItsTargetIsReplaced) {
  const ScratchFolder folder;
  std::filesystem::create_directory(folder.path() / "real");
  const auto there = folder.write("real/file", "old"), link = folder.path() / "link", dangling = folder.path() / "dangling";
  std::filesystem::create_symlink("real/file", link);
  std::filesystem::create_symlink("real/new", dangling);
  write_file(link, "new");
  write_file(dangling, "made");
  EXPECT_TRUE(std::filesystem::is_symlink(link) && std::filesystem::is_symlink(dangling));
  EXPECT_EQ(std::filesystem::file_size(there), 3U);
  EXPECT_EQ(read_file(there), read_file(link));
  EXPECT_EQ(std::filesystem::file_size(folder.path() / "real/new"), 4U);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path() / "real"), {}), 2);
}

/// As /dev/stdout is that a shell has sent to a file.
TEST(Files, AnOpenFileIsWrittenWhereItStands) {
  const ScratchFolder folder;
  const auto file = folder.write("file", "before ");
  const auto link = folder.path() / "link";
  const ScopedFile open(::open(file.c_str(), O_WRONLY | O_APPEND));
  std::filesystem::create_symlink("/proc/self/fd/" + std::to_string(open.number), link);
  write_file(link, "after");
  EXPECT_TRUE(std::filesystem::is_symlink(link));
  const auto bytes = read_file(file);
  EXPECT_EQ(std::string(bytes.begin(), bytes.end()), "before after");
}

TEST(Files, TwoWritersDoNotMeet) {
  const ScratchFolder folder;
  const auto file = folder.path() / "file";
  folder.write("file.part", "left of a killed program");
  {
    const files::OpenPart other = files::open_part(file.string() + ".part", files::Leftover::kReplace);
    const ScopedFile open(other.file);
    ASSERT_GE(open.number, 0) << other.refusal.sentence();
    EXPECT_THROW(write_file(file, "mine"), InputError);
    EXPECT_FALSE(std::filesystem::exists(file));
  }
  write_file(file, "mine");
  EXPECT_EQ(std::filesystem::file_size(file), 4U);
  EXPECT_FALSE(std::filesystem::exists(file.string() + ".part"));
}

TEST(Files, AFileThatIsReplacedKeepsItsPermissions) {
  const ScratchFolder folder;
  const auto mode = [](const std::filesystem::path& file) {
    struct stat found {};
    EXPECT_EQ(::stat(file.c_str(), &found), 0);
    return found.st_mode & 07777;
  };
  const auto file = folder.write("file", "private"), left = folder.write("file.part", "left of a killed program");
  const mode_t before = ::umask(022);
  for (const mode_t wanted : {0600U, 0640U, 0666U}) {
    ASSERT_EQ(::chmod(file.c_str(), wanted), 0);
    write_file(file, "new");
    EXPECT_EQ(mode(file), wanted);
  }
  write_file(folder.path() / "other", "new");
  EXPECT_EQ(mode(folder.path() / "other"), 0644U);
  ::umask(before);
}

TEST(Files, AFileThatMayNotBeWrittenIsNotReplaced) {
  const ScratchFolder folder;
  const auto file = folder.write("file", "kept");
  ASSERT_EQ(::chmod(file.c_str(), 0444), 0);
  ASSERT_EQ(::chmod(folder.path().c_str(), 0777), 0);
  const pid_t child = ::fork();
  if (child == 0) {  // who is root may write everything
    if (::geteuid() == 0 && ::seteuid(65534) != 0) ::_exit(2);
    try {
      write_file(file, "new");
    } catch (const InputError& error) {
      ::_exit(error.what() == file.string() + ": cannot be written: Permission denied" ? 0 : 3);
    }
    ::_exit(1);
  }
  int status = -1;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  EXPECT_EQ(status, 0);
  EXPECT_EQ(std::filesystem::file_size(file), 4U);
  EXPECT_FALSE(std::filesystem::exists(file.string() + ".part"));
}

TEST(Files, AFailedWriteLeavesTheOldFile) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
  const std::vector<std::uint8_t> bytes(100000);
  EXPECT_THROW(write_file("/dev/full", bytes.data(), bytes.size()), InputError);
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/full"));
}

}  // namespace
}  // namespace isotouch
