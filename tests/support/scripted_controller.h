/// A controller for tests of those that speak with one: it says what was prepared, whatever it is asked.
#pragma once

#include <gtest/gtest.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <functional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "shared/protocol.h"
#include "shared/protocol_messages.h"
#include "tests/support/scratch_folder.h"

namespace isotouch::test {

using Bytes = std::vector<std::uint8_t>;

/// Serves that many clients, each in a thread of its own.
class Scripted {
 public:
  using Talk = std::function<void(int client)>;

  /// talks     what it does with its first client, its second, …
  explicit Scripted(std::vector<Talk> talks) : path_((scratch_.path() / "socket").string()) {
    sockaddr_un name{};
    name.sun_family = AF_UNIX;
    std::copy(path_.begin(), path_.end(), name.sun_path);
    door_ = ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
    EXPECT_EQ(::bind(door_, reinterpret_cast<const sockaddr*>(&name), sizeof name), 0);
    EXPECT_EQ(::listen(door_, 1), 0);
    thread_ = std::thread([this, talks = std::move(talks)] {
      std::vector<std::jthread> clients;
      for (const Talk& talk : talks) {
        const int client = ::accept(door_, nullptr, nullptr);
        if (client < 0) return;
        clients.emplace_back([talk, client] {
          talk(client);
          ::close(client);
        });
      }
    });
  }
  /// One client gets prepared bytes.
  explicit Scripted(Bytes answers, bool reads = true) : Scripted(std::vector{says(std::move(answers), reads)}) {}
  ~Scripted() {
    ::shutdown(door_, SHUT_RDWR);  // clients that never came are not waited for
    thread_.join();
    ::close(door_);
  }
  std::string address() const { return "unix:" + path_; }

  /// Answers with prepared bytes, and goes.
  ///
  /// reads     false: it takes nothing of what the client sends, and stays as long as the client
  static Talk says(Bytes answers, bool reads = true) {
    return [answers = std::move(answers), reads](int client) {
      (void)::send(client, answers.data(), answers.size(), MSG_NOSIGNAL);
      if (!reads) {
        pollfd until_it_goes{client, 0, 0};
        (void)::poll(&until_it_goes, 1, -1);
      }
      ::shutdown(client, SHUT_WR);
      Bytes heard(4096);
      while (::recv(client, heard.data(), heard.size(), 0) > 0) continue;
    };
  }

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
