#include "firmware/control/relay.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <array>
#include <string>
#include <thread>
#include <vector>

#include "tests/firmware/control/control_rig.h"
#include "tests/firmware/store/packed_field.h"

namespace isotouch::control {
namespace {

/// A relay in a thread, and the far end of what would be ssh.
struct Relayed {
  explicit Relayed(const std::string& path) {
    EXPECT_EQ(::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()), 0);
    thread = std::thread([this, path] {
      complaint = relay(path, ends[1], ends[1]).sentence();
      ::shutdown(ends[1], SHUT_RDWR);
    });
  }
  ~Relayed() { join(); }
  void join() {
    if (!thread.joinable()) return;
    ::shutdown(ends[0], SHUT_RDWR);
    thread.join();
    for (const int end : ends) ::close(end);
  }
  /// A controller that refuses may have gone already.
  void say(std::span<const std::uint8_t> bytes) { (void)::send(ends[0], bytes.data(), bytes.size(), MSG_NOSIGNAL); }
  Heard hear() {
    std::vector<std::uint8_t> bytes(protocol::kMaxFrame);
    for (std::size_t size = 0;;) {
      const ssize_t got = ::read(ends[0], bytes.data() + size, bytes.size() - size);
      if (got <= 0) return {};
      size += static_cast<std::size_t>(got);
      const auto frame = protocol::read_frame(std::span(bytes).first(size));
      if (frame && frame->size > 0) return {frame->kind, {frame->body.begin(), frame->body.end()}};
    }
  }

  std::array<int, 2> ends{-1, -1};
  std::string complaint;
  std::thread thread;
};

std::vector<std::uint8_t> hello() {
  std::vector<std::uint8_t> frame(protocol::kMaxFrame);
  frame.resize(protocol::encode(protocol::Kind::kHello, protocol::Hello{}, frame));
  return frame;
}

TEST(Relay, PassesOnBothWays) {
  ControlRig rig;
  Relayed relayed(rig.settings.path);
  relayed.say(hello());
  EXPECT_EQ(relayed.hear().kind, protocol::Kind::kWelcome);
  relayed.join();
  EXPECT_EQ(relayed.complaint, "");
}

TEST(Relay, WhatARefusingControllerSaysArrives) {
  ControlRig rig(1 << 18, [](ControlSettings& settings) { settings.peer = [](int) { return Peer{true, 4711, {}}; }; });
  for (int round = 0; round < 50; ++round) {
    Relayed relayed(rig.settings.path);
    relayed.say(hello());
    EXPECT_THAT(relayed.hear().refusal(), testing::HasSubstr("user 4711 may not"));
  }
}

TEST(Relay, AControllerThatGoesIsNoGoodEnd) {
  ControlRig rig;
  Relayed relayed(rig.settings.path);
  relayed.say(hello());
  EXPECT_EQ(relayed.hear().kind, protocol::Kind::kWelcome);
  rig.server->stop();
  EXPECT_EQ(relayed.hear().kind, protocol::Kind{});
  relayed.join();
  EXPECT_THAT(relayed.complaint, testing::HasSubstr("the controller ended the connection"));
}

TEST(Relay, AControllerThatLetsNobodyInIsNotWaitedForForEver) {
  const ScratchFolder scratch;
  const std::string path = (scratch.path() / "full").string();
  const int door = ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  path.copy(address.sun_path, sizeof address.sun_path - 1);
  ASSERT_EQ(::bind(door, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
  ASSERT_EQ(::listen(door, 0), 0);
  const int first = connect_to_socket(path, 100);
  ASSERT_GE(first, 0);
  EXPECT_THAT(relay(path, 0, 1, 100).sentence(), testing::HasSubstr("the controller lets nobody in; press the emergency stop"));
  ::close(first);
  ::close(door);
}

TEST(Relay, WithoutAControllerItSaysSo) {
  const ScratchFolder scratch;
  const std::string path = (scratch.path() / "none").string();
  EXPECT_THAT(relay(path, 0, 1).sentence(), testing::AllOf(testing::HasSubstr(path), testing::HasSubstr("start isotouchd")));
}

}  // namespace
}  // namespace isotouch::control
