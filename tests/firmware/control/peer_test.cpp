#include "firmware/control/peer.h"

#include <grp.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>

namespace isotouch::control {
namespace {

using protocol::Role;

constexpr std::array<gid_t, 2> kOthers = {4711, 4712};

/// A program of its own, which is in two more groups, connects to itself. Ends with 0 when `peer_of` names user and groups.
[[noreturn]] void connect_with_more_groups() {
  std::array<int, 2> ends{};
  if (::setgroups(kOthers.size(), kOthers.data()) != 0 || ::socketpair(AF_UNIX, SOCK_STREAM, 0, ends.data()) != 0) ::_exit(2);
  const Peer peer = peer_of(ends[0]);
  const auto is_in = [&](gid_t group) { return std::find(peer.groups.begin(), peer.groups.end(), group) != peer.groups.end(); };
  ::_exit(peer.known && peer.user == ::geteuid() && is_in(::getegid()) && is_in(kOthers[0]) && is_in(kOthers[1]) ? 0 : 1);
}

TEST(PeerDeathTest, IsInEveryGroupThatItsProgramIsIn) {
  if (::geteuid() != 0) GTEST_SKIP() << "only root may join groups";
  EXPECT_EXIT(connect_with_more_groups(), ::testing::ExitedWithCode(0), "");
}

TEST(Peer, HasTheHighestRoleOfUserAndGroups) {
  const uid_t stranger = ::geteuid() + 1;
  const Peer peer = {true, stranger, {20, 30}};
  const Members user = {{stranger}, {}}, group = {{}, {10, 30}}, others = {{stranger + 1}, {10, 40}};
  EXPECT_EQ(role_of(peer, {}), Role::kNone);
  EXPECT_EQ(role_of(peer, {others, others, others}), Role::kNone);
  EXPECT_EQ(role_of(peer, {user, {}, {}}), Role::kWatch);
  EXPECT_EQ(role_of(peer, {group, others, others}), Role::kWatch);
  EXPECT_EQ(role_of(peer, {user, group, {}}), Role::kOperate);
  EXPECT_EQ(role_of(peer, {{}, user, {}}), Role::kOperate);
  EXPECT_EQ(role_of(peer, {user, user, group}), Role::kService);
  EXPECT_EQ(role_of(peer, {{}, {}, user}), Role::kService);
  EXPECT_EQ(role_of({true, ::geteuid(), {}}, {}), Role::kService) << "the program's own user";
  EXPECT_EQ(role_of({true, 0, {}}, {}), Role::kService);
  EXPECT_EQ(role_of({false, ::geteuid(), {30}}, {{}, {}, {{::geteuid()}, {30}}}), Role::kNone) << "nobody knows who it is";
}

}  // namespace
}  // namespace isotouch::control
