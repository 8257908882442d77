/// The library's other half plays the virtual machine.
#include "hil/falcon_sim/usbredir_frontend.h"

#include <gtest/gtest.h>
#include <usbredirparser.h>

#include <array>
#include <memory>

#include "tests/hil/falcon_model/driver.h"
#include "tests/hil/falcon_sim/socket_client.h"

namespace isotouch::falcon_sim {
namespace {

using namespace falcon_model;
using namespace std::chrono_literals;

class UsbredirFrontendTest : public testing::Test {
 protected:
  void begin(Settings settings) {
    device_ = std::make_unique<PacedDevice>(driver::running(std::move(settings)), Pace::kReal);
    frontend_ = make_usbredir_frontend(path_, *device_);
    machine_ = connect_to(path_, SOCK_STREAM);
    ASSERT_TRUE(machine_);
    parser_.reset(usbredirparser_create());
    usbredirparser& p = *parser_;
    p.priv = this;
    p.log_func = [](void*, int, const char*) {};
    p.read_func = [](void* t, std::uint8_t* data, int count) {
      const ssize_t size = ::recv(self(t).machine_.get(), data, static_cast<std::size_t>(count), MSG_DONTWAIT);
      return size > 0 ? static_cast<int>(size) : size == 0 ? -1 : 0;
    };
    p.write_func = [](void* t, std::uint8_t* data, int count) {
      return static_cast<int>(::send(self(t).machine_.get(), data, static_cast<std::size_t>(count), MSG_NOSIGNAL));
    };
    p.hello_func = [](void*, usb_redir_hello_header*) {};
    p.interface_info_func = [](void* t, usb_redir_interface_info_header* h) { self(t).interfaces_ = h->interface_count; };
    p.ep_info_func = [](void* t, usb_redir_ep_info_header* h) { self(t).endpoints_ = *h; };
    p.device_connect_func = [](void* t, usb_redir_device_connect_header* h) {
      self(t).device_header_ = *h;
      ++self(t).connects_;
    };
    p.device_disconnect_func = [](void* t) { ++self(t).disconnects_; };
    p.control_packet_func = [](void* t, std::uint64_t, usb_redir_control_packet_header* h, std::uint8_t* data, int size) {
      self(t).take(h->status, data, size);
    };
    p.bulk_packet_func = [](void* t, std::uint64_t, usb_redir_bulk_packet_header* h, std::uint8_t* data, int size) {
      self(t).take(h->status, data, size);
    };
    std::array<std::uint32_t, USB_REDIR_CAPS_SIZE> capabilities{};
    for (const int c : {usb_redir_cap_connect_device_version, usb_redir_cap_device_disconnect_ack, usb_redir_cap_ep_info_max_packet_size,
                        usb_redir_cap_64bits_ids, usb_redir_cap_32bits_bulk_length})
      usbredirparser_caps_set_cap(capabilities.data(), c);
    usbredirparser_init(&p, "test", capabilities.data(), USB_REDIR_CAPS_SIZE, 0);
    pass();
  }

  static UsbredirFrontendTest& self(void* test) { return *static_cast<UsbredirFrontendTest*>(test); }

  void take(std::uint8_t status, std::uint8_t* data, int size) {
    ++answers_;
    status_ = status;
    data_.assign(data, data + size);
    usbredirparser_free_packet_data(parser_.get(), data);
  }

  /// Both sides say what they have to say, at one moment.
  void pass() {
    for (int i = 0; i < 4; ++i) {
      while (usbredirparser_has_data_to_write(parser_.get()) > 0) ASSERT_EQ(usbredirparser_do_write(parser_.get()), 0);
      frontend_->serve(now_);
      usbredirparser_do_read(parser_.get());
    }
  }

  void bulk(std::uint8_t endpoint, Bytes data, std::uint16_t length) {
    usb_redir_bulk_packet_header header{endpoint, 0, length, 0, 0};
    usbredirparser_send_bulk_packet(parser_.get(), ++id_, &header, data.data(), static_cast<int>(data.size()));
    pass();
  }

  struct Destroy {
    void operator()(usbredirparser* parser) const { usbredirparser_destroy(parser); }
  };
  const std::filesystem::path path_ = socket_path("usbredir-frontend");
  std::unique_ptr<PacedDevice> device_;
  std::unique_ptr<Frontend> frontend_;
  Descriptor machine_;
  std::unique_ptr<usbredirparser, Destroy> parser_;
  Time now_{std::chrono::hours(12)};
  std::uint64_t id_ = 0;
  std::uint32_t interfaces_ = 0;
  usb_redir_ep_info_header endpoints_{};
  usb_redir_device_connect_header device_header_{};
  int connects_ = 0, disconnects_ = 0, answers_ = 0;
  std::uint8_t status_ = 255;
  Bytes data_;
};

TEST_F(UsbredirFrontendTest, ShowsTheDeviceAsItIs) {
  begin({});
  EXPECT_EQ(connects_, 1);
  EXPECT_EQ(interfaces_, 1U);
  EXPECT_EQ(device_header_.vendor_id, 0x0403);
  EXPECT_EQ(device_header_.product_id, 0xCB48);
  EXPECT_EQ(device_header_.device_version_bcd, 0x0600);
  EXPECT_EQ(device_header_.speed, usb_redir_speed_full);
  EXPECT_EQ(endpoints_.type[2], usb_redir_type_bulk);
  EXPECT_EQ(endpoints_.type[17], usb_redir_type_bulk);
  EXPECT_EQ(endpoints_.max_packet_size[17], 64);
  EXPECT_EQ(endpoints_.type[18], usb_redir_type_invalid);
}

TEST_F(UsbredirFrontendTest, AnswersControlRequests) {
  begin({});
  usb_redir_control_packet_header header{0x80, 6, 0x80, 0, 0x0100, 0, 18};
  usbredirparser_send_control_packet(parser_.get(), ++id_, &header, nullptr, 0);
  pass();
  EXPECT_EQ(status_, usb_redir_success);
  EXPECT_EQ(data_, device_descriptor());
  header = {0x00, 0x77, 0x40, 0, 0, 0, 0};
  usbredirparser_send_control_packet(parser_.get(), ++id_, &header, nullptr, 0);
  pass();
  EXPECT_EQ(status_, usb_redir_stall);
}

TEST_F(UsbredirFrontendTest, CarriesAPacketOutAndItsReplyBackWithTheNextFrame) {
  begin({});
  bulk(0x81, {}, 64);
  EXPECT_EQ(answers_, 0);
  bulk(0x02, driver::command({}), 16);
  EXPECT_EQ(answers_, 1);
  EXPECT_EQ(status_, usb_redir_success);
  now_ += 1ms;
  pass();
  EXPECT_EQ(answers_, 2);
  EXPECT_TRUE(driver::decode(driver::data_of(data_)).has_value());
}

TEST_F(UsbredirFrontendTest, AReadIsCancelledOnRequest) {
  begin({});
  bulk(0x81, {}, 512);
  usbredirparser_send_cancel_data_packet(parser_.get(), id_);
  pass();
  EXPECT_EQ(answers_, 1);
  EXPECT_EQ(status_, usb_redir_cancelled);
}

TEST_F(UsbredirFrontendTest, IsUnpluggedAndPluggedInAgain) {
  Settings settings;
  settings.faults = {{1, FaultKind::kUnplug, {2, 0}}};
  begin(settings);
  bulk(0x02, driver::command({}), 16);
  EXPECT_EQ(disconnects_, 1);
  for (int tries = 0; tries < 3; ++tries) {
    EXPECT_EQ(connects_, 1);
    now_ += 200ms;
    pass();
  }
  EXPECT_EQ(connects_, 2);
}

}  // namespace
}  // namespace isotouch::falcon_sim
