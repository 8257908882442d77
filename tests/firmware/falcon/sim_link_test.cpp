#include "firmware/falcon/sim_link.h"

#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <functional>
#include <string>
#include <thread>
#include <vector>

#include "firmware/falcon/ft232.h"
#include "tests/support/scratch_folder.h"

namespace isotouch::falcon {
namespace {

using Bytes = std::vector<std::uint8_t>;

/// The descriptor's answer of a simulator that keeps the contract.
Bytes descriptor() {
  Bytes answer = {'d', 18, 1, 0, 2, 0, 0, 0, 8, 0x03, 0x04, 0x48, 0xCB, 0x00, 0x06, 1, 2, 3, 1};
  for (const std::string& text : {std::string("maker"), std::string("FALCON HAPTIC"), std::string("SIM00001")}) {
    answer.push_back(static_cast<std::uint8_t>(text.size()));
    answer.insert(answer.end(), text.begin(), text.end());
  }
  return answer;
}

/// A server of one client at a time; `reply` makes an answer of a request, an empty answer closes the connection.
class Server {
 public:
  using Reply = std::function<Bytes(const Bytes&)>;

  Server(const std::string& path, int clients, Reply reply) : socket_(::socket(AF_UNIX, SOCK_SEQPACKET, 0)) {
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    std::copy(path.begin(), path.end(), address.sun_path);
    EXPECT_EQ(::bind(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
    EXPECT_EQ(::listen(socket_, 1), 0);
    thread_ = std::thread([this, clients, reply = std::move(reply)] {
      for (int i = 0; i < clients; ++i) serve(::accept(socket_, nullptr, nullptr), reply);
    });
  }
  ~Server() {
    thread_.join();
    ::close(socket_);
  }

 private:
  static void serve(int client, const Reply& reply) {
    std::array<std::uint8_t, 8192> buffer{};
    for (;;) {
      const ssize_t got = ::recv(client, buffer.data(), buffer.size(), 0);
      if (got <= 0) break;
      const Bytes answer = reply(Bytes(buffer.begin(), buffer.begin() + got));
      if (answer.empty() || ::send(client, answer.data(), answer.size(), MSG_NOSIGNAL) < 0) break;
    }
    ::close(client);
  }

  int socket_;
  std::thread thread_;
};

struct Desk {
  ScratchFolder folder;
  std::string path = (folder.path() / "falcon").string();
};

TEST(SimLink, SpeaksTheContractByteForByte) {
  Desk desk;
  std::vector<Bytes> requests;
  const Server server(desk.path, 1, [&](const Bytes& request) -> Bytes {
    requests.push_back(request);
    switch (request[0]) {
      case 'D': return descriptor();
      case 'C': return request[1] == 0xC0 ? Bytes{'c', 0, 1, 0x60} : Bytes{'c', 0};
      case 'O': return {'o', 0, 3, 0};
      default: return {'i', 0, 0x01, 0x60, 0x41};
    }
  });
  SimLink link(desk.path);
  ASSERT_TRUE(link.open());
  EXPECT_EQ(link.identity().vendor, 0x0403);
  EXPECT_EQ(link.identity().product, 0xCB48);
  EXPECT_EQ(link.identity().release, 0x0600);
  EXPECT_EQ(link.identity().manufacturer, "maker");
  EXPECT_EQ(link.identity().name, "FALCON HAPTIC");
  EXPECT_EQ(link.identity().serial, "SIM00001");
  EXPECT_EQ(link.control(ft232::kBaud9600, {}).value(), 0U);
  std::array<std::uint8_t, 2> status{};
  EXPECT_EQ(link.control({0xC0, 5, 0, 0, 0, 0, 2, 0}, status).value(), 2U);
  EXPECT_EQ(status[1], 0x60);
  EXPECT_EQ(link.write(Bytes{0x0A, 0x43, 0x0D}, 100).value(), 3U);
  Bytes buffer(130);
  EXPECT_EQ(link.read(buffer, 0x01020304).value(), 3U);
  EXPECT_EQ(buffer[2], 0x41);
  EXPECT_EQ(link.read(buffer, 0).value(), 3U);
  const std::vector<Bytes> expected = {{'D'},
                                       {'C', 0x40, 0x03, 0x38, 0x41, 0, 0, 0, 0},
                                       {'C', 0xC0, 5, 0, 0, 0, 0, 2, 0},
                                       {'O', 0x0A, 0x43, 0x0D},
                                       {'I', 128, 0, 0x04, 0x03, 0x02, 0x01},
                                       {'I', 128, 0, 1, 0, 0, 0}};
  EXPECT_EQ(requests, expected);
  link.close();
}

TEST(SimLink, NoNameOfItReachesATerminalAsACommand) {
  Desk desk;
  const Server server(desk.path, 1, [&](const Bytes&) -> Bytes {
    Bytes answer = descriptor();
    answer.resize(19);
    for (const std::string& text : {std::string("a\x1B[2J"), std::string("b\xC2\x9B"), std::string("c\xE2\x80\xAE")}) {
      answer.push_back(static_cast<std::uint8_t>(text.size()));
      answer.insert(answer.end(), text.begin(), text.end());
    }
    return answer;
  });
  SimLink link(desk.path);
  ASSERT_TRUE(link.open());
  EXPECT_EQ(link.identity().manufacturer, "a?[2J");
  EXPECT_EQ(link.identity().name, "b??");
  EXPECT_EQ(link.identity().serial, "c???");
}

TEST(SimLink, ASimulatorThatAcceptsNobodyIsNotWaitedFor) {
  Desk desk;
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  std::copy(desk.path.begin(), desk.path.end(), address.sun_path);
  const int listener = ::socket(AF_UNIX, SOCK_SEQPACKET, 0);
  ASSERT_EQ(::bind(listener, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
  ASSERT_EQ(::listen(listener, 0), 0);
  std::vector<int> waiting;  // the backlog is full
  for (bool full = false; !full && waiting.size() < 100;) {
    waiting.push_back(::socket(AF_UNIX, SOCK_SEQPACKET | SOCK_NONBLOCK, 0));
    full = ::connect(waiting.back(), reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0;
  }
  std::thread helper([&] {  // the test must end, too
    std::this_thread::sleep_for(std::chrono::seconds(1));
    ::shutdown(listener, SHUT_RDWR);
    ::close(listener);
  });
  SimLink link(desk.path);
  const auto began = std::chrono::steady_clock::now();
  EXPECT_EQ(link.open().error(), LinkError::kBusy);
  EXPECT_LT(std::chrono::steady_clock::now() - began, std::chrono::milliseconds(700));
  helper.join();
  for (const int socket : waiting) ::close(socket);
}

TEST(SimLink, StatusesAreErrors) {
  Desk desk;
  std::uint8_t status = 0;
  const Server server(desk.path, 1, [&](const Bytes& request) -> Bytes {
    if (request[0] == 'D') return descriptor();
    return {static_cast<std::uint8_t>(request[0] | 0x20), status};
  });
  SimLink link(desk.path);
  ASSERT_TRUE(link.open());
  Bytes buffer(64);
  status = 1;
  EXPECT_EQ(link.control(ft232::kPurge1, {}).error(), LinkError::kStalled);
  EXPECT_EQ(link.write(buffer, 1).error(), LinkError::kStalled);
  status = 2;
  EXPECT_EQ(link.read(buffer, 1).error(), LinkError::kTimedOut);
  EXPECT_TRUE(link.is_open());
  status = 3;
  EXPECT_EQ(link.read(buffer, 1).error(), LinkError::kGone);
  EXPECT_FALSE(link.is_open());
  EXPECT_EQ(link.read(buffer, 1).error(), LinkError::kGone);
}

TEST(SimLink, ReplugIsANewConnection) {
  Desk desk;
  int requests = 0;
  const Server server(desk.path, 3, [&](const Bytes& request) -> Bytes {
    if (request[0] == 'D') return descriptor();
    return ++requests % 2 == 0 ? Bytes{} : Bytes{'c', 0};
  });
  SimLink link(desk.path);
  for (int i = 0; i < 3; ++i) {
    ASSERT_TRUE(link.open());
    EXPECT_TRUE(link.control(ft232::kPurge1, {}));
    EXPECT_EQ(link.control(ft232::kPurge1, {}).error(), LinkError::kGone);
    EXPECT_FALSE(link.is_open());
  }
}

TEST(SimLink, WhatBreaksTheContractIsGoneOrUnsuitable) {
  Bytes other = descriptor(), cut = descriptor();
  other[11] = 0x01;  // 0403:cb01
  cut.pop_back();
  for (const Bytes& answer : {Bytes{'d'}, other, cut, Bytes(19, 'd')}) {
    Desk desk;
    const Server server(desk.path, 1, [&](const Bytes&) { return answer; });
    SimLink link(desk.path);
    EXPECT_EQ(link.open().error(), LinkError::kUnsuitable);
    EXPECT_FALSE(link.is_open());
  }
  for (const Bytes& answer : {Bytes{'x', 0}, Bytes{'i'}, Bytes(67, 'i')}) {
    Desk desk;
    Bytes sent = answer;
    if (sent.size() > 2) sent[1] = 0;  // more than was asked for
    const Server server(desk.path, 1, [&](const Bytes& request) { return request[0] == 'D' ? descriptor() : sent; });
    SimLink link(desk.path);
    ASSERT_TRUE(link.open());
    Bytes buffer(64);
    EXPECT_EQ(link.read(buffer, 1).error(), LinkError::kGone);
    EXPECT_FALSE(link.is_open());
  }
}

TEST(SimLink, NobodyThereIsNotFound) {
  Desk desk;
  SimLink link(desk.path);
  EXPECT_EQ(link.open().error(), LinkError::kNotFound);
  EXPECT_EQ(SimLink(std::string(200, 'x')).open().error(), LinkError::kNotFound);
  EXPECT_EQ(link.control(ft232::kPurge1, {}).error(), LinkError::kGone);
}

}  // namespace
}  // namespace isotouch::falcon
