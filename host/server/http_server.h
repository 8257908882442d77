/// The page's door: HTTP and one WebSocket for each viewer, on the loopback interface alone, by Boost.Beast.
///
/// One thread serves all sockets and waits for none of them; what takes longer is computed by a second one. A viewer that reads slowly loses batches of
/// ticks (outbox.h) and keeps nobody waiting.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "host/server/outbox.h"

namespace isotouch::server {

/// What was let in and asked for.
struct Request {
  bool sends = false;  ///< POST; else GET
  std::string path;    ///< behind the token: "page.js"
  std::string query;   ///< behind the question mark
  std::vector<std::uint8_t> body = {};
};

using Bytes = std::shared_ptr<const std::string>;

struct Reply {
  unsigned status = 200;
  std::string_view type;  ///< of the content: "text/html; charset=utf-8"
  Bytes body;
};

/// A reply that is one sentence.
Reply sentence(unsigned status, std::string_view text);

/// What is behind the door.
class Site {
 public:
  virtual ~Site() = default;

  /// On the computing thread, one request after the other. May throw InputError: its sentence becomes a reply with status 400.
  virtual Reply reply(Request request) = 0;
  /// What a new viewer is sent first. On the thread of the sockets: it must not compute.
  virtual std::vector<Shared> greeting() = 0;
};

/// What one client, and all together, may take.
struct Limits {
  std::size_t viewers = 10;
  std::size_t connections = 64;
  std::size_t message_bytes = 1024;         ///< that a viewer sends
  std::size_t messages_a_second = 240;      ///< of one viewer
  std::size_t request_bytes = 8 * 1024;     ///< of a request without what it sends
  std::uint64_t upload_bytes = 256U << 20;  ///< that a request sends
  std::chrono::seconds patience{10};        ///< for a request, and for a viewer that takes or says nothing three times as long
};

class HttpServer {
 public:
  /// Binds, so that the address is known; serves nothing yet.
  ///
  /// port      0: any that is free
  /// fails     InputError: the port is taken
  HttpServer(Site& site, std::uint16_t port, const Limits& limits = {});
  ~HttpServer();
  HttpServer(const HttpServer&) = delete;
  HttpServer& operator=(const HttpServer&) = delete;

  /// What to open in a browser, with the token.
  std::string address() const;

  /// Serves until SIGINT, SIGTERM or `end`; then every viewer is told, and it returns.
  void run();
  /// From any thread.
  void end();
  /// To every viewer; from any thread.
  void send(Shared message);

  struct Parts;

 private:
  std::unique_ptr<Parts> parts_;
};

}  // namespace isotouch::server
