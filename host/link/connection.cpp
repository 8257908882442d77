#include "host/link/connection.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <utility>

#include "host/error.h"
#include "host/link/child.h"
#include "host/link/link_error.h"

namespace isotouch::link {

namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds kAsksEvery{100};  ///< whether anybody still waits

[[noreturn]] void complain_of_nobody(const Address& address) { throw LinkError(address.text + ": nobody waits for its answer any more"); }

/// patience_ms   0: for ever
Clock::time_point end_of(int patience_ms) {
  return patience_ms > 0 ? Clock::now() + std::chrono::milliseconds(patience_ms) : Clock::time_point::max();
}

int connect_to(const Address& address, int patience_ms, const std::function<bool()>& is_over) {
  sockaddr_un name{};
  name.sun_family = AF_UNIX;
  if (address.socket.size() >= sizeof name.sun_path) {
    throw InputError(address.text + ": is too long for the path of a socket (at most 107 characters); use a shorter one");
  }
  std::copy(address.socket.begin(), address.socket.end(), name.sun_path);
  const Clock::time_point end = end_of(patience_ms > 0 ? patience_ms : kGreetingMs);
  const int socket = ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
  const timeval step{0, std::chrono::microseconds(kAsksEvery).count()};
  if (socket >= 0)
    (void)::setsockopt(socket, SOL_SOCKET, SO_SNDTIMEO, &step, sizeof step);  // a full queue at the door is waited for in steps
  int failed = errno;
  while (socket >= 0) {
    if (::connect(socket, reinterpret_cast<const sockaddr*>(&name), sizeof name) == 0) return socket;
    failed = errno;
    if ((failed != EAGAIN && failed != EINTR) || Clock::now() >= end) break;
    if (!is_over || !is_over()) continue;
    ::close(socket);
    complain_of_nobody(address);
  }
  if (socket >= 0) ::close(socket);
  if (failed == EAGAIN && patience_ms > 0 && patience_ms < kGreetingMs)
    throw InputError(address.text + ": the controller lets nobody in within " + std::to_string(patience_ms) +
                     " ms; allow it a longer time");
  if (failed == EAGAIN)
    throw InputError(address.text +
                     ": the controller lets nobody in; press the emergency stop if there is force, and start isotouchd again");
  throw InputError(address.text + ": no controller answers there (" + std::strerror(failed) +
                   "); start isotouchd, or check the path and its permissions");
}

}  // namespace

Connection::Connection(const Address& address, int patience_ms, std::function<bool()> is_over)
    : address_(address),
      send_patience_ms_(patience_ms),
      is_over_(std::move(is_over)),
      owner_(::getpid()),
      frame_(protocol::kMaxFrame),
      in_(2 * protocol::kMaxFrame) {
  if (address.is_remote()) {
    const bool is_deaf = static_cast<bool>(is_over_);
    stream_ = run_child(ssh_command(address, ssh_program(), relay_command(address)), address.text, child_, is_deaf);
  } else {
    stream_ = connect_to(address, patience_ms, is_over_);
  }
}

Connection::~Connection() {
  if (stream_ >= 0) ::close(stream_);
  if (child_ <= 0 || ::getpid() != owner_) return;  // a fork's copy: the ssh belongs to the process that began it
  ::kill(child_, SIGTERM);                          // all answers are there; a connection that hangs is not waited for
  ::waitpid(child_, nullptr, 0);
}

void Connection::send_frame(std::size_t bytes) {
  if (has_ended_)
    throw LinkError(address_.text +
                    ": an answer before did not come in time or did not fit, so what comes now is not trusted; connect again");
  const Clock::time_point end = end_of(send_patience_ms_);
  for (std::size_t sent = 0; sent < bytes && !broken_;) {
    const ssize_t taken = ::send(stream_, frame_.data() + sent, bytes - sent, MSG_NOSIGNAL | MSG_DONTWAIT);
    if (taken > 0) sent += static_cast<std::size_t>(taken);
    if (taken >= 0 || errno == EINTR) continue;
    const bool is_full = errno == EAGAIN;
    broken_ = true;  // also where nobody waits any more: a part of a frame may be sent
    broken_ = !is_full || !wait(POLLOUT, end);
  }
}

/// Waits until the other side takes more, or has said more.
///
/// event     POLLOUT or POLLIN
/// returns   false: not in time
/// fails     InputError: nobody waits any more
bool Connection::wait(short event, Clock::time_point end, const std::function<bool()>& enough) {
  for (;;) {
    const Clock::time_point now = Clock::now();
    const auto left = std::clamp(std::chrono::ceil<std::chrono::milliseconds>(end - now), 0ms, kAsksEvery);
    pollfd one{stream_, event, 0};
    const int ready = ::poll(&one, 1, static_cast<int>(left.count()));
    if (ready == 0 || now - asked_ >= kAsksEvery) {  // also where a little comes again and again
      asked_ = now;
      if ((is_over_ && is_over_()) || (enough && enough())) complain_of_nobody(address_);
    }
    if (ready > 0) return true;
    if (now >= end) return false;
  }
}

protocol::Frame Connection::receive(int patience_ms, const std::function<bool()>& enough) {
  end_conversation();  // unless a frame comes
  const Clock::time_point end =
      Clock::now() + std::chrono::milliseconds(broken_ ? 0 : patience_ms);  // what a broken one had to say is here
  for (;;) {
    const auto frame = protocol::read_frame(std::span(in_).subspan(used_, in_size_ - used_));
    if (!frame) {
      throw InputError(address_.text + ": what answers is not a controller of this release (" + describe(frame.error()) +
                       "); check the address, and check that the login there prints nothing");
    }
    if (frame->size > 0) {
      used_ += frame->size;
      has_ended_ = false;
      return *frame;
    }
    if (!wait(POLLIN, end, enough)) throw LinkError(address_.text + ": the controller does not answer; check whether it runs");
    read_more();
  }
}

bool Connection::has_input(int patience_ms) {
  const auto frame = protocol::read_frame(std::span(in_).subspan(used_, in_size_ - used_));
  if (!frame || frame->size > 0) return true;
  pollfd one{stream_, POLLIN, 0};
  return ::poll(&one, 1, patience_ms) > 0;
}

void Connection::read_more() {
  std::copy(in_.begin() + static_cast<std::ptrdiff_t>(used_), in_.begin() + static_cast<std::ptrdiff_t>(in_size_), in_.begin());
  in_size_ -= used_;
  used_ = 0;
  const ssize_t got = ::recv(stream_, in_.data() + in_size_, in_.size() - in_size_, 0);
  if (got < 0 && errno == EINTR) return;
  if (got <= 0) complain_of_the_end();
  in_size_ += static_cast<std::size_t>(got);
}

void Connection::complain_of_the_end() {
  if (child_ > 0) {
    int status = 0;
    ::waitpid(child_, &status, 0);
    child_ = -1;
    if (WIFEXITED(status) && WEXITSTATUS(status) != 0) {
      throw LinkError(address_.text + ": ssh ended with status " + std::to_string(WEXITSTATUS(status)) +
                      " before the controller had answered; see its messages, and check that isotouchd is installed there");
    }
  }
  throw LinkError(
      address_.text +
      ": the controller closed the connection; check whether it still runs; it also closes a client that reads nothing for 10 s");
}

}  // namespace isotouch::link
