/// A controller for tests of those that speak with one: it says what was prepared, whatever it is asked.
#pragma once

#include <gtest/gtest.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "shared/protocol.h"
#include "shared/protocol_messages.h"
#include "tests/support/scratch_folder.h"

namespace isotouch::test {

using Bytes = std::vector<std::uint8_t>;

/// Answers its first client with prepared bytes, and goes.
class Scripted {
 public:
  /// reads     false: it takes nothing of what the client sends
  explicit Scripted(Bytes answers, bool reads = true) : path_((scratch_.path() / "socket").string()) {
    sockaddr_un name{};
    name.sun_family = AF_UNIX;
    std::copy(path_.begin(), path_.end(), name.sun_path);
    door_ = ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
    EXPECT_EQ(::bind(door_, reinterpret_cast<const sockaddr*>(&name), sizeof name), 0);
    EXPECT_EQ(::listen(door_, 1), 0);
    thread_ = std::thread([this, answers = std::move(answers), reads] {
      const int client = ::accept(door_, nullptr, nullptr);
      (void)::send(client, answers.data(), answers.size(), MSG_NOSIGNAL);
      if (!reads) {
        pollfd until_it_goes{client, 0, 0};
        (void)::poll(&until_it_goes, 1, -1);
      }
      ::shutdown(client, SHUT_WR);
      Bytes heard(4096);
      while (::recv(client, heard.data(), heard.size(), 0) > 0) continue;
      ::close(client);
    });
  }
  ~Scripted() {
    thread_.join();
    ::close(door_);
  }
  std::string address() const { return "unix:" + path_; }

 private:
  ScratchFolder scratch_;
  std::string path_;
  int door_ = -1;
  std::thread thread_;
};

template <class Message>
Bytes frame(protocol::Kind kind, const Message& message) {
  Bytes bytes(protocol::kMaxFrame);
  bytes.resize(protocol::encode(kind, message, bytes));
  return bytes;
}
inline Bytes frame(protocol::Kind kind) {
  Bytes bytes(protocol::kHeaderBytes);
  protocol::seal_frame(kind, 0, bytes);
  return bytes;
}

}  // namespace isotouch::test
