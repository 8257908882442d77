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
#include <optional>
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

  /// What a request that sends something gets before it has been read, where it would be refused anyway; nothing: it is read, and `reply` answers it. On
  /// the thread of the sockets: it must not compute.
  ///
  /// request   without its body
  virtual std::optional<Reply> refusal(const Request& request) = 0;
  /// On the computing thread, one request after the other. May throw InputError: its sentence becomes a reply with status 400. What else it throws becomes
  /// status 500.
  virtual Reply reply(Request request) = 0;
  /// What a new viewer is sent first. On the thread of the sockets: it must not compute.
  virtual std::vector<Shared> greeting() = 0;
};

/// What one client, and all together, may take.
struct Limits {
  std::size_t viewers = 10;  ///< at a time; one more gets status 503
  /// At a time, viewers among them. One more ends the one that was refused, or has asked nothing, for longest; else it gets status 503. As many again may be
  /// open for the second in which they are refused; what comes then is closed.
  std::size_t connections = 64;
  std::size_t message_bytes = 1024;         ///< that a viewer sends; a longer one ends it with code 1009
  std::size_t messages_a_second = 240;      ///< of one viewer; more end it with code 1008
  std::size_t request_bytes = 8 * 1024;     ///< of a request without what it sends; else status 431
  std::uint64_t upload_bytes = 256U << 20;  ///< that a request sends; else status 413
  std::size_t uploads = 1;                  ///< at a time; one more gets status 409
  /// For a request, and for each part of what it sends. Three times as long for a viewer that takes or says nothing.
  std::chrono::seconds patience{10};
};

class HttpServer {
 public:
  /// Binds, so that the address is known; serves nothing yet.
  ///
  /// site      outlives this
  /// port      0: any that is free
  /// fails     InputError: the port is taken, or the system has no random numbers
  HttpServer(Site& site, std::uint16_t port, const Limits& limits = {});
  ~HttpServer();
  HttpServer(const HttpServer&) = delete;
  HttpServer& operator=(const HttpServer&) = delete;

  /// What to open in a browser, with the token.
  std::string address() const;

  /// Serves until SIGINT, SIGTERM or `end`; then every viewer is told, and it returns, at the latest half a second later. Once.
  void run();
  /// From any thread; does not wait.
  void end();
  /// To every viewer; from any thread; does not wait. A viewer that is too slow loses ticks (outbox.h).
  void send(Shared message);

  struct Parts;

 private:
  std::unique_ptr<Parts> parts_;
};

}  // namespace isotouch::server
