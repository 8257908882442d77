#include "host/server/http_server.h"

#include <algorithm>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/signal_set.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/thread_pool.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>
#include <csignal>
#include <exception>
#include <limits>
#include <list>
#include <new>
#include <optional>
#include <set>
#include <utility>

#include "host/error.h"
#include "host/server/access.h"

namespace isotouch::server {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
namespace websocket = beast::websocket;
using Tcp = asio::ip::tcp;
using Fault = beast::error_code;

namespace {

constexpr std::string_view kPlain = "text/plain; charset=utf-8";
constexpr int kSendBuffer = 64 * 1024;  ///< what the kernel keeps for a viewer is not the newest: little
constexpr std::chrono::milliseconds kFarewell{500};
constexpr std::string_view kSocket = "socket";

/// Bytes that take memory as they come: what a header announces may never be sent.
struct SentBody {
  using value_type = std::vector<std::uint8_t>;

  class reader {
   public:
    template <bool kRequest, class Fields>
    reader(http::header<kRequest, Fields>&, value_type& body) : body_(body) {}
    void init(const boost::optional<std::uint64_t>& announced, Fault& fault) {
      announced_ = announced.value_or(announced_);
      fault = {};
    }
    template <class Buffers>
    std::size_t put(const Buffers& buffers, Fault& fault) {
      std::size_t size = 0;
      fault = {};
      try {
        for (const asio::const_buffer part : beast::buffers_range_ref(buffers)) {
          const auto* bytes = static_cast<const std::uint8_t*>(part.data());
          const std::size_t wanted = body_.size() + part.size();
          if (wanted > body_.capacity())
            body_.reserve(std::max(wanted, static_cast<std::size_t>(std::min<std::uint64_t>(announced_, 2 * body_.capacity()))));
          body_.insert(body_.end(), bytes, bytes + part.size());
          size += part.size();
        }
      } catch (const std::bad_alloc&) {
        fault = boost::system::errc::make_error_code(boost::system::errc::not_enough_memory);
      }
      return size;
    }
    void finish(Fault& fault) { fault = {}; }

   private:
    value_type& body_;
    std::uint64_t announced_ = std::numeric_limits<std::uint64_t>::max();
  };
};

class Viewer;
class Client;

}  // namespace

Reply sentence(unsigned status, std::string_view text) {
  return {status, kPlain, std::make_shared<const std::string>(std::string(text) + "\n")};
}

struct HttpServer::Parts {
  Parts(Site& behind, const Limits& allowed) : site(behind), limits(allowed) {}

  Site& site;
  Limits limits;
  std::optional<AccessCheck> access;
  std::set<Viewer*> viewers;
  std::list<Client*> silent;  // who may go for another one: first those that were refused, then those that have asked nothing for longest
  std::size_t connections = 0, uploads = 0;
  bool ends = false;
  asio::io_context io{1};  // whatever waits in it uses the members above
  asio::thread_pool computing{1};
  Tcp::acceptor acceptor{io};
  asio::signal_set signals{io};
  asio::steady_timer pause{io};

  void accept();
  void take_in(Tcp::socket socket);
  void begin_to_end();
  std::string policy() const;
};

namespace {

using Parts = HttpServer::Parts;

/// A viewer's socket.
class Viewer : public std::enable_shared_from_this<Viewer> {
 public:
  Viewer(Parts& parts, beast::tcp_stream stream) : parts_(parts), socket_(std::move(stream)) {}
  ~Viewer() {
    parts_.viewers.erase(this);
    --parts_.connections;
  }
  Viewer(const Viewer&) = delete;
  Viewer& operator=(const Viewer&) = delete;

  void begin(http::request<http::empty_body> request) {
    parts_.viewers.insert(this);
    Fault ignored;
    beast::get_lowest_layer(socket_).expires_never();
    beast::get_lowest_layer(socket_).socket().set_option(asio::socket_base::send_buffer_size(kSendBuffer), ignored);
    beast::get_lowest_layer(socket_).socket().set_option(Tcp::no_delay(true), ignored);
    socket_.set_option(websocket::stream_base::timeout{parts_.limits.patience, 3 * parts_.limits.patience, true});
    socket_.auto_fragment(false);
    socket_.read_message_max(0);  // measured below, where there is a sentence for it
    socket_.async_accept(request, [self = shared_from_this()](Fault fault) {
      if (fault) return;
      self->open_ = true;
      for (const Shared& message : self->parts_.site.greeting()) self->outbox_.put(message);
      self->write();
      self->read();
    });
  }

  void put(const Shared& message) {
    try {
      outbox_.put(message);
      write();
    } catch (const std::bad_alloc&) {
      leave();  // the page comes again, and is sent all; other viewers get their message
    }
  }

  /// Says why, in at most 123 bytes, and ends.
  void close(websocket::close_code code, std::string_view why) {
    if (!open_ || closing_) return;
    closing_ = true;
    socket_.async_close(websocket::close_reason(code, beast::string_view(why.data(), why.size())), [self = shared_from_this()](Fault) {});
  }

 private:
  void read() {
    socket_.async_read_some(in_, parts_.limits.message_bytes + 1 - in_.size(), [self = shared_from_this()](Fault fault, std::size_t) {
      if (fault) return self->leave();
      self->take_what_came();
    });
  }

  void take_what_came() {
    if (in_.size() > parts_.limits.message_bytes)
      return close(websocket::close_code::too_big, "A message of this page is too long; load the page again.");
    if (!socket_.is_message_done()) return read();
    in_.consume(in_.size());  // all that a viewer says is that it has shown a batch
    const auto now = std::chrono::steady_clock::now();
    if (now - second_began_ >= std::chrono::seconds(1)) second_began_ = now, messages_ = 0;
    if (++messages_ > parts_.limits.messages_a_second)
      return close(websocket::close_code::policy_error, "This page sends too many messages; load it again.");
    outbox_.seen();
    write();
    read();
  }

  void write() {
    if (!open_ || writing_ || closing_) return;
    std::optional<Shared> next = outbox_.take();
    if (!next) return;
    socket_.binary((*next)->binary);
    socket_.async_write(asio::buffer((*next)->bytes), [self = shared_from_this()](Fault fault, std::size_t) {
      self->writing_ = nullptr;
      if (!fault) self->write();
    });
    writing_ = std::move(*next);  // only now: without memory nothing is being written
  }

  void leave() {
    open_ = false;
    beast::get_lowest_layer(socket_).close();
  }

  Parts& parts_;
  websocket::stream<beast::tcp_stream> socket_;
  beast::flat_buffer in_;
  Outbox outbox_;
  Shared writing_;
  bool open_ = false, closing_ = false;
  std::chrono::steady_clock::time_point second_began_;
  std::size_t messages_ = 0;
};

/// A connection that asks and is answered, until it becomes a viewer.
class Client : public std::enable_shared_from_this<Client> {
 public:
  Client(Parts& parts, Tcp::socket socket) : parts_(parts), stream_(std::move(socket)) { ++parts_.connections; }
  ~Client() {
    leave_the_silent();
    end_upload();
    if (!handed_on_) --parts_.connections;
  }
  Client(const Client&) = delete;
  Client& operator=(const Client&) = delete;

  void read() {
    parser_.emplace();
    parser_->header_limit(static_cast<std::uint32_t>(parts_.limits.request_bytes));
    parser_->body_limit(parts_.limits.upload_bytes);  // the header says how long the body will be
    stream_.expires_after(parts_.limits.patience);
    silent_ = parts_.silent.insert(parts_.silent.end(), this);
    http::async_read_header(stream_, in_, *parser_, [self = shared_from_this()](Fault fault, std::size_t) {
      self->leave_the_silent();
      if (fault == http::error::header_limit) return self->refuse(431, "This request is too long; load the page again.");
      if (fault == http::error::body_limit) return self->refuse_file();
      if (fault) return;  // gone, too slow, or no HTTP
      self->judge();
    });
  }

  /// Goes for another one, who may have something to ask.
  void make_room() {
    leave_the_silent();
    stream_.close();
  }

  void refuse(unsigned status, std::string_view why) {
    keep_ = false;
    write(sentence(status, why));
  }

 private:
  void leave_the_silent() {
    if (silent_) parts_.silent.erase(*silent_);
    silent_.reset();
  }

  static std::string_view view(beast::string_view text) { return {text.data(), text.size()}; }

  void refuse_file() {
    refuse(413, "This file is larger than " + std::to_string(parts_.limits.upload_bytes >> 20) + " MiB; build it with isotouch build.");
  }

  void judge() {
    const auto& header = parser_->get();
    const bool upgrade = websocket::is_upgrade(header);
    const bool post = header.method() == http::verb::post;
    const std::string_view target = view(header.target());
    const Admission admission =
        parts_.access->admit({target, view(header[http::field::host]), view(header[http::field::origin]), post || upgrade});
    if (!admission.granted()) return refuse(admission.status, admission.sentence);
    if (upgrade) return watch(admission);
    if (!post && header.method() != http::verb::get) return refuse(405, "Only GET and POST are understood here.");
    keep_ = header.keep_alive() && (post || parser_->is_done());  // what comes with a question is not read
    Request request{post, std::string(admission.path), std::string(admission.query)};
    if (!post) return compute(std::move(request));
    if (const std::optional<Reply> refused = parts_.site.refusal(request)) {
      keep_ = false;  // what it sends is not read
      return write(*refused);
    }
    if (parts_.uploads >= parts_.limits.uploads)
      return refuse(409, "Another file is being sent to this server; wait until it has come, and send this one again.");
    uploads_ = true;
    ++parts_.uploads;
    body_.emplace(std::move(*parser_));
    body_->body_limit(parts_.limits.upload_bytes);
    take_part(std::move(request));
  }

  /// What is sent may take long, as long as it comes.
  void take_part(Request request) {
    if (body_->is_done()) {
      request.body = std::move(body_->get().body());
      return compute(std::move(request));
    }
    stream_.expires_after(parts_.limits.patience);
    http::async_read_some(
        stream_, in_, *body_, [self = shared_from_this(), request = std::move(request)](Fault fault, std::size_t) mutable {
          if (fault == http::error::body_limit) return self->refuse_file();
          if (fault == boost::system::errc::not_enough_memory) {
            self->body_.reset();
            return self->refuse(413, "There is not enough memory for this file; thin the scan, or build it with isotouch build.");
          }
          if (!fault) self->take_part(std::move(request));
        });
  }

  void watch(const Admission& admission) {
    if (admission.path != kSocket) return refuse(404, "There is no socket at this address.");
    if (parts_.viewers.size() >= parts_.limits.viewers) {
      return refuse(503, "There are " + std::to_string(parts_.limits.viewers) +
                             " viewers already; close one, or start isotouch view with a larger --viewers.");
    }
    const auto viewer = std::make_shared<Viewer>(parts_, std::move(stream_));
    handed_on_ = true;  // only now: without memory there is no viewer that counts as a connection
    viewer->begin(parser_->release());
  }

  /// On the other thread, and back.
  void compute(Request request) {
    stream_.expires_never();
    asio::post(parts_.computing, [self = shared_from_this(), request = std::move(request)]() mutable {
      Reply reply;
      try {
        reply = self->parts_.site.reply(std::move(request));
      } catch (const InputError& error) {
        reply = sentence(400, error.what());
      } catch (const std::exception&) {
        reply = sentence(500, "There is not enough memory for this.");
      }
      Parts& parts = self->parts_;
      asio::post(parts.io, [self = std::move(self), reply = std::move(reply)] { self->write(reply); });  // it ends on the sockets' thread
    });
  }

  void end_upload() {
    if (std::exchange(uploads_, false)) --parts_.uploads;
  }

  void write(const Reply& reply) {
    end_upload();
    if (parts_.ends) return;
    sent_ = reply.body;
    response_ = {http::status(reply.status), 11};
    response_.set(http::field::content_type, beast::string_view(reply.type.data(), reply.type.size()));
    response_.set(http::field::cache_control, "no-store");
    response_.set("Content-Security-Policy", parts_.policy());
    response_.set("X-Content-Type-Options", "nosniff");
    response_.set("Referrer-Policy", "no-referrer");
    response_.set("Cross-Origin-Opener-Policy", "same-origin");
    response_.set("Cross-Origin-Embedder-Policy", "require-corp");
    response_.set("Cross-Origin-Resource-Policy", "same-origin");
    response_.keep_alive(keep_);
    response_.body() = beast::span<const char>(sent_->data(), sent_->size());
    response_.prepare_payload();
    stream_.expires_after(3 * parts_.limits.patience);
    http::async_write(stream_, response_, [self = shared_from_this()](Fault fault, std::size_t) {
      if (fault) return;
      if (self->keep_) return self->read();
      self->hang_up();
    });
  }

  /// What is still on its way is read for a moment: else the sentence would be lost with the connection.
  void hang_up() {
    Fault ignored;
    stream_.socket().shutdown(Tcp::socket::shutdown_send, ignored);
    stream_.expires_after(std::chrono::seconds(1));
    hangs_up_ = true;
    const auto behind = std::find_if(parts_.silent.begin(), parts_.silent.end(), [](const Client* client) { return !client->hangs_up_; });
    silent_ = parts_.silent.insert(behind, this);
    drain();
  }
  void drain() {
    rest_.resize(16 * 1024);
    stream_.async_read_some(asio::buffer(rest_), [self = shared_from_this()](Fault fault, std::size_t) {
      if (!fault) self->drain();
    });
  }

  Parts& parts_;
  beast::tcp_stream stream_;
  beast::flat_buffer in_;
  std::optional<http::request_parser<http::empty_body>> parser_;
  std::optional<http::request_parser<SentBody>> body_;
  http::response<http::span_body<const char>> response_;
  Bytes sent_;
  std::vector<char> rest_;
  std::optional<std::list<Client*>::iterator> silent_;  // its place among them
  bool keep_ = false, handed_on_ = false, hangs_up_ = false, uploads_ = false;
};

}  // namespace

/// Nothing but what this server sends: no other address, no inline script, no frame.
std::string HttpServer::Parts::policy() const {
  return "default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; style-src 'self'; img-src 'self' data:; worker-src 'self'; connect-src "
         "'self' " +
         access->socket_origin() + "; base-uri 'none'; form-action 'none'; frame-ancestors 'none'";
}

void HttpServer::Parts::accept() {
  acceptor.async_accept([this](Fault fault, Tcp::socket socket) {
    if (ends) return;
    if (fault) {  // no more files may be open: in a moment
      pause.expires_after(std::chrono::milliseconds(100));
      pause.async_wait([this](Fault) { accept(); });
      return;
    }
    accept();  // first, in the memory that this call has given back: whatever happens to this one, others may come
    take_in(std::move(socket));
  });
}

void HttpServer::Parts::take_in(Tcp::socket socket) {
  const bool full = connections - silent.size() >= limits.connections;
  if (connections >= (full ? 2 : 1) * limits.connections) {
    if (silent.empty()) return;  // so many are being refused that one more is not even told
    silent.front()->make_room();
  }
  const auto client = std::make_shared<Client>(*this, std::move(socket));
  if (full) {
    client->refuse(503, "This server has too many connections; close other pages of it, or wait a moment.");
  } else {
    client->read();
  }
}

void HttpServer::Parts::begin_to_end() {
  if (ends) return;
  ends = true;
  Fault ignored;
  acceptor.close(ignored);
  try {
    for (Viewer* viewer : std::set(viewers)) viewer->close(websocket::close_code::going_away, "isotouch view has ended; start it again.");
    pause.expires_after(viewers.empty() ? std::chrono::milliseconds(0) : kFarewell);
    pause.async_wait([this](Fault) { io.stop(); });
  } catch (const std::bad_alloc&) {
    io.stop();  // without a farewell
  }
}

HttpServer::HttpServer(Site& site, std::uint16_t port, const Limits& limits) : parts_(std::make_unique<Parts>(site, limits)) {
  const Tcp::endpoint here(asio::ip::address_v4::loopback(), port);
  Fault fault;
  parts_->acceptor.open(here.protocol(), fault);
  if (!fault) parts_->acceptor.set_option(asio::socket_base::reuse_address(true), fault);
  if (!fault) parts_->acceptor.bind(here, fault);
  if (!fault) parts_->acceptor.listen(asio::socket_base::max_listen_connections, fault);
  if (fault) {
    throw InputError("port " + std::to_string(port) + " of 127.0.0.1 cannot be used (" + fault.message() +
                     "); choose another one with --port, or leave it out");
  }
  parts_->access.emplace(parts_->acceptor.local_endpoint().port(), random_token());
}

HttpServer::~HttpServer() { parts_->computing.join(); }

std::string HttpServer::address() const { return parts_->access->address(); }

void HttpServer::run() {
  parts_->signals.add(SIGINT);
  parts_->signals.add(SIGTERM);
  parts_->signals.async_wait([this](Fault fault, int) {
    if (!fault) parts_->begin_to_end();
  });
  parts_->accept();
  for (;;) {
    try {
      parts_->io.run();
      return;
    } catch (const std::bad_alloc&) {  // the connection that it was for is closed; the others go on
    }
  }
}

void HttpServer::end() {
  asio::post(parts_->io, [this] { parts_->begin_to_end(); });
}

void HttpServer::send(Shared message) {
  asio::post(parts_->io, [this, message = std::move(message)] {
    for (Viewer* viewer : std::set(parts_->viewers)) viewer->put(message);
  });
}

}  // namespace isotouch::server
