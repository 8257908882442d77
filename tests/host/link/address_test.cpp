#include "host/link/address.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "host/error.h"
#include "tests/support/scratch_folder.h"

namespace isotouch::link {
namespace {

using Words = std::vector<std::string>;

Words reached(const Address& address, const char* ssh) { return ssh_command(address, ssh, relay_command(address)); }

TEST(Address, AWholeOneIsRead) {
  const Address address = read_address("ssh://me@board.local:2222/run/isotouch.sock");
  EXPECT_EQ(address.user, "me");
  EXPECT_EQ(address.host, "board.local");
  EXPECT_EQ(address.port, "2222");
  EXPECT_EQ(address.socket, "/run/isotouch.sock");
  EXPECT_EQ(reached(address, "ssh"),
            (Words{"ssh", "-T", "-p", "2222", "-l", "me", "--", "board.local", "isotouchd relay '/run/isotouch.sock'"}));
}

TEST(Address, WhatIsLeftOutIsLeftToOthers) {
  EXPECT_EQ(reached(read_address("ssh://board"), "ssh"), (Words{"ssh", "-T", "--", "board", "isotouchd relay"}));
  EXPECT_EQ(reached(read_address("ssh://board/"), "ssh"), (Words{"ssh", "-T", "--", "board", "isotouchd relay"}));
  EXPECT_EQ(reached(read_address("ssh://[fe80::1%eth0]:22"), "x").at(5), "fe80::1%eth0");
  const Address local = read_address("unix:control.sock");
  EXPECT_FALSE(local.is_remote());
  EXPECT_EQ(local.socket, "control.sock");
}

TEST(Address, NothingInItBecomesAnOptionOrACommand) {
  EXPECT_EQ(reached(read_address("ssh://b/a'; reboot; '"), "ssh").back(), "isotouchd relay '/a'\\''; reboot; '\\'''");
  for (const char* text : {"ssh://-oProxyCommand=reboot", "ssh://-x@board", "ssh://a b", "ssh://a;b", "ssh://$(a)", "ssh://u'@b"}) {
    EXPECT_THROW((void)read_address(text), InputError) << text;
  }
}

TEST(Address, WhatIsNoneIsRefusedWithAnExample) {
  for (const char* text : {"", "board", "unix:", "tcp://board", "ssh://", "ssh:///socket", "ssh://@board", "ssh://board:", "ssh://board:0",
                           "ssh://board:65536", "ssh://board:22x", "ssh://[::1", "ssh://[]", "ssh://board:222222"}) {
    try {
      (void)read_address(text);
      ADD_FAILURE() << text;
    } catch (const InputError& e) {
      EXPECT_THAT(e.what(), testing::HasSubstr("write unix:PATH or ssh://")) << text;
    }
  }
}

TEST(Address, ASocketIsTheSameByWhateverPath) {
  const ScratchFolder folder;
  const std::string socket = folder.write("control", "").string(), other = folder.write("other", "").string();
  std::filesystem::create_symlink(socket, folder.path() / "link");
  const auto is_same = [](const std::string& a, const std::string& b) { return is_same_controller(read_address(a), read_address(b)); };
  EXPECT_TRUE(is_same("unix:" + socket, "unix:" + socket));
  EXPECT_TRUE(is_same("unix:" + socket, "unix:" + folder.path().string() + "/./control"));
  EXPECT_TRUE(is_same("unix:" + socket, "unix:" + (folder.path() / "link").string()));
  EXPECT_FALSE(is_same("unix:" + socket, "unix:" + other));
  EXPECT_FALSE(is_same("unix:" + socket, "unix:" + folder.path().string() + "/missing"));
  EXPECT_TRUE(is_same("ssh://me@board:22/control", "ssh://me@board:22/control"));
  EXPECT_FALSE(is_same("ssh://me@board/control", "ssh://me@bench/control"));
  EXPECT_FALSE(is_same("unix:" + socket, "ssh://me@board" + socket));
}

}  // namespace
}  // namespace isotouch::link
