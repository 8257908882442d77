#include "host/files/whole_file.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <grp.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <sys/xattr.h>
#include <unistd.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

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

constexpr uid_t kNobody = 65534;

struct Rights {
  uid_t owner;
  gid_t group;
  mode_t mode;
  bool operator==(const Rights&) const = default;
};

Rights rights_of(const std::filesystem::path& file) {
  struct stat found {};
  EXPECT_EQ(::stat(file.c_str(), &found), 0);
  return {found.st_uid, found.st_gid, found.st_mode & 07777};
}

/// By a user who is in no group but his own.
void write_as_nobody(const std::filesystem::path& file) {
  const pid_t child = ::fork();
  if (child == 0) {
    if (::setgroups(0, nullptr) != 0 || ::setegid(kNobody) != 0 || ::seteuid(kNobody) != 0) ::_exit(2);
    try {
      write_file(file, "new");
    } catch (const InputError&) {
      ::_exit(1);
    }
    ::_exit(0);
  }
  int status = -1;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  ASSERT_EQ(status, 0);
  EXPECT_EQ(std::filesystem::file_size(file), 3U);
}

TEST(Files, AFileThatIsReplacedKeepsItsOwnerAndGroup) {
  if (::geteuid() != 0) GTEST_SKIP() << "only root may give files away";
  const ScratchFolder folder;
  const auto file = folder.write("file", "private");
  ASSERT_EQ(::chown(file.c_str(), 7, 8), 0);
  ASSERT_EQ(::chmod(file.c_str(), 0640), 0);
  write_file(file, "new");
  EXPECT_EQ(rights_of(file), (Rights{7, 8, 0640}));
}

TEST(Files, AnotherGroupGetsNoMoreThanEverybodyHad) {
  if (::geteuid() != 0) GTEST_SKIP() << "only root may give files away";
  const ScratchFolder folder;
  ASSERT_EQ(::chmod(folder.path().c_str(), 0777), 0);
  const auto file = folder.write("file", "private");
  for (const auto& [before, after] : {std::pair{0660U, 0600U}, {0664U, 0644U}, {0606U, 0600U}, {0666U, 0666U}}) {
    ASSERT_EQ(::chown(file.c_str(), kNobody, 8), 0);
    ASSERT_EQ(::chmod(file.c_str(), before), 0);
    write_as_nobody(file);
    EXPECT_EQ(rights_of(file), (Rights{kNobody, kNobody, after}));
  }
}

/// As the kernel wants it: lets user 1234 write, and the owning group do nothing.
std::vector<std::uint16_t> list_for_a_guest() {
  constexpr std::uint16_t kOwner = 1, kUser = 2, kGroup = 4, kMask = 16, kOther = 32, kUnnamed = 0xffff;
  std::vector<std::uint16_t> list = {2, 0};
  const auto add = [&](std::uint16_t who, std::uint16_t may, std::uint16_t low, std::uint16_t high) {
    list.insert(list.end(), {who, may, low, high});
  };
  add(kOwner, 6, kUnnamed, kUnnamed);
  add(kUser, 6, 1234, 0);
  add(kGroup, 0, kUnnamed, kUnnamed);
  add(kMask, 6, kUnnamed, kUnnamed);
  add(kOther, 4, kUnnamed, kUnnamed);
  return list;
}

TEST(Files, AFileThatIsReplacedKeepsItsAccessList) {
  constexpr const char *kAccess = "system.posix_acl_access", *kDefault = "system.posix_acl_default";
  const ScratchFolder folder;
  const auto file = folder.write("file", "shared"), without = folder.write("without", "private");
  ASSERT_EQ(::chmod(without.c_str(), 0660), 0);
  const std::vector<std::uint16_t> list = list_for_a_guest();
  const std::size_t size = 2 * list.size();
  if (::setxattr(file.c_str(), kAccess, list.data(), size, 0) != 0) GTEST_SKIP() << "no access control lists here";
  ASSERT_EQ(::setxattr(folder.path().c_str(), kDefault, list.data(), size, 0), 0);
  const Rights before = rights_of(file);
  const auto found = [&](const std::filesystem::path& of) {
    std::vector<std::uint16_t> words(100);
    const ssize_t bytes = ::getxattr(of.c_str(), kAccess, words.data(), 2 * words.size());
    words.resize(bytes > 0 ? static_cast<std::size_t>(bytes) / 2 : 0);
    return words;
  };
  write_file(file, "new");
  EXPECT_EQ(found(file), list);
  EXPECT_EQ(rights_of(file), before);
  write_file(without, "new");
  EXPECT_TRUE(found(without).empty()) << "that of its folder is for new files";
  EXPECT_EQ(rights_of(without).mode, 0660U);
  if (::geteuid() != 0) return;
  ASSERT_EQ(::chmod(folder.path().c_str(), 0777), 0);
  ASSERT_EQ(::chown(file.c_str(), kNobody, 8), 0);
  write_as_nobody(file);
  EXPECT_TRUE(found(file).empty()) << "it speaks of another group";
  EXPECT_EQ(rights_of(file), (Rights{kNobody, kNobody, 0600}));
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
