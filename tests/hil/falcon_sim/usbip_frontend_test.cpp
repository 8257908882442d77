/// The test plays the kernel: it has the other end of the pair.
#include "hil/falcon_sim/usbip_frontend.h"

#include <gtest/gtest.h>
#include <sys/socket.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>

#include "tests/hil/falcon_model/driver.h"

namespace isotouch::falcon_sim {
namespace {

using namespace falcon_model;
using namespace std::chrono_literals;

constexpr std::uint32_t kSubmit = 1, kUnlink = 2, kSubmitted = 3, kUnlinked = 4;
constexpr std::uint32_t kOut = 0, kIn = 1;

struct Answer {
  std::uint32_t command, number;
  std::int32_t status;
  std::uint32_t length;
  Bytes data;
};

class UsbipFrontendTest : public testing::Test {
 protected:
  void begin(Settings settings) {
    device_ = std::make_unique<PacedDevice>(driver::running(std::move(settings)), Pace::kReal);
    frontend_ = make_usbip_frontend(
        [this](Descriptor end) {
          ++plugs_;
          if (busy_) return false;
          kernel_ = std::move(end);
          return true;
        },
        *device_);
  }

  static void put(Bytes& to, std::uint32_t word) {
    for (int shift = 24; shift >= 0; shift -= 8) to.push_back(static_cast<std::uint8_t>(word >> shift & 0xFF));
  }

  std::uint32_t send(std::uint32_t command, std::uint32_t direction, std::uint32_t endpoint, std::uint32_t length,
                     std::array<std::uint8_t, 8> setup = {}, const Bytes& data = {}) {
    Bytes message;
    for (const std::uint32_t word : {command, ++number_, 0x10001U, direction, endpoint, command == kUnlink ? length : 0U,
                                     command == kSubmit ? length : 0U, 0U, 0U, 0U})
      put(message, word);
    message.insert(message.end(), setup.begin(), setup.end());
    message.insert(message.end(), data.begin(), data.end());
    EXPECT_EQ(::send(kernel_.get(), message.data(), message.size(), MSG_NOSIGNAL), static_cast<ssize_t>(message.size()));
    frontend_->serve(now_);
    return number_;
  }

  /// The next answer, if there is one.
  std::optional<Answer> answer() {
    Bytes header(48);
    const ssize_t size = ::recv(kernel_.get(), header.data(), header.size(), MSG_DONTWAIT);
    if (size <= 0) return std::nullopt;
    EXPECT_EQ(size, 48);
    const auto word = [&](std::size_t at) {
      return static_cast<std::uint32_t>(header[at]) << 24 | static_cast<std::uint32_t>(header[at + 1]) << 16 |
             static_cast<std::uint32_t>(header[at + 2]) << 8 | header[at + 3];
    };
    Answer taken{word(0), word(4), static_cast<std::int32_t>(word(20)), word(24), {}};
    if (inbound_) {
      taken.data.resize(taken.length);
      const ssize_t came = taken.length == 0 ? 0 : ::recv(kernel_.get(), taken.data.data(), taken.length, MSG_DONTWAIT);
      EXPECT_EQ(came, static_cast<ssize_t>(taken.length));
    }
    return taken;
  }

  bool hung_up() {
    std::uint8_t byte = 0;
    return ::recv(kernel_.get(), &byte, 1, MSG_DONTWAIT) == 0;
  }

  std::unique_ptr<PacedDevice> device_;
  std::unique_ptr<Frontend> frontend_;
  Descriptor kernel_;
  Time now_{std::chrono::hours(12)};
  std::uint32_t number_ = 0;
  int plugs_ = 0;
  bool busy_ = false;
  bool inbound_ = false;  ///< the answer that is waited for brings data
};

TEST_F(UsbipFrontendTest, AnswersControlRequestsBothWays) {
  begin({});
  EXPECT_EQ(plugs_, 1);
  inbound_ = true;
  const std::uint32_t asked = send(kSubmit, kIn, 0, 64, {0x80, 6, 0, 1, 0, 0, 64, 0});
  auto said = answer();
  ASSERT_TRUE(said);
  EXPECT_EQ(said->command, kSubmitted);
  EXPECT_EQ(said->number, asked);
  EXPECT_EQ(said->status, 0);
  EXPECT_EQ(said->data, device_descriptor());
  inbound_ = false;
  send(kSubmit, kOut, 0, 0, {0x00, 9, 1, 0, 0, 0, 0, 0});
  said = answer();
  ASSERT_TRUE(said);
  EXPECT_EQ(said->status, 0);
  send(kSubmit, kOut, 0, 0, {0x40, 0x77, 0, 0, 0, 0, 0, 0});
  said = answer();
  ASSERT_TRUE(said);
  EXPECT_EQ(said->status, -EPIPE);
}

TEST_F(UsbipFrontendTest, CarriesAPacketOutAndItsReplyBackWithTheNextFrame) {
  begin({});
  const std::uint32_t read = send(kSubmit, kIn, 1, 64);
  EXPECT_FALSE(answer());
  const std::uint32_t written = send(kSubmit, kOut, 2, 16, {}, driver::command({}));
  auto said = answer();
  ASSERT_TRUE(said);
  EXPECT_EQ(said->number, written);
  EXPECT_EQ(said->length, 16U);
  EXPECT_FALSE(answer());
  now_ += 1ms;
  frontend_->serve(now_);
  inbound_ = true;
  said = answer();
  ASSERT_TRUE(said);
  EXPECT_EQ(said->number, read);
  EXPECT_TRUE(driver::decode(driver::data_of(said->data)).has_value());
}

TEST_F(UsbipFrontendTest, ARequestInPiecesIsOneRequest) {
  begin({});
  Bytes whole;
  for (const std::uint32_t word : {kSubmit, 1U, 0x10001U, kOut, 2U, 0U, 16U, 0U, 0U, 0U, 0U, 0U}) put(whole, word);
  const Bytes packet = driver::command({});
  whole.insert(whole.end(), packet.begin(), packet.end());
  for (std::size_t i = 0; i < whole.size(); ++i) {
    EXPECT_FALSE(answer()) << i;
    ASSERT_EQ(::send(kernel_.get(), &whole[i], 1, MSG_NOSIGNAL), 1);
    frontend_->serve(now_);
  }
  const auto said = answer();
  ASSERT_TRUE(said);
  EXPECT_EQ(said->length, 16U);
}

TEST_F(UsbipFrontendTest, AReadThatIsTakenBackIsNotAnswered) {
  begin({});
  const std::uint32_t read = send(kSubmit, kIn, 1, 64);
  const std::uint32_t taking = send(kUnlink, kOut, 0, read);
  auto said = answer();
  ASSERT_TRUE(said);
  EXPECT_EQ(said->command, kUnlinked);
  EXPECT_EQ(said->number, taking);
  EXPECT_EQ(said->status, -ECONNRESET);
  now_ += 100ms;
  frontend_->serve(now_);
  EXPECT_FALSE(answer());
  send(kUnlink, kOut, 0, read);  // it is no longer there
  said = answer();
  ASSERT_TRUE(said);
  EXPECT_EQ(said->status, 0);
}

TEST_F(UsbipFrontendTest, GoesWhenUnpluggedAndComesBackOnceThePortIsFree) {
  Settings settings;
  settings.faults = {{1, FaultKind::kUnplug, {0, 0}}};
  begin(settings);
  send(kSubmit, kOut, 2, 16, {}, driver::command({}));
  while (answer()) {
  }
  EXPECT_TRUE(hung_up());
  busy_ = true;
  for (int i = 0; i < 5; ++i) frontend_->serve(now_ += 200ms);
  EXPECT_EQ(plugs_, 6);
  busy_ = false;
  frontend_->serve(now_ += 200ms);
  EXPECT_EQ(plugs_, 7);
  inbound_ = true;
  send(kSubmit, kIn, 0, 64, {0x80, 6, 0, 1, 0, 0, 64, 0});
  const auto said = answer();
  ASSERT_TRUE(said);
  EXPECT_EQ(said->data, device_descriptor());
}

TEST_F(UsbipFrontendTest, WhatIsNoRequestStartsThePortAnew) {
  for (const Bytes& nonsense : {Bytes(48, 0xEE), [] {
                                  Bytes huge;
                                  for (const std::uint32_t word : {kSubmit, 1U, 0U, kOut, 2U, 0U, 0xFFFFFFFFU, 0U, 0U, 0U, 0U, 0U})
                                    put(huge, word);
                                  return huge;
                                }()}) {
    plugs_ = 0;
    begin({});
    ASSERT_EQ(::send(kernel_.get(), nonsense.data(), nonsense.size(), MSG_NOSIGNAL), 48);
    frontend_->serve(now_);
    EXPECT_TRUE(hung_up());
    frontend_->serve(now_ + 1s);
    EXPECT_EQ(plugs_, 2);
  }
}

TEST(VhciPort, SaysPortSocketDeviceAndSpeed) {
  const auto folder = std::filesystem::path(testing::TempDir()) / "vhci-port";
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "attach").flush();
  std::array<int, 2> ends{};
  ASSERT_EQ(::socketpair(AF_UNIX, SOCK_STREAM, 0, ends.data()), 0);
  const Descriptor ours(ends[0]);
  EXPECT_TRUE(vhci_port(folder)(Descriptor(ends[1])));
  std::string line;
  std::getline(std::ifstream(folder / "attach"), line);
  EXPECT_EQ(line, "0 " + std::to_string(ends[1]) + " 65537 2");
  std::filesystem::remove_all(folder);
}

TEST(VhciPort, WithoutTheModuleASentenceSaysWhatToDo) {
  try {
    vhci_port("/nowhere/vhci_hcd.0")(Descriptor());
    FAIL() << "attached to nothing";
  } catch (const std::runtime_error& e) {
    EXPECT_EQ(std::string(e.what()),
              "/nowhere/vhci_hcd.0/attach: No such file or directory; load the kernel's module vhci_hcd, and be root");
  }
}

}  // namespace
}  // namespace isotouch::falcon_sim
