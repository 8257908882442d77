#include "firmware/control/control_server.h"

#include <poll.h>
#include <sys/eventfd.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <utility>

#include "firmware/loop/realtime.h"

namespace isotouch::control {

namespace {

using protocol::Kind;
using protocol::Role;

constexpr int kNapMs = 500;
constexpr int kShortNapMs = 5;  ///< while somebody watches: the ring holds seconds, but gets its ticks whenever the recorder has some

constexpr std::int64_t kDeafNs = 200'000'000;
// How long the place for a stop is somebody's, before the next one gets it: a stop takes two messages, and a tool greets at once.
constexpr std::int64_t kTurnNs = 100'000'000, kSilentTurnNs = 10'000'000;

/// What `isotouch stop` and `isotouch status` ask. None of it changes anything but the stop, or waits for the field worker.
bool belongs_to_a_stop(Kind request) {
  return request == Kind::kStop || request == Kind::kStatus || request == Kind::kDevice || request == Kind::kSettings;
}

}  // namespace

ControlServer::ControlServer(ControlSettings settings, const ControlNeighbours& neighbours)
    : settings_(std::move(settings)),
      neighbours_(neighbours),
      clients_(settings_.clients + 1),
      requests_(settings_.recordings, neighbours_, clients_, settings_.patience_ns),
      bell_(::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)) {}

ControlServer::~ControlServer() {
  stop();
  ::close(bell_);
}

Refusal ControlServer::listen() { return socket_.open(settings_.path, settings_.mode, settings_.group); }

void ControlServer::serve() {
  stop_ = false;
  thread_ = std::thread([this] { run(); });
}

Refusal ControlServer::start() {
  Refusal refusal = listen();
  if (!refusal) serve();
  return refusal;
}

void ControlServer::stop() {
  if (!thread_.joinable()) return socket_.close();
  stop_ = true;
  const std::uint64_t ring = 1;
  (void)!::write(bell_, &ring, sizeof ring);
  thread_.join();
  std::uint64_t rings = 0;
  (void)!::read(bell_, &rings, sizeof rings);
  for (ControlClient& client : clients_) client.close();
  socket_.close();
}

void ControlServer::run() {
  loop::keep_crash_stack();
  for (bool busy = false; !stop_;) {
    if (!wait(busy)) continue;
    busy = requests_.go_on();
    const std::int64_t now = neighbours_.clock.now_ns();
    // Whoever comes behind the one that had the worker last begins: nobody who asks and asks keeps it from the others.
    const std::size_t first = requests_.last_worked_for() + 1;
    for (std::size_t i = 0; i < clients_.size(); ++i) {
      ControlClient& client = clients_[(first + i) % clients_.size()];
      if (client.is_open()) serve(client);
      if (client.is_open() && (!client.send(now) || (client.leaving && !client.has_unsent()))) forget(client);
    }
    dismiss_the_idle();
    in_use_ = requests_.is_in_use() || std::any_of(clients_.begin(), clients_.end(), [](const ControlClient& c) {
                return c.is_open() && c.every == 0 && c.has_unsent();
              });  // whoever watches slowly never has all
  }
}

/// Until when whoever has the place for a stop keeps it; 0: other places are free.
std::int64_t ControlServer::turn_end_ns() const {
  if (!std::all_of(clients_.begin(), clients_.end(), [](const ControlClient& c) { return c.is_open(); })) return 0;
  const ControlClient& last = clients_.back();
  return last.opened_ns + (last.greeted ? kTurnNs : kSilentTurnNs);
}

/// Until something happens, or for a nap; then reads what has come. returns false: interrupted
bool ControlServer::wait(bool busy) {
  const std::int64_t before = neighbours_.clock.now_ns();
  const std::int64_t turn_ns = turn_end_ns() - before;  // meanwhile the next one waits in front of the socket
  const bool is_deaf = before < deaf_until_ns_ || turn_ns > 0;
  polled_.assign({{bell_, POLLIN, 0}, {requests_.bell(), POLLIN, 0}, {is_deaf ? -1 : socket_.number(), POLLIN, 0}});
  for (const ControlClient& client : clients_) {
    if (!client.is_open()) continue;  // poll takes no more entries than there may be file handles
    const bool reads = !client.waiting && !client.leaving && client.wants_more() && client.has_room();
    polled_.push_back({client.socket(), static_cast<short>((reads ? POLLIN : 0) | (client.has_unsent() ? POLLOUT : 0)), 0});
  }
  const auto nap_ms =
      static_cast<int>(std::min<std::int64_t>(turn_ns > 0 ? turn_ns / 1'000'000 + 1 : kNapMs, settings_.patience_ns / 4'000'000 + 1));
  if (settings_.poll(polled_, busy ? kShortNapMs : nap_ms) < 0) {
    if (errno != EINTR) neighbours_.clock.sleep_until_ns(neighbours_.clock.now_ns() + kDeafNs);
    return false;
  }
  const std::int64_t now = neighbours_.clock.now_ns();
  std::size_t at = 3;
  for (ControlClient& client : clients_) {
    if (!client.is_open() || (polled_[at++].revents & (POLLIN | POLLHUP | POLLERR)) == 0) continue;
    // One that hung up is read to its end, whatever it waits for: that is how its end is seen.
    if (!client.wants_more() || !client.receive(now)) forget(client);
  }
  if (polled_[2].revents != 0) admit();
  return true;
}

void ControlServer::admit() {
  const std::int64_t now = neighbours_.clock.now_ns();
  if (clients_.back().is_open()) serve(clients_.back());  // what came with the next one; a greeting makes its turn longer
  if (turn_end_ns() > now) return;
  const int socket = socket_.accept();
  if (socket < 0) {
    if (errno == EMFILE || errno == ENFILE || errno == ENOBUFS || errno == ENOMEM) deaf_until_ns_ = now + kDeafNs;  // it knocks on
    return;
  }
  const Peer peer = settings_.peer(socket);
  const Role role = role_of(peer, settings_.admission);
  if (role == Role::kNone) return turn_away(socket, peer, not_admitted(peer));
  const auto place = std::find_if(clients_.begin(), clients_.end() - 1, [](const ControlClient& c) { return !c.is_open(); });
  if (place->is_open()) {  // nobody may hold the place for a stop: after its turn it is the newest one's
    place->refuse(Kind::kHello, full());
    (void)place->send(now);
    forget(*place);
  }
  place->open(socket, peer, role, now);
}

std::string ControlServer::full() const {
  return std::to_string(settings_.clients) + " clients are connected, the most that are allowed; close one of them";
}

void ControlServer::turn_away(int socket, const Peer& peer, const Refusal& refusal) {
  const std::int64_t now = neighbours_.clock.now_ns();
  stranger_.open(socket, peer, Role::kNone, now);
  stranger_.refuse(Kind::kHello, refusal.sentence());
  (void)stranger_.send(now);  // a fresh connection has room for it
  stranger_.close();
}

/// Answers every frame that is complete, as long as its answers fit.
void ControlServer::serve(ControlClient& client) {
  while (client.has_unread() && !client.waiting && !client.leaving && client.has_room()) {
    const Result<protocol::Frame> frame = client.frame();
    if (!frame) {
      client.refuse(Kind::kHello, std::string("the bytes received are no message of the protocol: ") + describe(frame.error()) +
                                      "; connect again with isotouch");
      client.leaving = true;
      return;
    }
    if (frame->size == 0 || requests_.must_wait(*frame)) return;
    answer(client, *frame);
    client.drop(frame->size, neighbours_.clock.now_ns());
  }
}

void ControlServer::answer(ControlClient& client, const protocol::Frame& frame) {
  if (frame.kind == Kind::kHello) return hello(client, frame);
  if (!client.greeted) {
    client.refuse(frame.kind, "a connection begins with a greeting; connect with isotouch");
    client.leaving = true;
    return;
  }
  if (is_for_stop(client) && !belongs_to_a_stop(frame.kind)) {
    client.refuse(frame.kind, full());
    client.leaving = true;
    return;
  }
  requests_.answer(client, frame);
}

void ControlServer::hello(ControlClient& client, const protocol::Frame& frame) const {
  const auto greeting = protocol::decode<protocol::Hello>(frame.body);
  if (!greeting || greeting->major != protocol::kMajor) {
    const std::string theirs = greeting ? std::to_string(greeting->major) : "an unknown version";
    client.refuse(frame.kind, "the controller speaks version " + std::to_string(protocol::kMajor) + " of the protocol and the tool " +
                                  theirs + "; install the same release on both sides");
    client.leaving = true;
    return;
  }
  client.greeted = true;
  protocol::Welcome welcome;
  welcome.period_ns = settings_.recordings.period_ns;
  welcome.image_limit = neighbours_.fields.image_limit();
  welcome.program = protocol::Text::of(settings_.program);
  welcome.role = static_cast<std::uint8_t>(client.role);
  client.say(Kind::kWelcome, welcome);
}

/// A connection has ended, for whatever reason: what it had begun is void.
void ControlServer::forget(ControlClient& client) {
  requests_.forget(client);
  client.close();
}

/// Has it asked for what comes after the worker's work? Whoever has stopped in the middle of a frame has not.
bool ControlServer::waits_for_worker(const ControlClient& client) const {
  if (client.waiting || !client.has_unread()) return client.waiting;
  const Result<protocol::Frame> frame = client.frame();
  return frame && frame->size != 0 && requests_.must_wait(*frame);
}

/// Closes whoever stops in the middle of something, sends a field too slowly, does not complete its greeting, or holds the place for a stop for too long. A
/// client that has said and read everything may stay.
void ControlServer::dismiss_the_idle() {
  const std::int64_t since = neighbours_.clock.now_ns() - settings_.patience_ns;
  for (ControlClient& client : clients_) {
    const bool may_stay = client.greeted && !is_for_stop(client);
    const bool in_the_middle = client.leaving || client.has_unsent() || client.has_unread() || requests_.is_sending(client);
    const bool does_not_get_on =
        in_the_middle && client.moved_ns < since && !requests_.is_working();  // meanwhile it may wait for the worker
    const bool is_slow = requests_.sends_too_slowly(client) && !waits_for_worker(client);
    const bool is_late = does_not_get_on || is_slow || (!may_stay && client.opened_ns < since);
    if (client.is_open() && is_late) forget(client);
  }
}

}  // namespace isotouch::control
