#include "firmware/control/control_client.h"

#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cassert>
#include <cerrno>

namespace isotouch::control {

void ControlClient::open(int socket, const Peer& peer, protocol::Role its_role, std::int64_t now_ns) {
  socket_ = socket;
  role = its_role;
  user = static_cast<std::uint32_t>(peer.user);
  in_size_ = out_begin_ = out_end_ = 0;
  greeted = waiting = leaving = records = false;
  every = ring_lost = 0;
  lost = 0;
  opened_ns = moved_ns = now_ns;
}

void ControlClient::close() {
  if (socket_ >= 0) ::close(socket_);
  socket_ = -1;
  every = 0;
  waiting = records = false;
}

bool ControlClient::receive(std::int64_t now_ns) {
  const ssize_t got = ::recv(socket_, in_.data() + in_size_, in_.size() - in_size_, 0);
  if (got < 0) return errno == EAGAIN || errno == EINTR;
  if (in_size_ == 0) moved_ns = now_ns;
  in_size_ += static_cast<std::size_t>(got);
  return got > 0;
}

void ControlClient::drop(std::size_t bytes, std::int64_t now_ns) {
  moved_ns = now_ns;
  std::copy(in_.begin() + static_cast<std::ptrdiff_t>(bytes), in_.begin() + static_cast<std::ptrdiff_t>(in_size_), in_.begin());
  in_size_ -= bytes;
}

void ControlClient::refuse(protocol::Kind request, std::string_view sentence) {
  sentence = sentence.substr(0, protocol::kMaxSentence);
  say(protocol::Kind::kRefused,
      protocol::Refusal{static_cast<std::uint8_t>(request), {reinterpret_cast<const std::uint8_t*>(sentence.data()), sentence.size()}});
}

bool ControlClient::send(std::int64_t now_ns) {
  while (has_unsent()) {
    const ssize_t taken = ::send(socket_, out_.data() + out_begin_, out_end_ - out_begin_, MSG_NOSIGNAL);
    if (taken < 0 && errno == EINTR) continue;
    if (taken < 0) return errno == EAGAIN;
    out_begin_ += static_cast<std::size_t>(taken);
    moved_ns = now_ns;
  }
  out_begin_ = out_end_ = 0;
  return true;
}

std::span<std::uint8_t> ControlClient::room() {
  if (out_.size() - out_end_ < protocol::kMaxFrame) {
    std::copy(out_.begin() + static_cast<std::ptrdiff_t>(out_begin_), out_.begin() + static_cast<std::ptrdiff_t>(out_end_), out_.begin());
    out_end_ -= out_begin_;
    out_begin_ = 0;
  }
  assert(out_.size() - out_end_ >= protocol::kMaxFrame);
  return std::span(out_).subspan(out_end_);
}

}  // namespace isotouch::control
