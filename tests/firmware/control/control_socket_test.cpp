#include "firmware/control/control_socket.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/un.h>
#include <unistd.h>

#include <cstdio>
#include <cstring>
#include <functional>
#include <iterator>
#include <utility>

#include "tests/support/scratch_folder.h"

namespace {

mode_t mode_before_chmod = 0;            ///< of the last file that got another one
std::function<void()> before_listening;  ///< called once, and so is the next
std::function<void()> before_renaming;

}  // namespace

/// Comes before the C library's.
extern "C" int chmod(const char* path, mode_t mode) {
  struct stat about {};
  if (::stat(path, &about) == 0) mode_before_chmod = about.st_mode & 0777U;
  return static_cast<int>(::syscall(SYS_fchmodat, AT_FDCWD, path, mode));
}

extern "C" int listen(int socket, int queue) {
  if (const auto call = std::exchange(before_listening, nullptr)) call();
  return static_cast<int>(::syscall(SYS_listen, socket, queue));
}

extern "C" int rename(const char* from, const char* to) {
  if (const auto call = std::exchange(before_renaming, nullptr)) call();
  return static_cast<int>(::syscall(SYS_renameat2, AT_FDCWD, from, AT_FDCWD, to, 0));
}

namespace isotouch::control {
namespace {

namespace fs = std::filesystem;

/// A socket of somebody else's at that path; -1 when it cannot be.
int bound(const std::string& path, int type) {
  const int socket = ::socket(AF_UNIX, type | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  std::strncpy(address.sun_path, path.c_str(), sizeof address.sun_path - 1);
  return ::bind(socket, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0 ? socket : -1;
}

/// Connects without waiting. returns false: the door is full, or nobody is behind it
bool knock(const std::string& path) {
  const int socket = ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  std::strncpy(address.sun_path, path.c_str(), sizeof address.sun_path - 1);
  return ::connect(socket, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0;
}

std::string opened(const std::string& path) { return ControlSocket().open(path, 0600, std::nullopt).sentence(); }

/// In a process of its own, which must have an answer soon: says it and ends.
[[noreturn]] void open_and_say(const std::string& path) {
  ::alarm(5);
  std::fputs(opened(path).c_str(), stderr);
  ::_exit(0);
}

TEST(ControlSocket, AMissingFolderIsNamed) {
  EXPECT_EQ(opened("/nosuch/s"), "/nosuch/s: there is no folder /nosuch; make it, or name another one");
}

TEST(ControlSocket, ASocketThatNobodyListensAtIsReplaced) {
  const ScratchFolder folder;
  const std::string path = (folder.path() / "door").string();
  ::close(bound(path, SOCK_STREAM));  // as a program that was killed leaves it
  ASSERT_TRUE(fs::is_socket(path));
  ControlSocket door;
  EXPECT_EQ(door.open(path, 0640, std::nullopt).sentence(), "");
  EXPECT_EQ(fs::status(path).permissions(), fs::perms(0640));
  EXPECT_TRUE(knock(path));
  door.close();
  EXPECT_FALSE(fs::exists(path));
}

TEST(ControlSocket, NobodyComesInBeforeItsPermissionsHold) {
  const ScratchFolder folder;
  const std::string path = (folder.path() / "door").string();
  const mode_t mask = ::umask(0);
  mode_before_chmod = 0777;
  ControlSocket door;
  EXPECT_EQ(door.open(path, 0660, std::nullopt).sentence(), "");
  EXPECT_EQ(mode_before_chmod, 0U);
  EXPECT_EQ(::umask(mask), 0U) << "the program's mask is what it was";
}

TEST(ControlSocket, ASocketThatAnotherListensAtIsLeftToIt) {
  const ScratchFolder folder;
  const std::string path = (folder.path() / "door").string();
  ControlSocket door;
  ASSERT_EQ(door.open(path, 0600, std::nullopt).sentence(), "");
  EXPECT_EQ(opened(path), path + ": another program listens there; stop it or choose another path");
  EXPECT_TRUE(knock(path));
}

TEST(ControlSocket, WhoeverFindsItsFileFindsSomebodyBehindIt) {
  const ScratchFolder folder;
  const std::string path = (folder.path() / "door").string();
  bool was_there = true;
  before_listening = [&] { was_there = fs::exists(path); };
  ControlSocket door;
  ASSERT_EQ(door.open(path, 0600, std::nullopt).sentence(), "");
  EXPECT_FALSE(was_there);
  EXPECT_TRUE(knock(path));
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), {}), 1) << "it leaves other files";
}

/// One that opens the door at that moment of another one's opening gets it, and the other one is refused.
void expect_the_quicker_one(const ScratchFolder& folder, std::function<void()>& moment) {
  const std::string path = (folder.path() / "door").string();
  ControlSocket door, quicker;
  moment = [&] { EXPECT_EQ(quicker.open(path, 0600, std::nullopt).sentence(), ""); };
  EXPECT_EQ(door.open(path, 0600, std::nullopt).sentence(), path + ": another program listens there; stop it or choose another path");
  EXPECT_TRUE(knock(path));
  quicker.close();
  EXPECT_TRUE(fs::is_empty(folder.path()));
}

TEST(ControlSocket, OfTwoThatOpenItAtOnceOneDoes) { expect_the_quicker_one(ScratchFolder(), before_listening); }

TEST(ControlSocket, OfTwoThatReplaceADeadOneAtOnceOneDoes) {
  const ScratchFolder folder;
  ::close(bound((folder.path() / "door").string(), SOCK_STREAM));
  expect_the_quicker_one(folder, before_renaming);
}

TEST(ControlSocket, ThePathMayBeAsLongAsTheSystemLets) {
  const ScratchFolder folder;
  const std::string longest = folder.path().string() + '/' + std::string(106 - folder.path().string().size(), 'd');
  EXPECT_EQ(opened(longest), "");
  EXPECT_EQ(opened(longest + 'd'), longest + "d: is no path for a socket (1 to 107 characters); choose a shorter one");
}

TEST(ControlSocket, ASocketThatAnotherPutInItsPlaceIsLeftToIt) {
  const ScratchFolder folder;
  const std::string path = (folder.path() / "door").string();
  ControlSocket door, other;
  ASSERT_EQ(door.open(path, 0600, std::nullopt).sentence(), "");
  fs::remove(path);
  ASSERT_EQ(other.open(path, 0600, std::nullopt).sentence(), "");
  door.close();
  EXPECT_TRUE(knock(path));
}

TEST(ControlSocket, AHundredMayWaitInTurn) {
  const ScratchFolder folder;
  const std::string path = (folder.path() / "door").string();
  ControlSocket door;
  ASSERT_EQ(door.open(path, 0600, std::nullopt).sentence(), "");
  for (int waiting = 0; waiting < 100; ++waiting) ASSERT_TRUE(knock(path)) << waiting;
}

TEST(ControlSocket, ASocketOfAnotherTypeIsLeftAlone) {
  const ScratchFolder folder;
  const std::string path = (folder.path() / "door").string();
  const int other = bound(path, SOCK_SEQPACKET);
  ASSERT_EQ(::listen(other, 1), 0);
  EXPECT_EQ(opened(path), path + ": another program may listen there (Protocol wrong type for socket); stop it or choose another path");
  EXPECT_TRUE(fs::is_socket(path));
  ::close(other);
}

TEST(ControlSocketDeathTest, ADoorThatIsFullIsLeftAloneAndNotWaitedFor) {
  const ScratchFolder folder;
  const std::string path = (folder.path() / "door").string();
  const int other = bound(path, SOCK_STREAM);
  ASSERT_EQ(::listen(other, 0), 0);
  int waiting = 0;
  while (waiting < 1000 && knock(path)) ++waiting;
  ASSERT_LT(waiting, 1000) << "the door never fills";
  EXPECT_EXIT(open_and_say(path), ::testing::ExitedWithCode(0), "another program listens there; stop it");
  EXPECT_TRUE(fs::is_socket(path));
  ::close(other);
}

TEST(ControlSocketDeathTest, ADoorThatIsClosedToUsIsLeftAlone) {
  const ScratchFolder folder;
  const std::string path = (folder.path() / "door").string();
  ControlSocket door;
  ASSERT_EQ(door.open(path, 0000, std::nullopt).sentence(), "");
  fs::permissions(folder.path(), fs::perms(0777));  // whoever comes might take the file away
  const auto as_a_stranger = [&] {
    if (::getuid() == 0 && ::setuid(65534) != 0) ::_exit(1);
    open_and_say(path);
  };
  EXPECT_EXIT(as_a_stranger(), ::testing::ExitedWithCode(0), "another program may listen there .Permission denied.; stop it");
  EXPECT_TRUE(fs::is_socket(path));
}

TEST(ControlSocket, OtherFilesAreLeftAlone) {
  const ScratchFolder folder;
  const std::string path = folder.write("door", "mine").string();
  EXPECT_EQ(opened(path), path + ": is a file already, and no socket; choose another path or remove it");
  EXPECT_TRUE(fs::is_regular_file(path));
}

}  // namespace
}  // namespace isotouch::control
