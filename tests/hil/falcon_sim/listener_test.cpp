#include "hil/falcon_sim/listener.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <stdexcept>

#include "tests/hil/falcon_sim/socket_client.h"

namespace isotouch::falcon_sim {
namespace {

TEST(Listener, LetsInWhoComesAndTakesItsFileAway) {
  const auto path = socket_path("listener-in");
  {
    const Listener listener(path, SOCK_SEQPACKET);
    EXPECT_FALSE(listener.accept());
    const Descriptor client = connect_to(path, SOCK_SEQPACKET);
    ASSERT_TRUE(client);
    EXPECT_TRUE(listener.accept());
  }
  EXPECT_FALSE(std::filesystem::exists(path));
}

TEST(Listener, AMissingFolderIsNamed) {
  EXPECT_THAT([] { Listener("/nosuch/s", SOCK_SEQPACKET); },
              testing::ThrowsMessage<std::runtime_error>("/nosuch/s: there is no folder /nosuch; make it, or name another one"));
}

TEST(Listener, ReplacesOnlyASocketThatNobodyListensAt) {
  const auto path = socket_path("listener-stale");
  {
    const Listener first(path, SOCK_SEQPACKET);
    EXPECT_THROW(Listener(path, SOCK_SEQPACKET), std::runtime_error);
    EXPECT_THROW(Listener(path, SOCK_STREAM), std::runtime_error);
    EXPECT_TRUE(connect_to(path, SOCK_SEQPACKET));
  }
  {
    const Descriptor left(::socket(AF_UNIX, SOCK_STREAM, 0));  // as a program that was killed leaves it
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    std::strncpy(address.sun_path, path.c_str(), sizeof address.sun_path - 1);
    ASSERT_EQ(::bind(left.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
  }
  ASSERT_TRUE(std::filesystem::exists(path));
  EXPECT_NO_THROW(Listener(path, SOCK_SEQPACKET));
}

TEST(Listener, LeavesOtherFilesAlone) {
  const auto path = socket_path("listener-file");
  std::ofstream(path) << "mine";
  EXPECT_THROW(Listener(path, SOCK_SEQPACKET), std::runtime_error);
  EXPECT_TRUE(std::filesystem::exists(path));
  std::filesystem::remove(path);
  EXPECT_THROW(Listener(std::string(200, 'x'), SOCK_SEQPACKET), std::runtime_error);
  EXPECT_THROW(Listener("", SOCK_SEQPACKET), std::runtime_error);
}

}  // namespace
}  // namespace isotouch::falcon_sim
