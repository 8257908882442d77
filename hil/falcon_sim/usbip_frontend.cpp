#include "hil/falcon_sim/usbip_frontend.h"

#include <fcntl.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <deque>
#include <stdexcept>
#include <string>
#include <utility>

namespace isotouch::falcon_sim {

namespace {

using falcon_model::Bytes;
using namespace std::chrono_literals;

constexpr auto kPlugInterval = 200ms;  // an unplugged device asks so often whether it is plugged in again
constexpr std::size_t kHeaderBytes = 48;
constexpr std::uint32_t kSubmit = 1, kUnlink = 2, kSubmitted = 3, kUnlinked = 4;
constexpr std::uint32_t kMaxTransfer = 1U << 20;
constexpr int kDone = 0, kBroken = -EPIPE, kCancelled = -ECONNRESET;

std::uint32_t word_at(const std::uint8_t* at) {
  return static_cast<std::uint32_t>(at[0]) << 24 | static_cast<std::uint32_t>(at[1]) << 16 | static_cast<std::uint32_t>(at[2]) << 8 | at[3];
}

void put_word(std::uint8_t* at, std::uint32_t word) {
  for (unsigned i = 0; i < 4; ++i) at[i] = static_cast<std::uint8_t>(word >> (24 - 8 * i));
}

/// One request as it came, by the names of the protocol's fields.
struct Request {
  std::uint32_t command, number, direction, endpoint;
  std::uint32_t length;    ///< of a submission's buffer
  std::uint32_t unlinked;  ///< the submission that is taken back
  std::array<std::uint8_t, 8> setup;

  static Request from(const std::uint8_t* header) {
    Request request{
        word_at(header), word_at(header + 4), word_at(header + 12), word_at(header + 16), word_at(header + 24), word_at(header + 20), {}};
    std::copy_n(header + 40, request.setup.size(), request.setup.begin());
    return request;
  }
  bool towards_host() const { return direction == 1; }
  /// Bytes that follow the header.
  std::size_t following() const { return command == kSubmit && !towards_host() ? length : 0; }
};

class UsbipFrontend final : public Frontend {
 public:
  UsbipFrontend(AttachPort attach, PacedDevice& device) : attach_(std::move(attach)), device_(device) { plug_in(); }

  void wait_for(std::vector<pollfd>& wanted) const override {
    if (kernel_) wanted.push_back({kernel_.get(), POLLIN, 0});
  }

  std::optional<Time> due() const override {
    if (!kernel_) return next_try_;
    if (reads_.empty()) return std::nullopt;
    return device_.ready(std::max(reads_.front().asked, last_read_));
  }

  void serve(Time now) override {
    now_ = now;
    if (!kernel_ && now >= next_try_) plug_in();
    if (!kernel_) return;
    if (!receive()) return unplug();
    while (serve_one()) {
    }
    if (!lost_) finish_reads();
    if (lost_ || !device_.falcon().present()) unplug();
  }

 private:
  struct Read {
    std::uint32_t number;
    std::size_t capacity;
    Time asked;
  };

  void plug_in() {
    next_try_ = now_ + kPlugInterval;
    if (!device_.falcon().open()) return;
    std::array<int, 2> ends{};
    if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0)
      throw std::runtime_error(std::string("the sockets for the kernel cannot be made: ") + std::strerror(errno));
    kernel_ = Descriptor(ends[0]);
    if (!attach_(Descriptor(ends[1]))) kernel_.close();
  }

  /// To the kernel the device is unplugged when the socket closes.
  void unplug() {
    kernel_.close();
    received_.clear();
    reads_.clear();
    lost_ = false;
    next_try_ = now_ + kPlugInterval;
  }

  /// Takes what has come; false when the kernel has let go of the device.
  bool receive() {
    std::array<std::uint8_t, 4096> some{};
    while (true) {
      const ssize_t size = ::recv(kernel_.get(), some.data(), some.size(), MSG_DONTWAIT);
      if (size < 0) return errno == EAGAIN || errno == EINTR;
      if (size == 0) return false;
      received_.insert(received_.end(), some.begin(), some.begin() + size);
    }
  }

  bool serve_one() {
    if (lost_ || received_.size() < kHeaderBytes) return false;
    const Request request = Request::from(received_.data());
    const bool known = request.command == kSubmit || request.command == kUnlink;
    if (!known || request.following() > kMaxTransfer) {
      lost_ = true;  // out of step: the port starts anew
      return false;
    }
    const std::size_t size = kHeaderBytes + request.following();
    if (received_.size() < size) return false;
    const Bytes data(received_.begin() + kHeaderBytes, received_.begin() + static_cast<std::ptrdiff_t>(size));
    received_.erase(received_.begin(), received_.begin() + static_cast<std::ptrdiff_t>(size));
    if (request.command == kUnlink) {
      unlink(request);
    } else if (request.endpoint == 0) {
      control(request);
    } else {
      bulk(request, data);
    }
    return true;
  }

  void control(const Request& request) {
    const falcon_model::ControlAnswer answer = device_.falcon().control(request.setup);
    if (answer.stalled) return reply(kSubmitted, request.number, kBroken, 0, {});
    const std::size_t size = request.towards_host() ? std::min<std::size_t>(answer.data.size(), request.length) : request.length;
    reply(kSubmitted, request.number, kDone, size,
          request.towards_host() ? std::span(answer.data).first(size) : std::span<const std::uint8_t>());
  }

  void bulk(const Request& request, std::span<const std::uint8_t> data) {
    if (request.endpoint == (falcon_model::kEndpointOut & 15U) && !request.towards_host()) {
      device_.write(data, now_);
      reply(kSubmitted, request.number, kDone, data.size(), {});
    } else if (request.endpoint == (falcon_model::kEndpointIn & 15U) && request.towards_host() &&
               request.length >= falcon_model::kUsbPacketBytes) {
      reads_.push_back({request.number, request.length, now_});
    } else {
      reply(kSubmitted, request.number, kBroken, 0, {});
    }
  }

  void unlink(const Request& request) {
    const auto read = std::find_if(reads_.begin(), reads_.end(), [&](const Read& r) { return r.number == request.unlinked; });
    const bool pending = read != reads_.end();
    if (pending) reads_.erase(read);
    reply(kUnlinked, request.number, pending ? kCancelled : kDone, 0, {});
  }

  void finish_reads() {
    while (!reads_.empty() && device_.falcon().present() && *due() <= now_) {
      const Read read = reads_.front();
      reads_.pop_front();
      last_read_ = now_;
      const Bytes data = device_.read(read.capacity, now_);
      reply(kSubmitted, read.number, kDone, data.size(), data);
    }
  }

  void reply(std::uint32_t kind, std::uint32_t number, int status, std::size_t length, std::span<const std::uint8_t> data) {
    Bytes message(kHeaderBytes, 0);
    put_word(&message[0], kind);
    put_word(&message[4], number);
    put_word(&message[20], static_cast<std::uint32_t>(status));
    if (kind == kSubmitted) put_word(&message[24], static_cast<std::uint32_t>(length));
    message.insert(message.end(), data.begin(), data.end());
    // The kernel reads as it is written to: a whole message that does not fit means that it has stopped.
    const ssize_t sent = ::send(kernel_.get(), message.data(), message.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
    if (sent != static_cast<ssize_t>(message.size())) lost_ = true;
  }

  AttachPort attach_;
  PacedDevice& device_;
  Descriptor kernel_;
  Bytes received_;
  std::deque<Read> reads_;
  Time now_{}, last_read_{}, next_try_{};
  bool lost_ = false;  ///< the two sides do not understand each other
};

}  // namespace

AttachPort vhci_port(std::filesystem::path controller) {
  return [file = controller / "attach"](Descriptor kernels_end) {
    constexpr int kFirstPort = 0, kDevice = 1 << 16 | 1, kFullSpeed = 2;
    std::string line = std::to_string(kFirstPort);
    for (const int number : {kernels_end.get(), kDevice, kFullSpeed}) line += ' ' + std::to_string(number);
    const Descriptor out(::open(file.c_str(), O_WRONLY | O_CLOEXEC));
    if (out && ::write(out.get(), line.data(), line.size()) == static_cast<ssize_t>(line.size())) return true;
    if (errno != EBUSY)
      throw std::runtime_error(file.string() + ": " + std::strerror(errno) + "; load the kernel's module vhci_hcd, and be root");
    return false;
  };
}

std::unique_ptr<Frontend> make_usbip_frontend(AttachPort attach, PacedDevice& device) {
  return std::make_unique<UsbipFrontend>(std::move(attach), device);
}

}  // namespace isotouch::falcon_sim
