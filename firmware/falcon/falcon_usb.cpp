#include "firmware/falcon/falcon_usb.h"

#include <libusb.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <utility>

#include "firmware/falcon/usb_bus.h"
#include "shared/bytes.h"

namespace isotouch::falcon {

namespace {

constexpr unsigned char kInEndpoint = 0x81, kOutEndpoint = 0x02;
constexpr int kInterface = 0;
constexpr unsigned kControlMs = 1000, kOutMs = 1000;
constexpr std::int64_t kMs = 1'000'000;
constexpr std::int64_t kLetGo = 50 * kMs;  // what was written before closing
constexpr std::int64_t kCancelled = 1000 * kMs;
constexpr int kErrorsInARow = 32;  // a disturbed line; more is a device that is going away

}  // namespace

/// The opened device with its transfers. Callbacks run only within the calls of the one thread that uses it.
class FalconUsb::Pipes {
 public:
  explicit Pipes(loop::Clock& clock) : clock_(clock) {
    for (In& in : in_) in.pipes = this;
    for (Out& out : out_) out.pipes = this;
  }
  ~Pipes() { close(); }
  Pipes(const Pipes&) = delete;
  Pipes& operator=(const Pipes&) = delete;

  LinkResult<void> open(const std::string& serial, FalconIdentity& identity) {
    if (libusb_init(&context_) != 0) return LinkError::kNoUsb;
    LinkError why = LinkError::kNotFound;
    const LinkResult<void> listed = for_each_falcon(context_, [&](libusb_device* device, const libusb_device_descriptor& descriptor) {
      const LinkResult<void> taken = take(device, descriptor, serial, identity);
      if (!taken && (why == LinkError::kNotFound || taken.error() != LinkError::kNotFound)) why = taken.error();
      return taken.has_value();
    });
    if (!listed) return listed.error();
    if (handle_ == nullptr) return why;
    return begin();
  }

  LinkResult<std::size_t> control(const UsbSetup& setup, std::span<std::uint8_t> answer) {
    if (gone_) return LinkError::kGone;
    const int done =
        libusb_control_transfer(handle_, setup[0], setup[1], load_le<std::uint16_t>(&setup[2]), load_le<std::uint16_t>(&setup[4]),
                                answer.data(), static_cast<std::uint16_t>(answer.size()), kControlMs);
    if (done >= 0) return static_cast<std::size_t>(done);
    const LinkError error = usb_error(done);
    gone_ = gone_ || error == LinkError::kGone;
    return error;
  }

  LinkResult<std::size_t> write(std::span<const std::uint8_t> data, std::int64_t until_ns) {
    const auto idle = [this] { return std::find_if(out_.begin(), out_.end(), [](const Out& out) { return !out.pending; }); };
    while (idle() == out_.end() && !gone_) {
      if (!handle_events(until_ns)) return LinkError::kTimedOut;
    }
    if (gone_) return LinkError::kGone;
    if (std::exchange(out_stalled_, false)) return libusb_clear_halt(handle_, kOutEndpoint), LinkError::kStalled;
    Out& out = *idle();
    const std::size_t size = std::min(data.size(), out.bytes.size());
    std::copy_n(data.begin(), size, out.bytes.begin());
    libusb_fill_bulk_transfer(out.transfer, handle_, kOutEndpoint, out.bytes.data(), static_cast<int>(size), &Pipes::out_ended, &out,
                              kOutMs);
    if (!submit(out)) return LinkError::kGone;
    return size;
  }

  LinkResult<std::size_t> read(std::span<std::uint8_t> buffer, std::int64_t until_ns) {
    while (ended_size_ == 0) {
      if (gone_) return LinkError::kGone;
      if (std::exchange(in_stalled_, false)) {
        libusb_clear_halt(handle_, kInEndpoint);
        submit_idle();
        return LinkError::kStalled;
      }
      if (!handle_events(until_ns)) return LinkError::kTimedOut;
    }
    In& in = *ended_[ended_first_];
    ended_first_ = (ended_first_ + 1) % ended_.size();
    --ended_size_;
    const std::size_t size = std::min(buffer.size(), static_cast<std::size_t>(in.transfer->actual_length));
    std::copy_n(in.bytes.begin(), size, buffer.begin());
    in.waiting = false;
    submit(in);
    return size;
  }

 private:
  template <std::size_t kSize>
  struct Transfer {
    Pipes* pipes = nullptr;
    libusb_transfer* transfer = nullptr;
    bool pending = false;  ///< libusb has it
    bool waiting = false;  ///< it has ended with bytes that were not read yet
    std::array<std::uint8_t, kSize> bytes{};
  };
  using In = Transfer<kUsbPacket>;
  using Out = Transfer<8 * kUsbPacket>;

  LinkResult<void> take(libusb_device* device, const libusb_device_descriptor& descriptor, const std::string& serial,
                        FalconIdentity& identity) {
    libusb_device_handle* handle = nullptr;
    if (const int opened = libusb_open(device, &handle); opened != 0) return usb_error(opened);
    const auto refuse = [&](LinkError error) {
      libusb_close(handle);
      return error;
    };
    FalconIdentity found = usb_identity(handle, descriptor);
    if (!serial.empty() && serial != found.serial) return refuse(LinkError::kNotFound);
    const int size = static_cast<int>(kUsbPacket);
    if (libusb_get_max_packet_size(device, kInEndpoint) != size || libusb_get_max_packet_size(device, kOutEndpoint) != size) {
      return refuse(LinkError::kUnsuitable);
    }
    libusb_set_auto_detach_kernel_driver(handle, 1);  // where that is not supported no driver is in the way either
    if (const int claimed = libusb_claim_interface(handle, kInterface); claimed != 0) return refuse(usb_error(claimed));
    handle_ = handle;
    identity = std::move(found);
    return {};
  }

  LinkResult<void> begin() {
    for (In& in : in_) {
      in.transfer = libusb_alloc_transfer(0);
      if (in.transfer == nullptr) return LinkError::kGone;
      libusb_fill_bulk_transfer(in.transfer, handle_, kInEndpoint, in.bytes.data(), static_cast<int>(in.bytes.size()), &Pipes::in_ended,
                                &in, 0);
    }
    for (Out& out : out_) {
      out.transfer = libusb_alloc_transfer(0);
      if (out.transfer == nullptr) return LinkError::kGone;
    }
    submit_idle();
    if (gone_) return LinkError::kGone;
    return {};
  }

  template <class Any>
  bool submit(Any& any) {
    any.pending = !gone_ && libusb_submit_transfer(any.transfer) == 0;
    gone_ = gone_ || !any.pending;
    return any.pending;
  }

  void submit_idle() {
    for (In& in : in_) {
      if (!in.pending && !in.waiting) submit(in);
    }
  }

  /// Waits until something happens; false when the time is over.
  bool handle_events(std::int64_t until_ns) {
    const std::int64_t left_us = std::max<std::int64_t>(until_ns - clock_.now_ns(), 0) / 1000;
    const bool over = left_us == 0;
    timeval wait{};
    wait.tv_sec = static_cast<decltype(wait.tv_sec)>(left_us / 1'000'000);
    wait.tv_usec = static_cast<decltype(wait.tv_usec)>(left_us % 1'000'000);
    const std::size_t before = ended_size_;
    libusb_handle_events_timeout_completed(context_, &wait, nullptr);
    return !over || ended_size_ > before;
  }

  static void LIBUSB_CALL in_ended(libusb_transfer* transfer) {
    In& in = *static_cast<In*>(transfer->user_data);
    in.pending = false;
    in.pipes->note(in);
  }

  static void LIBUSB_CALL out_ended(libusb_transfer* transfer) {
    Out& out = *static_cast<Out*>(transfer->user_data);
    out.pending = false;
    Pipes& pipes = *out.pipes;
    if (transfer->status == LIBUSB_TRANSFER_NO_DEVICE) pipes.gone_ = true;
    if (transfer->status != LIBUSB_TRANSFER_COMPLETED && transfer->status != LIBUSB_TRANSFER_CANCELLED) pipes.out_stalled_ = true;
  }

  void note(In& in) {
    switch (in.transfer->status) {
      case LIBUSB_TRANSFER_COMPLETED:
        errors_ = 0;
        in.waiting = true;
        ended_[(ended_first_ + ended_size_++) % ended_.size()] = &in;
        break;
      case LIBUSB_TRANSFER_CANCELLED: break;
      case LIBUSB_TRANSFER_NO_DEVICE: gone_ = true; break;
      case LIBUSB_TRANSFER_STALL: in_stalled_ = true; break;
      default: gone_ = gone_ || ++errors_ > kErrorsInARow; submit(in);
    }
  }

  bool any_pending() const {
    const auto is_pending = [](const auto& any) { return any.pending; };
    return std::any_of(in_.begin(), in_.end(), is_pending) || std::any_of(out_.begin(), out_.end(), is_pending);
  }

  void close() {
    if (handle_ != nullptr) {
      const auto written = [this] { return std::none_of(out_.begin(), out_.end(), [](const Out& out) { return out.pending; }); };
      for (const std::int64_t until = clock_.now_ns() + kLetGo; !written() && !gone_ && clock_.now_ns() < until;) handle_events(until);
      gone_ = true;  // nothing is submitted any more
      const auto cancel = [](auto& any) {
        if (any.pending) libusb_cancel_transfer(any.transfer);
      };
      std::for_each(in_.begin(), in_.end(), cancel);
      std::for_each(out_.begin(), out_.end(), cancel);
      for (const std::int64_t until = clock_.now_ns() + kCancelled; any_pending() && clock_.now_ns() < until;) handle_events(until);
      libusb_release_interface(handle_, kInterface);
      libusb_close(handle_);
    }
    // One that is still pending after a second is left to the system: freeing it would be worse.
    const auto free = [](auto& any) {
      if (!any.pending) libusb_free_transfer(any.transfer);
    };
    std::for_each(in_.begin(), in_.end(), free);
    std::for_each(out_.begin(), out_.end(), free);
    if (context_ != nullptr) libusb_exit(context_);
  }

  loop::Clock& clock_;
  libusb_context* context_ = nullptr;
  libusb_device_handle* handle_ = nullptr;
  std::array<In, 8> in_;
  std::array<Out, 4> out_;
  std::array<In*, 8> ended_{};  ///< a ring of those that wait to be read, in the order of their bytes
  std::size_t ended_first_ = 0, ended_size_ = 0;
  int errors_ = 0;
  bool gone_ = false, in_stalled_ = false, out_stalled_ = false;
};

FalconUsb::FalconUsb(loop::Clock& clock, std::string serial) : clock_(clock), serial_(std::move(serial)) {}

FalconUsb::~FalconUsb() = default;

LinkResult<void> FalconUsb::open() {
  close();
  auto pipes = std::make_unique<Pipes>(clock_);
  const LinkResult<void> opened = pipes->open(serial_, identity_);
  if (opened) pipes_ = std::move(pipes);
  return opened;
}

void FalconUsb::close() { pipes_.reset(); }

bool FalconUsb::is_open() const { return pipes_ != nullptr; }

LinkResult<std::size_t> FalconUsb::control(const UsbSetup& setup, std::span<std::uint8_t> answer) {
  if (!pipes_) return LinkError::kGone;
  return pipes_->control(setup, answer);
}

LinkResult<std::size_t> FalconUsb::write(std::span<const std::uint8_t> data, std::uint32_t timeout_ms) {
  if (!pipes_) return LinkError::kGone;
  return pipes_->write(data, clock_.now_ns() + std::int64_t{timeout_ms} * kMs);
}

LinkResult<std::size_t> FalconUsb::read(std::span<std::uint8_t> buffer, std::uint32_t timeout_ms) {
  assert(buffer.size() >= kUsbPacket);
  if (!pipes_) return LinkError::kGone;
  return pipes_->read(buffer, clock_.now_ns() + std::int64_t{timeout_ms} * kMs);
}

}  // namespace isotouch::falcon
