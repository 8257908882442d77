#include "hil/falcon_sim/socket_frontend.h"

#include <gtest/gtest.h>

#include "tests/hil/falcon_model/driver.h"
#include "tests/hil/falcon_sim/socket_client.h"

namespace isotouch::falcon_sim {
namespace {

using namespace falcon_model;
using namespace std::chrono_literals;

constexpr Time kNoon{std::chrono::hours(12)};

/// A device behind a socket with one client, in one thread: the test says when the frontend serves and what time it is.
class SocketFrontendTest : public testing::Test {
 protected:
  void begin(Settings settings, Pace pace) {
    device_.emplace(driver::running(std::move(settings)), pace);
    frontend_.emplace(path_, *device_);
    client_ = connect_to(path_, SOCK_SEQPACKET);
    ASSERT_TRUE(client_);
  }
  void say(const Bytes& message) {
    ASSERT_EQ(::send(client_.get(), message.data(), message.size(), MSG_NOSIGNAL), static_cast<ssize_t>(message.size()));
  }
  /// What the frontend says; empty when it says nothing, or has hung up.
  Bytes hear() {
    Bytes bytes(8192);
    const ssize_t size = ::recv(client_.get(), bytes.data(), bytes.size(), MSG_DONTWAIT);
    hung_up_ = size == 0;
    bytes.resize(size > 0 ? static_cast<std::size_t>(size) : 0);
    return bytes;
  }
  Bytes ask(const Bytes& message, Time now = kNoon) {
    say(message);
    frontend_->serve(now);
    return hear();
  }
  static Bytes out(const Bytes& data) {
    Bytes message{'O'};
    for (const std::uint8_t b : data) message.push_back(b);
    return message;
  }
  static Bytes in(std::uint8_t timeout_ms) { return {'I', 64, 0, timeout_ms, 0, 0, 0}; }

  const std::filesystem::path path_ = socket_path("socket-frontend");
  std::optional<PacedDevice> device_;
  std::optional<SocketFrontend> frontend_;
  Descriptor client_;
  bool hung_up_ = false;
};

TEST_F(SocketFrontendTest, AskedInLockstepItAnswersWhatTheDeviceAnswers) {
  begin({}, Pace::kLockstep);
  SimulatedFalcon twin = driver::running({});
  for (int i = 0; i < 100; ++i) {
    const Bytes packet = driver::command({10 * i, -5 * i, i});
    EXPECT_EQ(ask(out(packet)), (Bytes{'o', 0, 16, 0}));
    twin.write(packet);
    EXPECT_EQ(ask(in(100)), read_answer(kOk, twin.read(64)));
  }
  EXPECT_EQ(ask(in(100)), (Bytes{'i', 0, 0x01, 0x60}));
  EXPECT_EQ(device_->falcon().packets(), 100U);
}

TEST_F(SocketFrontendTest, RequestsSentAheadAreAnsweredInTheirOrder) {
  begin({}, Pace::kLockstep);
  say(out(driver::command({})));
  say(in(100));
  say({'D'});
  frontend_->serve(kNoon);
  EXPECT_EQ(hear()[0], 'o');
  EXPECT_EQ(hear().size(), 20U);
  EXPECT_EQ(hear()[0], 'd');
}

TEST_F(SocketFrontendTest, InRealPaceAReadWaitsForItsFrame) {
  begin({}, Pace::kReal);
  ask(out(driver::command({})), kNoon + 100us);
  EXPECT_TRUE(ask(in(100), kNoon + 200us).empty());
  EXPECT_EQ(frontend_->due(), kNoon + 1ms);
  frontend_->serve(kNoon + 999us);
  EXPECT_TRUE(hear().empty());
  frontend_->serve(kNoon + 1ms);
  EXPECT_EQ(hear().size(), 20U);
  EXPECT_EQ(frontend_->due(), std::nullopt);
}

TEST_F(SocketFrontendTest, AReadThatIsTiredOfWaitingIsTold) {
  begin({}, Pace::kReal);
  device_->falcon().control(driver::kLatency16);
  EXPECT_TRUE(ask(in(5), kNoon).empty());
  frontend_->serve(kNoon + 5ms);
  EXPECT_EQ(hear(), (Bytes{'i', 2}));
  EXPECT_TRUE(ask(in(50), kNoon + 6ms).empty());
  frontend_->serve(kNoon + 22ms);
  EXPECT_EQ(hear(), (Bytes{'i', 0, 0x01, 0x60}));
}

TEST_F(SocketFrontendTest, AnUnpluggedDeviceClosesTheDoorUntilItIsBack) {
  Settings settings;
  settings.faults = {{2, FaultKind::kUnplug, {1, 0}}};
  begin(settings, Pace::kLockstep);
  ask(out(driver::command({})));
  EXPECT_EQ(ask(out(driver::command({})))[1], kGone);
  hear();
  EXPECT_TRUE(hung_up_);
  client_ = connect_to(path_, SOCK_SEQPACKET);
  frontend_->serve(kNoon);
  hear();
  EXPECT_TRUE(hung_up_);  // refused once
  client_ = connect_to(path_, SOCK_SEQPACKET);
  EXPECT_EQ(ask({'D'})[0], 'd');
}

TEST_F(SocketFrontendTest, WhoTalksNonsenseIsDroppedAndTheNextIsLetIn) {
  begin({}, Pace::kLockstep);
  EXPECT_TRUE(ask({'X', 1, 2}).empty());
  EXPECT_TRUE(hung_up_);
  client_ = connect_to(path_, SOCK_SEQPACKET);
  EXPECT_EQ(ask({'D'})[0], 'd');
}

TEST_F(SocketFrontendTest, AClientThatLeavesWhileItWaitsMakesRoom) {
  begin({}, Pace::kReal);
  EXPECT_TRUE(ask(in(0), kNoon).empty());
  client_ = connect_to(path_, SOCK_SEQPACKET);
  frontend_->serve(kNoon);
  frontend_->serve(kNoon);
  EXPECT_EQ(ask({'D'})[0], 'd');
}

}  // namespace
}  // namespace isotouch::falcon_sim
