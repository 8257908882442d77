#include "firmware/falcon/sim_link.h"

#include <poll.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <utility>

#include "shared/bytes.h"
#include "shared/printable.h"

namespace isotouch::falcon {

namespace {

constexpr std::size_t kMaxMessage = 8192;
constexpr std::size_t kMaxWrite = 4096;
constexpr std::uint32_t kPatienceMs = 2000;  // beyond the request's own timeout: a simulator that hangs is gone
constexpr std::size_t kDescriptor = 18;

LinkError error_of(int code) {
  switch (code) {
    case EACCES:
    case EPERM: return LinkError::kNotAllowed;
    case EAGAIN: return LinkError::kBusy;
    default: return LinkError::kNotFound;
  }
}

}  // namespace

SimLink::SimLink(std::string path) : path_(std::move(path)), message_(kMaxMessage) {}

SimLink::~SimLink() { SimLink::close(); }

LinkResult<void> SimLink::open() {
  close();
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  if (path_.size() >= sizeof address.sun_path) return LinkError::kNotFound;
  std::copy(path_.begin(), path_.end(), address.sun_path);
  socket_ =
      ::socket(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);  // a simulator that accepts nobody is busy, and not waited for
  if (socket_ < 0) return error_of(errno);
  if (::connect(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0) {
    const LinkError error = error_of(errno);
    close();
    return error;
  }
  const LinkResult<std::span<const std::uint8_t>> answer = ask('D', 1, 0);
  if (!answer) return answer.error();
  if (take_identity(*answer)) return {};
  close();
  return LinkError::kUnsuitable;
}

void SimLink::close() {
  if (socket_ >= 0) ::close(socket_);
  socket_ = -1;
}

LinkResult<std::size_t> SimLink::control(const UsbSetup& setup, std::span<std::uint8_t> answer) {
  std::copy(setup.begin(), setup.end(), message_.begin() + 1);
  const LinkResult<std::span<const std::uint8_t>> data = ask_for_status('C', 1 + setup.size(), 0);
  if (!data) return data.error();
  const std::size_t size = std::min(data->size(), answer.size());
  std::copy_n(data->begin(), size, answer.begin());
  return size;
}

LinkResult<std::size_t> SimLink::write(std::span<const std::uint8_t> data, std::uint32_t timeout_ms) {
  const std::size_t size = std::min(data.size(), kMaxWrite);
  std::copy_n(data.begin(), size, message_.begin() + 1);
  const LinkResult<std::span<const std::uint8_t>> answer = ask_for_status('O', 1 + size, timeout_ms);
  if (!answer) return answer.error();
  if (answer->size() < 2) return gone();
  return std::min<std::size_t>(load_le<std::uint16_t>(answer->data()), size);
}

LinkResult<std::size_t> SimLink::read(std::span<std::uint8_t> buffer, std::uint32_t timeout_ms) {
  const std::size_t capacity = std::min<std::size_t>(buffer.size(), kMaxWrite) / kUsbPacket * kUsbPacket;
  store_le(&message_[1], static_cast<std::uint16_t>(capacity));
  store_le(&message_[3], std::max(timeout_ms, 1U));  // to the simulator, as on USB, 0 is for ever
  const LinkResult<std::span<const std::uint8_t>> data = ask_for_status('I', 7, timeout_ms);
  if (!data) return data.error();
  if (data->size() > capacity) return gone();
  std::copy(data->begin(), data->end(), buffer.begin());
  return data->size();
}

/// Sends the first `size` bytes of the message and returns what follows the kind in the answer.
LinkResult<std::span<const std::uint8_t>> SimLink::ask(std::uint8_t kind, std::size_t size, std::uint32_t timeout_ms) {
  if (socket_ < 0) return LinkError::kGone;
  message_[0] = kind;
  if (::send(socket_, message_.data(), size, MSG_NOSIGNAL) != static_cast<ssize_t>(size)) return gone();
  pollfd ready{socket_, POLLIN, 0};
  int polled = 0;
  do {
    polled = ::poll(&ready, 1, static_cast<int>(std::min<std::uint32_t>(timeout_ms, 1U << 20) + kPatienceMs));
  } while (polled < 0 && errno == EINTR);
  if (polled <= 0) return gone();
  const ssize_t got = ::recv(socket_, message_.data(), message_.size(), 0);
  const std::uint8_t answer_kind = kind | 0x20U;  // the same letter, small
  if (got < 1 || message_[0] != answer_kind) return gone();
  return std::span<const std::uint8_t>(message_).subspan(1, static_cast<std::size_t>(got) - 1);
}

/// As `ask`, without the status that the answer begins with.
LinkResult<std::span<const std::uint8_t>> SimLink::ask_for_status(std::uint8_t kind, std::size_t size, std::uint32_t timeout_ms) {
  const LinkResult<std::span<const std::uint8_t>> answer = ask(kind, size, timeout_ms);
  if (!answer) return answer;
  if (answer->empty()) return gone();
  switch (answer->front()) {
    case 0: return answer->subspan(1);
    case 1: return LinkError::kStalled;
    case 2: return LinkError::kTimedOut;
    default: return gone();
  }
}

bool SimLink::take_identity(std::span<const std::uint8_t> answer) {
  if (answer.size() < kDescriptor) return false;
  identity_.vendor = load_le<std::uint16_t>(&answer[8]);
  identity_.product = load_le<std::uint16_t>(&answer[10]);
  identity_.release = load_le<std::uint16_t>(&answer[12]);
  answer = answer.subspan(kDescriptor);
  for (std::string* text : {&identity_.manufacturer, &identity_.name, &identity_.serial}) {
    if (answer.empty() || answer.size() - 1 < answer[0]) return false;
    text->assign(answer.begin() + 1, answer.begin() + 1 + answer[0]);
    make_printable(*text, '?');
    answer = answer.subspan(std::size_t{1} + answer[0]);
  }
  return identity_.vendor == kFalconVendor && identity_.product == kFalconProduct;
}

/// Whatever breaks the dialogue ends it: request and answer would no longer belong together.
LinkError SimLink::gone() {
  close();
  return LinkError::kGone;
}

}  // namespace isotouch::falcon
