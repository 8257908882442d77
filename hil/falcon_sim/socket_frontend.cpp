#include "hil/falcon_sim/socket_frontend.h"

#include <sys/socket.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>

namespace isotouch::falcon_sim {

SocketFrontend::SocketFrontend(const std::filesystem::path& path, PacedDevice& device)
    : listener_(path, SOCK_SEQPACKET), device_(device), buffer_(kMaxMessage + 1) {}

void SocketFrontend::wait_for(std::vector<pollfd>& wanted) const {
  if (!client_) {
    wanted.push_back({listener_.get(), POLLIN, 0});
  } else {
    wanted.push_back({client_.get(), static_cast<short>(pending_ ? 0 : POLLIN), 0});  // a client that leaves is told in any case
  }
}

std::optional<Time> SocketFrontend::due() const {
  if (!client_ || !pending_) return std::nullopt;
  return deadline(*pending_);
}

Time SocketFrontend::deadline(const Pending& pending) const {
  const Time ready = device_.ready(pending.asked);
  if (pending.request.timeout_ms == 0) return ready;
  return std::min(ready, pending.asked + std::chrono::milliseconds(pending.request.timeout_ms));
}

void SocketFrontend::serve(Time now) {
  if (!client_) welcome();
  while (client_) {
    if (pending_) {
      if (now < deadline(*pending_)) {
        char none = 0;  // still there?
        if (::recv(client_.get(), &none, 1, MSG_PEEK | MSG_DONTWAIT) == 0) client_.close();
        return;
      }
      finish_read(now);
    } else if (!serve_one(now)) {
      return;
    }
  }
}

/// Lets the next client in, unless the device is unplugged: then the door closes again at once.
void SocketFrontend::welcome() {
  client_ = listener_.accept();
  pending_.reset();
  if (client_ && !device_.falcon().open()) client_.close();
}

void SocketFrontend::finish_read(Time now) {
  const Pending pending = *pending_;
  pending_.reset();
  if (!device_.falcon().present()) {
    send(read_answer(kGone, {}));
  } else if (now < device_.ready(pending.asked)) {
    send(read_answer(kTimedOut, {}));
  } else {
    send(read_answer(kOk, device_.read(pending.request.capacity, now)));
  }
}

/// One request, if one is there.
bool SocketFrontend::serve_one(Time now) {
  const ssize_t size = ::recv(client_.get(), buffer_.data(), buffer_.size(), MSG_DONTWAIT);
  if (size < 0 && (errno == EAGAIN || errno == EINTR)) return false;
  if (size <= 0) {
    client_.close();
    return false;
  }
  const std::span<const std::uint8_t> message(buffer_.data(), static_cast<std::size_t>(size));
  if (const auto request = parse_read(message)) {
    pending_ = Pending{*request, now};
    return true;
  }
  const Bytes reply = answer(message, device_, now);
  if (reply.empty()) {
    std::fprintf(stderr, "falcon-sim: unknown request, first byte %d, %zd bytes; its client is disconnected\n", message[0], size);
    client_.close();
    return false;
  }
  send(reply);
  return true;
}

void SocketFrontend::send(const Bytes& reply) {
  const bool sent = ::send(client_.get(), reply.data(), reply.size(), MSG_NOSIGNAL) == static_cast<ssize_t>(reply.size());
  if (!sent || says_gone(reply)) client_.close();
}

}  // namespace isotouch::falcon_sim
