/// The door of the page: what a browser, or somebody else, may send to `isotouch view`. The real server listens on the loopback interface; each input is
/// one connection, in parts that are sent one after the other. Whatever came, the next plain request is answered.
///
/// `@T` stands for the token and `@P` for the port, which no fuzzer would find; `@|` ends a part.
#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <new>
#include <string>
#include <string_view>
#include <thread>

#include "host/error.h"
#include "host/field_file/open_field.h"
#include "host/server/http_server.h"
#include "host/server/scene.h"
#include "host/server/view_site.h"
#include "host/trace/trace_file.h"
#include "shared/trace.h"
#include "tests/fuzz/input.h"
#include "tests/support/field_image.h"

using namespace isotouch;

namespace {

constexpr int kPatienceMs = 20'000;

field_file::OpenField ball() {
  const auto bytes = test::FieldImage({24, 24, 24}, [](const test::Point& p) { return length(p - test::Point{12, 12, 12}) - 5; }).bytes();
  field_file::Image image(bytes.size());
  std::copy(bytes.begin(), bytes.end(), image.data());
  return field_file::open_field(std::move(image), "ball");
}

/// A hand that moves through the ball.
trace::Trace recording() {
  const std::string file = "/tmp/isotouch-fuzz-" + std::to_string(::getpid()) + ".trace";
  TraceHeader header;
  header.device = libnifalcon_model();
  header.period_ns = 1'000'000;
  trace::TraceWriter writer(file, header);
  for (int tick = 0; tick < 300; ++tick) {
    TraceRecord record;
    record.input = position_input({Mm::from_raw(Mm::of(-20).raw() + Mm::of(0.03).raw() * tick), Mm::of(-16), Mm::of(-16)});
    writer.append(record);
  }
  writer.finish();
  const trace::Trace trace = trace::read_trace(file);
  ::unlink(file.c_str());
  return trace;
}

/// What is built is judged by its first byte: refused, not read, or a field.
server::Built build(const std::filesystem::path& file, const std::string& name,
                    const std::function<void(const std::string&, double)>& step) {
  step("reading", 0.5);
  std::FILE* stream = std::fopen(file.c_str(), "rb");
  fuzz::hold(stream != nullptr, "what was sent is there as a file");
  const int first = std::fgetc(stream);
  std::fclose(stream);
  if (first == 'x') throw InputError(file.string() + ": no scan");
  if (first == 'm') throw std::bad_alloc();
  if (first == 'r') return {nullptr, {{"verdict", "refused"}}};
  return {std::make_unique<server::Scene>(name, ball()), {{"verdict", "good"}}};
}

/// A connection that counts as broken where it does not get on.
class Socket {
 public:
  explicit Socket(std::uint16_t port) {
    sockaddr_in there{};
    there.sin_family = AF_INET;
    there.sin_port = htons(port);
    there.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    for (;;) {
      socket_ = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
      if (::connect(socket_, reinterpret_cast<const sockaddr*>(&there), sizeof there) == 0) break;
      fuzz::hold(errno == EINTR || errno == EADDRNOTAVAIL, "the server listens");  // libFuzzer's alarm; no port is free for now
      ::close(socket_);
      ::usleep(1000);
    }
    const linger at_once{1, 0};  // else ten thousands of ports wait for late packets
    ::setsockopt(socket_, SOL_SOCKET, SO_LINGER, &at_once, sizeof at_once);
  }
  ~Socket() { ::close(socket_); }
  Socket(const Socket&) = delete;
  Socket& operator=(const Socket&) = delete;

  void send(std::string_view bytes) { (void)!::send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL); }
  void end() { ::shutdown(socket_, SHUT_WR); }
  /// Something that has come within that time; empty: nothing, or the other side has closed.
  std::string hear(int wait_ms) {
    pollfd one{socket_, POLLIN, 0};
    int ready = 0;
    do ready = ::poll(&one, 1, wait_ms);
    while (ready < 0 && errno == EINTR);  // libFuzzer's alarm
    if (ready <= 0) return {};
    std::string bytes(1 << 16, '\0');
    const ssize_t got = ::recv(socket_, bytes.data(), bytes.size(), 0);
    ended_ = got <= 0;
    bytes.resize(got > 0 ? static_cast<std::size_t>(got) : 0);
    return bytes;
  }
  bool has_ended() const { return ended_; }

 private:
  int socket_ = -1;
  bool ended_ = false;
};

/// The server, which runs until the process ends.
class Page {
 public:
  Page() : site_(build), server_(site_, 0, {.viewers = 3, .connections = 8, .upload_bytes = 1 << 16}) {
    site_.show(std::make_unique<server::Scene>("ball", ball()));
    const trace::Trace hand = recording();  // one alone: two are compared, and need recorded outputs
    site_.show({hand});
    site_.begin(server_, "", {}, {});
    const std::string address = server_.address();  // http://127.0.0.1:PORT/TOKEN/
    const std::size_t colon = address.rfind(':'), slash = address.find('/', colon);
    port = address.substr(colon + 1, slash - colon - 1);
    token = address.substr(slash + 1, address.size() - slash - 2);
    std::thread([this] { server_.run(); }).detach();
  }

  /// What a controller would give to all viewers.
  void tell() {
    server_.send(std::make_shared<const server::Message>(server::Message{server::Topic::kTicks, true, std::string(500, 't')}));
    server_.send(std::make_shared<const server::Message>(server::Message{server::Topic::kState, false, "{}"}));
  }
  std::uint16_t number() const { return static_cast<std::uint16_t>(std::stoi(port)); }

  std::string port, token;

 private:
  server::ViewSite site_;
  server::HttpServer server_;
};

std::string put_in(std::string text, std::string_view what, const std::string& value) {
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + value.size()))
    text.replace(at, what.size(), value);
  return text;
}

/// The status line of the answer to a request for the object.
void expect_answer(Page& page) {
  Socket socket(page.number());
  socket.send("GET /" + page.token + "/difference HTTP/1.1\r\nHost: 127.0.0.1:" + page.port + "\r\nConnection: close\r\n\r\n");
  socket.end();
  std::string heard;
  while (!socket.has_ended()) {
    const std::string more = socket.hear(kPatienceMs);
    fuzz::hold(!more.empty() || socket.has_ended(), "a plain request is answered in time");
    heard += more;
  }
  fuzz::hold(heard.starts_with("HTTP/1.1 200 "), "a plain request is answered, whatever came before");
  fuzz::hold(heard.find("Content-Security-Policy: default-src 'none';") != std::string::npos, "every answer has its policy");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static Page& page = *new Page;
  static unsigned count = 0;
  std::string text = put_in(put_in({reinterpret_cast<const char*>(data), size}, "@T", page.token), "@P", page.port);
  const bool knows = text.find(page.token) != std::string::npos;
  Socket socket(page.number());
  std::string heard;
  for (std::string_view rest = text; !rest.empty();) {
    const std::size_t end = std::min(rest.find("@|"), rest.size());
    socket.send(rest.substr(0, end));
    rest.remove_prefix(std::min(end + 2, rest.size()));
    if (rest.empty()) break;
    heard += socket.hear(3);
    page.tell();
  }
  socket.end();
  while (!socket.has_ended()) {
    const std::string more = socket.hear(kPatienceMs);
    fuzz::hold(!more.empty() || socket.has_ended(), "a connection whose other side has said all comes to an end");
    heard += more;
  }
  fuzz::hold(heard.empty() || heard.starts_with("HTTP/1.1 "), "what is answered is HTTP");
  fuzz::hold(knows || (!heard.starts_with("HTTP/1.1 2") && !heard.starts_with("HTTP/1.1 1")), "without the token nothing is given");
  if (++count % 8 == 0) expect_answer(page);
  return 0;
}
