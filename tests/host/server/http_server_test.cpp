#include "host/server/http_server.h"

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <fstream>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "tests/support/sanitized.h"

namespace isotouch::server {
namespace {

using namespace std::chrono_literals;

/// A server with nothing behind it, until it is left.
class Served : public Site {
 public:
  explicit Served(const Limits& limits = {}) : server_(*this, 0, limits) {
    const std::string address = server_.address();  // http://127.0.0.1:PORT/TOKEN/
    const std::size_t colon = address.rfind(':'), slash = address.find('/', colon);
    port_ = address.substr(colon + 1, slash - colon - 1);
    path_ = address.substr(slash);
    sockets_ = std::jthread([this] {
      here_ = std::this_thread::get_id();
      server_.run();
    });
  }
  ~Served() override { server_.end(); }
  Served(const Served&) = delete;
  Served& operator=(const Served&) = delete;

  std::optional<Reply> refusal(const Request&) override {
    ++sending;
    return std::nullopt;
  }
  Reply reply(Request request) override {
    if (request.sends) sent_bytes = request.body.size(), sent_memory = request.body.capacity();
    return {200, "text/plain", Bytes(new std::string("here"), [this](const std::string* body) {
              if (std::this_thread::get_id() != here_) ++ended_elsewhere;
              delete body;
            })};
  }
  std::vector<Shared> greeting() override { return {}; }

  std::uint16_t port() const { return static_cast<std::uint16_t>(std::stoi(port_)); }
  std::string head(std::string_view method = "GET", std::string_view then = "close") const {
    return std::string(method) + " " + path_ + "x HTTP/1.1" + rest(then);
  }
  std::string stranger() const { return "GET /0/ HTTP/1.1" + rest(); }

  std::atomic<int> sending = 0;                              ///< connections that have begun to send something
  std::atomic<std::size_t> sent_bytes = 0, sent_memory = 0;  ///< of what was sent last
  std::atomic<int> ended_elsewhere = 0;                      ///< connections that ended in another thread than that of the sockets

 private:
  std::string rest(std::string_view then = "close") const {
    return "\r\nHost: 127.0.0.1:" + port_ + "\r\nOrigin: http://127.0.0.1:" + port_ + "\r\nConnection: " + std::string(then) + "\r\n";
  }

  std::string port_, path_;
  std::atomic<std::thread::id> here_;
  HttpServer server_;
  std::jthread sockets_;
};

/// One connection, which stays open on our side.
class Asking {
 public:
  Asking(const Served& served, std::string_view text) : socket_(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
    sockaddr_in there{};
    there.sin_family = AF_INET;
    there.sin_port = htons(served.port());
    there.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    EXPECT_EQ(::connect(socket_, reinterpret_cast<const sockaddr*>(&there), sizeof there), 0);
    EXPECT_EQ(::send(socket_, text.data(), text.size(), MSG_NOSIGNAL), static_cast<ssize_t>(text.size()));
  }
  ~Asking() { ::close(socket_); }
  Asking(const Asking&) = delete;
  Asking& operator=(const Asking&) = delete;

  void end() { ::shutdown(socket_, SHUT_WR); }
  /// returns   whether it was taken
  bool sends(std::string_view text) const {
    while (!text.empty()) {
      const ssize_t sent = ::send(socket_, text.data(), text.size(), MSG_NOSIGNAL);
      if (sent <= 0) return false;
      text.remove_prefix(static_cast<std::size_t>(sent));
    }
    return true;
  }
  /// Of the answer; empty: there was none.
  std::string status() {
    const std::string heard = all();
    return heard.substr(0, heard.find('\r')).substr(0, 12);
  }
  /// What comes until the connection ends.
  std::string all() {
    std::string heard;
    std::array<char, 4096> part{};
    for (ssize_t got = 1; got > 0;) {
      got = ::recv(socket_, part.data(), part.size(), 0);
      if (got > 0) heard.append(part.data(), static_cast<std::size_t>(got));
    }
    return heard;
  }

 private:
  int socket_;
};

TEST(HttpServer, WhoIsRefusedAndStaysKeepsNobodyOut) {
  const Served served({.connections = 4});
  std::vector<std::unique_ptr<Asking>> refused;
  for (int i = 0; i < 20; ++i) {
    refused.push_back(std::make_unique<Asking>(served, served.stranger() + "\r\n"));
    EXPECT_EQ(refused.back()->status(), "HTTP/1.1 403");
  }
  EXPECT_EQ(Asking(served, served.head() + "\r\n").status(), "HTTP/1.1 200");
}

TEST(HttpServer, WhoIsRefusedBecauseItIsFullMakesNoRoom) {
  const Served served({.connections = 4, .uploads = 4});
  std::vector<std::unique_ptr<Asking>> all;
  for (int i = 0; i < 4; ++i) all.push_back(std::make_unique<Asking>(served, served.head("POST") + "Content-Length: 9\r\n\r\n1"));
  for (int i = 0; i < 200 && served.sending < 4; ++i) std::this_thread::sleep_for(50ms);
  for (int i = 0; i < 20; ++i) {
    all.push_back(std::make_unique<Asking>(served, served.head() + "\r\n"));
    EXPECT_EQ(all.back()->status(), "HTTP/1.1 503") << i;
  }
}

/// Whoever passes requests of others on would else let one of them ask in the name of another.
TEST(HttpServer, WhatComesWithAQuestionIsNoQuestion) {
  const Served served;
  const auto answers = [&](const std::string& text) {
    const std::string heard = Asking(served, text).all();
    std::size_t count = 0;
    for (std::size_t at = heard.find("HTTP/1.1 200"); at != std::string::npos; at = heard.find("HTTP/1.1 200", at + 1)) ++count;
    return count;
  };
  const std::string stays = served.head("GET", "keep-alive"), last = served.head() + "\r\n";
  EXPECT_EQ(answers(stays + "\r\n" + last), 2U);
  EXPECT_EQ(answers(stays + "Content-Length: " + std::to_string(last.size()) + "\r\n\r\n" + last), 1U);
  EXPECT_EQ(answers(stays + "Transfer-Encoding: chunked\r\n\r\n" + last), 1U);
  EXPECT_EQ(answers(served.head("POST", "keep-alive") + "Content-Length: 4\r\n\r\nscan" + last), 2U);
}

TEST(HttpServer, OneFileIsSentAtATime) {
  const Served served;
  const std::string sends = served.head("POST") + "Content-Length: 9\r\n\r\n1";
  auto first = std::make_unique<Asking>(served, sends);
  for (int i = 0; i < 200 && served.sending < 1; ++i) std::this_thread::sleep_for(50ms);
  EXPECT_EQ(Asking(served, sends).status(), "HTTP/1.1 409");
  first.reset();  // it gives up
  std::string status;
  for (int i = 0; i < 200 && status != "HTTP/1.1 200"; ++i) {
    status = Asking(served, sends + "23456789").status();
    if (status != "HTTP/1.1 200") std::this_thread::sleep_for(50ms);
  }
  EXPECT_EQ(status, "HTTP/1.1 200");
}

TEST(HttpServer, AFileComesAsSlowlyAsItWantsButNotSilently) {
  const Served served({.patience = 1s});
  const std::string sends = served.head("POST") + "Content-Length: 40\r\n\r\n1";
  {
    const auto begun = std::chrono::steady_clock::now();
    Asking silent(served, sends);
    EXPECT_EQ(silent.status(), "") << "it is closed";
    EXPECT_LT(std::chrono::steady_clock::now() - begun, 5s);
  }
  Asking slow(served, sends);
  for (int i = 1; i < 40; ++i) {
    std::this_thread::sleep_for(180ms);  // seven seconds for all
    EXPECT_TRUE(slow.sends("2")) << i;
  }
  EXPECT_EQ(slow.status(), "HTTP/1.1 200");
  EXPECT_EQ(served.sent_bytes, 40U);
}

TEST(HttpServer, WhatIsSentTakesNoMoreMemoryThanItAnnounced) {
  const Served served;
  const std::string body((5U << 20) + 1, 'x');
  Asking large(served, served.head("POST") + "Content-Length: " + std::to_string(body.size()) + "\r\n\r\n");
  EXPECT_TRUE(large.sends(body));
  EXPECT_EQ(large.status(), "HTTP/1.1 200");
  EXPECT_EQ(served.sent_bytes, body.size());
  EXPECT_EQ(served.sent_memory, body.size());
}

/// Of all the memory that this process may take.
std::size_t taken() {
  std::size_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  return pages * static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
}

TEST(HttpServer, WhatIsAnnouncedAndDoesNotFitIntoMemoryEndsNobody) {
  if (test::kSanitized) GTEST_SKIP() << "they take terabytes of addresses";
  const Served served({.uploads = 12});
  EXPECT_EQ(Asking(served, served.head() + "\r\n").status(), "HTTP/1.1 200");
  rlimit before{};
  ASSERT_EQ(::getrlimit(RLIMIT_AS, &before), 0);
  const rlimit little{static_cast<rlim_t>(taken() + (100U << 20)), before.rlim_max};
  ASSERT_EQ(::setrlimit(RLIMIT_AS, &little), 0);
  std::vector<std::unique_ptr<Asking>> all;
  const std::string sends = served.head("POST") + "Content-Length: 260000000\r\n\r\n";
  for (int i = 0; i < 12; ++i) all.push_back(std::make_unique<Asking>(served, sends + "123"));
  for (int i = 0; i < 200 && served.sending < 12; ++i) std::this_thread::sleep_for(50ms);
  EXPECT_EQ(Asking(served, served.head() + "\r\n").status(), "HTTP/1.1 200");
  all.clear();

  std::string status;
  {
    Asking large(served, sends);
    const std::string part(1U << 20, 'x');
    for (int i = 0; i < 240 && large.sends(part);) ++i;
    status = large.status();
  }
  EXPECT_TRUE(status == "HTTP/1.1 413" || status.empty()) << status;  // empty: it was still sending when the answer came
  EXPECT_EQ(Asking(served, served.head() + "\r\n").status(), "HTTP/1.1 200");
  EXPECT_EQ(::setrlimit(RLIMIT_AS, &before), 0);
}

/// What belongs to the sockets' thread is not locked.
TEST(HttpServer, NoConnectionEndsInTheThreadThatComputes) {
  Served served;
  for (int i = 0; i < 1000; ++i) {
    Asking asking(served, served.head() + "\r\n");
    asking.end();
    ASSERT_EQ(asking.status(), "HTTP/1.1 200");
  }
  EXPECT_EQ(served.ended_elsewhere, 0);
}

}  // namespace
}  // namespace isotouch::server
