#include "hil/falcon_sim/usbredir_frontend.h"

#include <sys/socket.h>
#include <usbredirparser.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <deque>

#include "hil/falcon_sim/listener.h"

namespace isotouch::falcon_sim {

namespace {

using falcon_model::Bytes;
using namespace std::chrono_literals;

constexpr auto kPlugInterval = 200ms;  // an unplugged device asks so often whether it is plugged in again

class UsbredirFrontend final : public Frontend {
 public:
  UsbredirFrontend(const std::filesystem::path& path, PacedDevice& device) : listener_(path, SOCK_STREAM), device_(device) {}

  void wait_for(std::vector<pollfd>& wanted) const override {
    const bool writes = parser_ && usbredirparser_has_data_to_write(parser_.get()) > 0;
    wanted.push_back({peer_ ? peer_.get() : listener_.get(), static_cast<short>(writes ? POLLIN | POLLOUT : POLLIN), 0});
  }

  std::optional<Time> due() const override {
    if (!peer_ || !greeted_) return std::nullopt;
    if (!connected_) return next_try_;
    if (reads_.empty()) return std::nullopt;
    return device_.ready(std::max(reads_.front().asked, last_read_));
  }

  void serve(Time now) override {
    now_ = now;
    if (!peer_) welcome();
    if (!peer_) return;
    if (usbredirparser_do_read(parser_.get()) != 0) return dismiss();
    if (greeted_ && !connected_ && now >= next_try_) plug_in();
    if (connected_) finish_reads();
    if (connected_ && !device_.falcon().present()) unplug();
    if (usbredirparser_has_data_to_write(parser_.get()) > 0 && usbredirparser_do_write(parser_.get()) != 0) dismiss();
  }

 private:
  struct Read {
    std::uint64_t id;
    usb_redir_bulk_packet_header header;
    std::size_t capacity;
    Time asked;
  };
  struct Destroy {
    void operator()(usbredirparser* parser) const { usbredirparser_destroy(parser); }
  };

  static UsbredirFrontend& self(void* frontend) { return *static_cast<UsbredirFrontend*>(frontend); }

  void welcome() {
    peer_ = listener_.accept();
    if (!peer_) return;
    parser_.reset(usbredirparser_create());
    usbredirparser& p = *parser_;
    p.priv = this;
    p.log_func = [](void*, int level, const char* message) {
      if (level <= usbredirparser_warning) std::fprintf(stderr, "falcon-sim: usbredir: %s\n", message);
    };
    p.read_func = [](void* frontend, std::uint8_t* data, int count) {
      const ssize_t size = ::recv(self(frontend).peer_.get(), data, static_cast<std::size_t>(count), MSG_DONTWAIT);
      if (size < 0 && (errno == EAGAIN || errno == EINTR)) return 0;
      return size <= 0 ? -1 : static_cast<int>(size);
    };
    p.write_func = [](void* frontend, std::uint8_t* data, int count) {
      const ssize_t size = ::send(self(frontend).peer_.get(), data, static_cast<std::size_t>(count), MSG_NOSIGNAL | MSG_DONTWAIT);
      if (size < 0 && (errno == EAGAIN || errno == EINTR)) return 0;
      return size < 0 ? -1 : static_cast<int>(size);
    };
    p.hello_func = [](void* frontend, usb_redir_hello_header*) { self(frontend).greeted_ = true; };
    p.reset_func = [](void*) {};
    p.set_configuration_func = [](void* frontend, std::uint64_t id, usb_redir_set_configuration_header* wanted) {
      self(frontend).configure(id, wanted->configuration);
    };
    p.get_configuration_func = [](void* frontend, std::uint64_t id) { self(frontend).configure(id, 1); };
    p.set_alt_setting_func = [](void* frontend, std::uint64_t id, usb_redir_set_alt_setting_header* wanted) {
      self(frontend).tell_setting(id, wanted->interface, wanted->alt);
    };
    p.get_alt_setting_func = [](void* frontend, std::uint64_t id, usb_redir_get_alt_setting_header* wanted) {
      self(frontend).tell_setting(id, wanted->interface, 0);
    };
    p.cancel_data_packet_func = [](void* frontend, std::uint64_t id) { self(frontend).cancel(id); };
    p.device_disconnect_ack_func = [](void*) {};
    p.control_packet_func = [](void* frontend, std::uint64_t id, usb_redir_control_packet_header* header, std::uint8_t* data, int) {
      self(frontend).control(id, *header);
      usbredirparser_free_packet_data(self(frontend).parser_.get(), data);
    };
    p.bulk_packet_func = [](void* frontend, std::uint64_t id, usb_redir_bulk_packet_header* header, std::uint8_t* data, int size) {
      self(frontend).bulk(id, *header, {data, static_cast<std::size_t>(size)});
      usbredirparser_free_packet_data(self(frontend).parser_.get(), data);
    };
    std::array<std::uint32_t, USB_REDIR_CAPS_SIZE> capabilities{};
    for (const int capability : {usb_redir_cap_connect_device_version, usb_redir_cap_device_disconnect_ack,
                                 usb_redir_cap_ep_info_max_packet_size, usb_redir_cap_64bits_ids, usb_redir_cap_32bits_bulk_length}) {
      usbredirparser_caps_set_cap(capabilities.data(), capability);
    }
    usbredirparser_init(&p, "falcon-sim", capabilities.data(), USB_REDIR_CAPS_SIZE, usbredirparser_fl_usb_host);
    next_try_ = now_;
  }

  void dismiss() {
    parser_.reset();
    peer_.close();
    reads_.clear();
    greeted_ = connected_ = false;
  }

  /// Shows the device to the machine, if it is plugged in.
  void plug_in() {
    next_try_ = now_ + kPlugInterval;
    if (!device_.falcon().open()) return;
    usb_redir_interface_info_header interfaces{};
    interfaces.interface_count = 1;
    interfaces.interface_class[0] = interfaces.interface_subclass[0] = interfaces.interface_protocol[0] = 0xFF;
    usb_redir_ep_info_header endpoints{};
    std::fill(std::begin(endpoints.type), std::end(endpoints.type), std::uint8_t{usb_redir_type_invalid});
    // The table's places: endpoint number, plus 16 for those towards the host.
    endpoints.type[0] = endpoints.type[16] = usb_redir_type_control;
    endpoints.max_packet_size[0] = endpoints.max_packet_size[16] = 8;
    for (const int place : {falcon_model::kEndpointOut & 15, 16 + (falcon_model::kEndpointIn & 15)}) {
      endpoints.type[place] = usb_redir_type_bulk;
      endpoints.max_packet_size[place] = falcon_model::kUsbPacketBytes;
    }
    usb_redir_device_connect_header device{usb_redir_speed_full,  0, 0, 0, falcon_model::kVendor, falcon_model::kProduct,
                                           falcon_model::kRelease};
    usbredirparser_send_interface_info(parser_.get(), &interfaces);
    usbredirparser_send_ep_info(parser_.get(), &endpoints);
    usbredirparser_send_device_connect(parser_.get(), &device);
    connected_ = true;
  }

  void unplug() {
    reads_.clear();
    usbredirparser_send_device_disconnect(parser_.get());
    connected_ = false;
    next_try_ = now_ + kPlugInterval;
  }

  void configure(std::uint64_t id, std::uint8_t configuration) {
    usb_redir_configuration_status_header status{usb_redir_success, configuration};
    usbredirparser_send_configuration_status(parser_.get(), id, &status);
  }

  void tell_setting(std::uint64_t id, std::uint8_t interface_number, std::uint8_t setting) {
    usb_redir_alt_setting_status_header status{usb_redir_success, interface_number, setting};
    usbredirparser_send_alt_setting_status(parser_.get(), id, &status);
  }

  void control(std::uint64_t id, usb_redir_control_packet_header header) {
    const auto low = [](unsigned word) { return static_cast<std::uint8_t>(word & 0xFF); };
    const auto high = [](unsigned word) { return static_cast<std::uint8_t>(word >> 8); };
    const std::array<std::uint8_t, 8> setup = {header.requesttype, header.request,     low(header.value),  high(header.value),
                                               low(header.index),  high(header.index), low(header.length), high(header.length)};
    falcon_model::ControlAnswer answer = device_.falcon().control(setup);
    header.status = answer.stalled ? usb_redir_stall : usb_redir_success;
    if ((header.requesttype & 0x80) != 0) header.length = static_cast<std::uint16_t>(answer.data.size());
    usbredirparser_send_control_packet(parser_.get(), id, &header, answer.data.data(), static_cast<int>(answer.data.size()));
  }

  void bulk(std::uint64_t id, usb_redir_bulk_packet_header header, std::span<const std::uint8_t> data) {
    const std::size_t size = header.length | static_cast<std::size_t>(header.length_high) << 16;
    if (header.endpoint == falcon_model::kEndpointOut) {
      device_.write(data, now_);
      finish(id, header, usb_redir_success, {}, data.size());
    } else if (header.endpoint == falcon_model::kEndpointIn && size >= falcon_model::kUsbPacketBytes) {
      reads_.push_back({id, header, size, now_});
    } else {
      finish(id, header, usb_redir_babble, {}, 0);  // a packet of the chip's would not fit
    }
  }

  void finish_reads() {
    while (!reads_.empty() && device_.falcon().present() && *due() <= now_) {
      const Read read = reads_.front();
      reads_.pop_front();
      last_read_ = now_;
      Bytes data = device_.read(read.capacity, now_);
      const std::size_t size = data.size();
      finish(read.id, read.header, usb_redir_success, std::move(data), size);
    }
  }

  void cancel(std::uint64_t id) {
    const auto read = std::find_if(reads_.begin(), reads_.end(), [&](const Read& r) { return r.id == id; });
    if (read == reads_.end()) return;
    finish(id, read->header, usb_redir_cancelled, {}, 0);
    reads_.erase(read);
  }

  void finish(std::uint64_t id, usb_redir_bulk_packet_header header, std::uint8_t status, Bytes data, std::size_t length) {
    header.status = status;
    header.length = static_cast<std::uint16_t>(length & 0xFFFF);
    header.length_high = static_cast<std::uint16_t>(length >> 16);
    usbredirparser_send_bulk_packet(parser_.get(), id, &header, data.data(), static_cast<int>(data.size()));
  }

  Listener listener_;
  PacedDevice& device_;
  Descriptor peer_;
  std::unique_ptr<usbredirparser, Destroy> parser_;
  std::deque<Read> reads_;
  Time now_{}, last_read_{}, next_try_{};
  bool greeted_ = false;    ///< the other side has said hello
  bool connected_ = false;  ///< the machine has been shown the device
};

}  // namespace

std::unique_ptr<Frontend> make_usbredir_frontend(const std::filesystem::path& path, PacedDevice& device) {
  return std::make_unique<UsbredirFrontend>(path, device);
}

}  // namespace isotouch::falcon_sim
