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

namespace isotouch::link {

namespace {

/// Sends, and a connection that must be waited for, fail after that time.
void limit_sending(int socket, int patience_ms) {
  const timeval longest{patience_ms / 1000, patience_ms % 1000 * 1000};
  if (patience_ms > 0) (void)::setsockopt(socket, SOL_SOCKET, SO_SNDTIMEO, &longest, sizeof longest);
}

int connect_to(const Address& address, int patience_ms) {
  sockaddr_un name{};
  name.sun_family = AF_UNIX;
  if (address.socket.size() >= sizeof name.sun_path) {
    throw InputError(address.text + ": is too long for the path of a socket (at most 107 characters); use a shorter one");
  }
  std::copy(address.socket.begin(), address.socket.end(), name.sun_path);
  const int socket = ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
  if (socket >= 0) limit_sending(socket, patience_ms);
  if (socket >= 0 && ::connect(socket, reinterpret_cast<const sockaddr*>(&name), sizeof name) == 0) return socket;
  const std::string why = std::strerror(errno);
  if (socket >= 0) ::close(socket);
  throw InputError(address.text + ": no controller answers there (" + why + "); start isotouchd, or check the path and its permissions");
}

}  // namespace

Connection::Connection(const Address& address, int patience_ms, std::function<bool()> is_over)
    : address_(address),
      send_patience_ms_(patience_ms),
      is_over_(std::move(is_over)),
      owner_(::getpid()),
      frame_(protocol::kMaxFrame),
      in_(2 * protocol::kMaxFrame) {
  stream_ = address.is_remote() ? run_child(ssh_command(address, ssh_program(), relay_command(address)), address.text, child_)
                                : connect_to(address, patience_ms);
  if (address.is_remote()) limit_sending(stream_, patience_ms);
}

Connection::~Connection() {
  if (stream_ >= 0) ::close(stream_);
  if (child_ <= 0 || ::getpid() != owner_) return;  // a fork's copy: the ssh belongs to the process that began it
  ::kill(child_, SIGTERM);                          // all answers are there; a connection that hangs is not waited for
  ::waitpid(child_, nullptr, 0);
}

void Connection::send_frame(std::size_t bytes) {
  for (std::size_t sent = 0; sent < bytes && !broken_;) {
    const ssize_t taken = ::send(stream_, frame_.data() + sent, bytes - sent, MSG_NOSIGNAL | (is_over_ ? MSG_DONTWAIT : 0));
    if (taken < 0 && errno == EINTR) continue;
    if (taken < 0 && is_over_ && errno == EAGAIN && can_send()) continue;
    if (taken < 0) broken_ = true;  // it may have said why
    if (taken > 0) sent += static_cast<std::size_t>(taken);
  }
}

/// Waits until the other side takes more.
///
/// returns   false: it did not in time, or nobody wants it any more
bool Connection::can_send() {
  constexpr int kAsksOverMs = 100;
  for (int waited = 0; send_patience_ms_ == 0 || waited < send_patience_ms_; waited += kAsksOverMs) {
    pollfd one{stream_, POLLOUT, 0};
    if (::poll(&one, 1, kAsksOverMs) > 0) return true;
    if (is_over_()) return false;
  }
  return false;
}

protocol::Frame Connection::receive(int patience_ms) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point end = Clock::now() + std::chrono::milliseconds(patience_ms);  // signals and single bytes do not move it
  for (;;) {
    const auto frame = protocol::read_frame(std::span(in_).subspan(used_, in_size_ - used_));
    if (!frame) {
      throw InputError(address_.text + ": what answers is not a controller of this release (" + describe(frame.error()) +
                       "); check the address, and check that the login there prints nothing");
    }
    if (frame->size > 0) {
      used_ += frame->size;
      return *frame;
    }
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(end - Clock::now()).count();
    if (!read_more(static_cast<int>(std::max<std::int64_t>(left, 0))))
      throw InputError(address_.text + ": the controller does not answer; check whether it runs");
  }
}

bool Connection::has_input(int patience_ms) {
  const auto frame = protocol::read_frame(std::span(in_).subspan(used_, in_size_ - used_));
  if (!frame || frame->size > 0) return true;
  pollfd one{stream_, POLLIN, 0};
  return ::poll(&one, 1, patience_ms) > 0;
}

/// returns   false: nothing has come in time
bool Connection::read_more(int patience_ms) {
  std::copy(in_.begin() + static_cast<std::ptrdiff_t>(used_), in_.begin() + static_cast<std::ptrdiff_t>(in_size_), in_.begin());
  in_size_ -= used_;
  used_ = 0;
  pollfd one{stream_, POLLIN, 0};
  const int ready = ::poll(&one, 1, patience_ms);
  if (ready < 0 && errno == EINTR) return true;
  if (ready == 0) return false;
  const ssize_t got = ::recv(stream_, in_.data() + in_size_, in_.size() - in_size_, 0);
  if (got < 0 && errno == EINTR) return true;
  if (got <= 0) complain_of_the_end();
  in_size_ += static_cast<std::size_t>(got);
  return true;
}

void Connection::complain_of_the_end() {
  if (child_ > 0) {
    int status = 0;
    ::waitpid(child_, &status, 0);
    child_ = -1;
    if (WIFEXITED(status) && WEXITSTATUS(status) != 0) {
      throw InputError(address_.text + ": ssh ended with status " + std::to_string(WEXITSTATUS(status)) +
                       " before the controller had answered; see its messages, and check that isotouchd is installed there");
    }
  }
  throw InputError(address_.text + ": the controller closed the connection; check whether it still runs");
}

}  // namespace isotouch::link
